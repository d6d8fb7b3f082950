// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/runs/body_story.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/csv_file.h"

namespace cvo::reports {
namespace {

using LabelCounts = std::map<std::int64_t, int>;

// Returns for each cluster of a frame the number of its landmarks by body.
std::map<std::int64_t, LabelCounts> BodiesOfClusters(
    const std::vector<LabelledLandmark>& landmarks) {
  std::map<std::int64_t, LabelCounts> bodies;
  for (const LabelledLandmark& landmark : landmarks) {
    if (landmark.assigned > 0 && landmark.truth_body >= 0) {
      ++bodies[landmark.assigned][landmark.truth_body];
    }
  }
  return bodies;
}

// Returns the first label with the highest count; -1 if there is none.
std::int64_t MostOf(const LabelCounts& counts) {
  const auto most =
      std::max_element(counts.begin(), counts.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == counts.end() ? -1 : most->first;
}

int Total(const LabelCounts& counts) {
  return std::accumulate(counts.begin(), counts.end(), 0,
                         [](int sum, const auto& count) { return sum + count.second; });
}

LabelContest ContestOf(const std::vector<LabelledLandmark>& landmarks, int body,
                       std::int64_t cluster) {
  LabelContest contest;
  if (cluster < 0) return contest;
  LabelCounts wrong;
  for (const LabelledLandmark& landmark : landmarks) {
    if (landmark.truth_body == body && landmark.inferred != cluster) ++wrong[landmark.inferred];
  }
  contest.wrong = Total(wrong);
  contest.label = MostOf(wrong);
  for (const LabelledLandmark& landmark : landmarks) {
    if (landmark.truth_body != body || landmark.inferred != contest.label ||
        landmark.second != cluster || contest.wrong == 0) {
      continue;
    }
    ++contest.told;
    for (std::size_t i = 0; i < 3; ++i) {
      contest.energies[i] += landmark.energies[i];
      contest.true_energies[i] += landmark.second_energies[i];
    }
  }
  for (std::size_t i = 0; i < 3 && contest.told > 0; ++i) {
    contest.energies[i] /= contest.told;
    contest.true_energies[i] /= contest.told;
  }
  return contest;
}

// Returns the stage in a frame in which the body is judged.
BodyStage StageOf(const BodyFrame& frame, const BodyDetail& body) {
  if (frame.error_m) {
    if (*frame.error_m <= kGoodError_m) return BodyStage::kGood;
    if (frame.other_body >= 0) return BodyStage::kJoined;
    if (frame.Labelled(body.cluster) < kLeastLandmarks) return BodyStage::kNoLandmarks;
    constexpr int kManyStrangers = 4;  // one in this many
    const int all = frame.strangers + frame.Labelled(body.cluster);
    return frame.strangers * kManyStrangers > all ? BodyStage::kLabel : BodyStage::kMotion;
  }
  if (frame.Seen() < kLeastLandmarks) return BodyStage::kNoLandmarks;
  if (frame.cluster >= 0 && frame.Labelled(frame.cluster) >= kLeastLandmarks) {
    if (frame.cluster == body.cluster && frame.reported) return BodyStage::kMotion;
    if (!frame.reported) return BodyStage::kUnconfirmed;
    return BodyStage::kIdentity;
  }
  if (frame.other_body >= 0) return BodyStage::kJoined;
  if (frame.cluster < 0 && frame.detected && !*frame.detected) return BodyStage::kNoDetection;
  return BodyStage::kLabel;
}

void CountLandmarks(const std::vector<LabelledLandmark>& landmarks, const BodyDetail& body,
                    BodyFrame& frame) {
  for (const LabelledLandmark& landmark : landmarks) {
    if (landmark.truth_body == body.id) ++frame.landmarks[landmark.assigned];
  }
  const std::map<std::int64_t, LabelCounts> clusters = BodiesOfClusters(landmarks);
  int most = 0;
  for (const auto& [id, bodies] : clusters) {
    const int on_it = frame.Labelled(id);
    if (MostOf(bodies) != body.id || on_it <= most) continue;
    most = on_it;
    frame.cluster = id;
  }
  const auto scored = clusters.find(body.cluster);
  if (scored != clusters.end()) {
    frame.strangers = Total(scored->second) - frame.Labelled(body.cluster);
  }
  // The holder is the scored cluster if it is estimated, else the cluster with most of the body's
  // landmarks.
  LabelCounts of_clusters = frame.landmarks;
  std::erase_if(of_clusters, [](const auto& count) { return count.first <= 0; });
  const std::int64_t holder = frame.error_m ? body.cluster : MostOf(of_clusters);
  const auto held = clusters.find(holder);
  if (held == clusters.end()) return;
  const std::int64_t shown = MostOf(held->second);
  const bool enough = frame.error_m || 2 * frame.Labelled(holder) > frame.Seen();
  if (shown > 0 && shown != body.id && enough) frame.other_body = shown;
}

}  // namespace

std::string_view StageName(BodyStage stage) {
  switch (stage) {
    case BodyStage::kHidden:
      return "not judged";
    case BodyStage::kGood:
      return "good";
    case BodyStage::kNoDetection:
      return "detection missing";
    case BodyStage::kNoLandmarks:
      return "no landmarks";
    case BodyStage::kLabel:
      return "label wrong";
    case BodyStage::kJoined:
      return "merged into another body";
    case BodyStage::kUnconfirmed:
      return "not confirmed yet";
    case BodyStage::kIdentity:
      return "under another id";
    case BodyStage::kMotion:
      return "motion wrong";
  }
  return "";
}

int BodyFrame::Seen() const { return Total(landmarks); }

int BodyFrame::Labelled(std::int64_t id) const {
  const auto found = landmarks.find(id);
  return found == landmarks.end() ? 0 : found->second;
}

int BodyStory::Count(BodyStage stage) const {
  return static_cast<int>(std::count_if(frames.begin(), frames.end(),
                                        [&](const auto& frame) { return frame.stage == stage; }));
}

int BodyStory::Judged() const {
  return static_cast<int>(frames.size()) - Count(BodyStage::kHidden);
}

BodyStage BodyStory::Cause() const {
  BodyStage cause = BodyStage::kGood;
  int most = 0;
  for (const BodyStage stage : kWrongStages) {
    const int count = Count(stage);
    if (count <= most) continue;
    most = count;
    cause = stage;
  }
  return cause;
}

LandmarksByFrame ReadLabelledLandmarks(const std::filesystem::path& file) {
  const CsvFile csv(file);
  if (!csv.Has("second")) {
    ThrowError(file.string(), "no column \"second\"", "landmarks.csv of this version of run");
  }
  const std::size_t frame = csv.Column("frame");
  const std::size_t assigned = csv.Column("cluster");
  const std::size_t inferred = csv.Column("inferred");
  const std::size_t energies = csv.Columns({"energy_2d", "energy_3d", "energy_motion"});
  const std::size_t second = csv.Columns({"second", "second_2d", "second_3d", "second_motion"});
  const std::size_t body = csv.Column("truth_body");
  LandmarksByFrame landmarks;
  const auto label = [&](std::size_t row, std::size_t column) {
    return csv.Empty(row, column) ? std::int64_t{-1} : csv.Id(row, column);
  };
  for (std::size_t i = 0; i < csv.rows(); ++i) {
    landmarks[csv.Integer(i, frame)].push_back(
        {label(i, assigned), label(i, inferred), csv.Numbers<3>(i, energies), label(i, second),
         csv.Numbers<3>(i, second + 1), csv.Empty(i, body) ? -1 : csv.Integer(i, body)});
  }
  return landmarks;
}

BodyStory TellStory(const RunDetail& run, const BodyDetail& body, const LandmarksByFrame& landmarks,
                    const Detected& detected) {
  static const std::vector<LabelledLandmark> kNone;
  std::set<std::pair<int, std::int64_t>> reported;
  for (const ClusterRow& row : run.clusters) {
    if (!row.predicted) reported.emplace(row.frame, row.id);
  }
  std::map<int, double> errors_m;
  for (const BodyPosition& position : body.estimated) errors_m[position.frame] = position.error_m;
  BodyStory story;
  story.body = body;
  for (const auto& [number, pose] : body.truth) {
    BodyFrame frame;
    frame.frame = number;
    const auto seen = landmarks.find(number);
    const std::vector<LabelledLandmark>& labelled = seen == landmarks.end() ? kNone : seen->second;
    const auto error = errors_m.find(number);
    if (error != errors_m.end()) frame.error_m = error->second;
    const auto shown = detected.find(number);
    if (shown != detected.end()) frame.detected = shown->second;
    CountLandmarks(labelled, body, frame);
    frame.reported = reported.contains({number, frame.cluster});
    const bool judged = std::binary_search(body.visible.begin(), body.visible.end(), number);
    if (judged) frame.stage = StageOf(frame, body);
    frame.contest = ContestOf(labelled, body.id, frame.cluster);
    story.frames.push_back(std::move(frame));
  }
  story.events = FindEvents(story);
  return story;
}

const BodyFrame& FrameOf(const BodyStory& story, int frame) {
  const BodyFrame* found = FindBy(story.frames, &BodyFrame::frame, frame);
  Require(found != nullptr, "FrameOf: a frame of the story");
  return *found;
}

}  // namespace cvo::reports
