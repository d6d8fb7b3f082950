// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/runs/run_detail.h"

namespace cvo::reports {

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

  int Seen() const;                     // number of landmarks on the body
  int Labelled(std::int64_t id) const;  // number of those with label `id`
};

struct BodyStory {
  BodyDetail body;
  std::vector<BodyFrame> frames;  // in which the body has truth

  int Count(BodyStage stage) const;
  int Judged() const;  // number of judged frames
  // Returns the wrong stage that most frames are in; kGood if there are none.
  BodyStage Cause() const;
};

// Whether a detection shows the body, by frame, for the frames in which this is known.
using Detected = std::map<int, bool>;

BodyStory TellStory(const RunDetail& run, const BodyDetail& body, const LandmarksByFrame& landmarks,
                    const Detected& detected);

// Describes what happened to the body as a whole: the number of frames by stage, the cause, and the
// worst error.
std::vector<std::string> StoryLines(const BodyStory& story);

// Successive judged frames in the same stage, in words.
struct TimelineRow {
  std::string frames;  // "5-13"
  std::string stage;
  std::string error_cm;   // "1.2 to 13.6"; "-": not estimated
  std::string detected;   // "8 of 9"; empty: unknown
  std::string landmarks;  // in the first of the frames, by label
};

// `bodies` provides the names of other bodies.
std::vector<TimelineRow> TimelineOf(const BodyStory& story, const std::vector<BodyDetail>& bodies);

}  // namespace cvo::reports
