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

// A row of landmarks.csv. Labels are ids of clusters, 0 the static scene, -1 none.
struct LabelledLandmark {
  std::int64_t assigned = -1;
  std::int64_t inferred = -1;
  std::array<double, 3> energies{};  // of the inferred label, nats: 2D box, 3D affinity, motion
  std::int64_t second = -1;          // of the others the one with the least energy
  std::array<double, 3> second_energies{};
  int truth_body = -1;
};
using LandmarksByFrame = std::map<int, std::vector<LabelledLandmark>>;

// Throws Error; also for a file of an older version, without the second label.
LandmarksByFrame ReadLabelledLandmarks(const std::filesystem::path& file);

// What is wrong with a body in a frame, the first stage of the estimator at which it goes wrong.
enum class BodyStage {
  kHidden,       // not judged
  kGood,         // estimated, within kGoodError_m
  kNoDetection,  // no cluster has it, and no detection shows it
  kNoLandmarks,  // fewer than kLeastLandmarks of what is seen of it
  kLabel,        // its landmarks are labelled as static, as outliers or as several bodies
  kJoined,       // its landmarks are a cluster's that is mostly on another body
  kUnconfirmed,  // a cluster has its landmarks, and is not reported yet
  kIdentity,     // a cluster has its landmarks, but not the one that is scored
  kMotion,       // its cluster's landmarks are right and the pose is not
};
inline constexpr std::array kWrongStages = {
    BodyStage::kNoDetection, BodyStage::kNoLandmarks, BodyStage::kLabel, BodyStage::kJoined,
    BodyStage::kUnconfirmed, BodyStage::kIdentity,    BodyStage::kMotion};
inline constexpr double kGoodError_m = 0.1;
inline constexpr int kLeastLandmarks = 3;

// "detection missing" etc.
std::string_view StageName(BodyStage stage);

// Landmarks on the body that were inferred to be something else, while a cluster had it.
struct LabelContest {
  int wrong = 0;
  std::int64_t label = -1;           // that most of them got
  int told = 0;                      // of these: where the energies of the true label are known
  std::array<double, 3> energies{};  // their means
  std::array<double, 3> true_energies{};  // of the true label
};

struct BodyFrame {
  int frame = 0;
  BodyStage stage = BodyStage::kHidden;
  std::optional<double> error_m;          // of the estimate that is scored
  std::optional<bool> detected;           // empty: not known
  std::map<std::int64_t, int> landmarks;  // on the body, by label
  std::int64_t cluster = -1;  // that has it: of those mostly on it, the one with most; -1: none
  bool reported = false;      // this cluster
  std::int64_t other_body =
      -1;             // that the scored cluster, or that with its landmarks, is mostly on
  int strangers = 0;  // landmarks of the scored cluster that are on something else
  LabelContest contest;

  int Seen() const;                     // landmarks on the body
  int Labelled(std::int64_t id) const;  // of them
};

struct BodyEvent {
  int frame = 0;
  std::string what;  // "first estimated", "lost", ...
};

struct BodyStory {
  BodyDetail body;
  std::vector<BodyFrame> frames;  // in which the body has truth
  std::vector<BodyEvent> events;  // by frame, those that matter most

  int Count(BodyStage stage) const;
  int Judged() const;  // frames
  // Of all that is wrong what is so in most frames; kGood where nothing is.
  BodyStage Cause() const;
};

// Frames in which a detection shows the body, and the frames in which this is known.
using Detected = std::map<int, bool>;

BodyStory TellStory(const RunDetail& run, const BodyDetail& body, const LandmarksByFrame& landmarks,
                    const Detected& detected);

// The frames to look at: when it was first estimated, the longest losses and errors and what came
// after them, the first join, and the worst error.
std::vector<BodyEvent> FindEvents(const BodyStory& story);

const BodyFrame& FrameOf(const BodyStory& story, int frame);

}  // namespace cvo::reports
