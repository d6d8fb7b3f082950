// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/runs/run_detail.h"

namespace cvo::reports {

// A row of landmarks.csv. A label is the id of a cluster, 0 for the static scene, -1 for none.
struct LabelledLandmark {
  std::int64_t assigned = -1;
  std::int64_t inferred = -1;
  std::array<double, 3> energies{};  // of the inferred label, nats: 2D box, 3D affinity, motion
  std::int64_t second = -1;          // label with the lowest energy of the others
  std::array<double, 3> second_energies{};
  int truth_body = -1;
};
using LandmarksByFrame = std::map<int, std::vector<LabelledLandmark>>;

// Throws Error for a damaged file, and for one of an older version without the second label.
LandmarksByFrame ReadLabelledLandmarks(const std::filesystem::path& file);

// What is wrong with a body in a frame: the first stage of the estimator at which it goes wrong.
enum class BodyStage {
  kHidden,       // not judged
  kGood,         // estimated, within kGoodError_m
  kNoDetection,  // no cluster tracks it and no detection shows it
  kNoLandmarks,  // fewer than kLeastLandmarks landmarks on it
  kLabel,        // its landmarks are labelled as static, as outliers or as several bodies
  kJoined,       // its landmarks are in a cluster that is mostly on another body
  kUnconfirmed,  // a cluster has its landmarks but is not reported yet
  kIdentity,     // a cluster has its landmarks, but not the scored one
  kMotion,       // its cluster has the right landmarks but the pose is wrong
};
inline constexpr std::array kWrongStages = {
    BodyStage::kNoDetection, BodyStage::kNoLandmarks, BodyStage::kLabel, BodyStage::kJoined,
    BodyStage::kUnconfirmed, BodyStage::kIdentity,    BodyStage::kMotion};
inline constexpr double kGoodError_m = 0.1;
inline constexpr int kLeastLandmarks = 3;

// Returns the name of a stage, such as "detection missing".
std::string_view StageName(BodyStage stage);

// Landmarks on the body that were inferred to be part of something else, although a cluster tracked
// it.
struct LabelContest {
  int wrong = 0;
  std::int64_t label = -1;                // label that most of them got
  int told = 0;                           // number of those with known energies of the true label
  std::array<double, 3> energies{};       // means over these, of `label`
  std::array<double, 3> true_energies{};  // means over these, of the true label
};

struct BodyFrame {
  int frame = 0;
  BodyStage stage = BodyStage::kHidden;
  std::optional<double> error_m;          // of the scored estimate
  std::optional<bool> detected;           // empty: unknown
  std::map<std::int64_t, int> landmarks;  // number on the body, by label
  // The cluster that tracks the body: of those mostly on it, the one with most of its landmarks;
  // -1: none.
  std::int64_t cluster = -1;
  bool reported = false;  // whether that cluster is reported
  // Another body that the scored cluster, or the one with this body's landmarks, is mostly on; -1:
  // none.
  std::int64_t other_body = -1;
  int strangers = 0;  // landmarks of the scored cluster that are on something else
  LabelContest contest;

  int Seen() const;                     // number of landmarks on the body
  int Labelled(std::int64_t id) const;  // number of those with label `id`
};

struct BodyEvent {
  int frame = 0;
  std::string what;  // "first estimated", "lost", ...
};

struct BodyStory {
  BodyDetail body;
  std::vector<BodyFrame> frames;  // in which the body has truth
  std::vector<BodyEvent> events;  // most important ones, by frame

  int Count(BodyStage stage) const;
  int Judged() const;  // number of judged frames
  // Returns the wrong stage that most frames are in; kGood if there are none.
  BodyStage Cause() const;
};

// Whether a detection shows the body, by frame, for the frames in which this is known.
using Detected = std::map<int, bool>;

BodyStory TellStory(const RunDetail& run, const BodyDetail& body, const LandmarksByFrame& landmarks,
                    const Detected& detected);

// Returns the frames to look at: the first estimate, the longest losses and errors, the recoveries
// from these losses, the first merge into another body, and the worst error.
std::vector<BodyEvent> FindEvents(const BodyStory& story);

const BodyFrame& FrameOf(const BodyStory& story, int frame);

}  // namespace cvo::reports
