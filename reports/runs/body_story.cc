// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/runs/body_story.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>
#include <span>
#include <utility>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"

namespace cvo::reports {
namespace {

using LabelCounts = std::map<std::int64_t, int>;

// Returns for each cluster of a frame the number of its landmarks by body.
std::map<std::int64_t, LabelCounts> BodiesOfClusters(
    const std::vector<LabelledLandmark>& landmarks) {
  std::map<std::int64_t, LabelCounts> bodies;
  for (const LabelledLandmark& landmark : landmarks) {
    if (landmark.label > 0 && landmark.truth_body >= 0) {
      ++bodies[landmark.label][landmark.truth_body];
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
    if (landmark.truth_body == body.id) ++frame.landmarks[landmark.label];
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

// "12 landmarks: 8 cluster 7, 3 cluster 1, 1 static", and what else its cluster is on.
std::string LandmarkWords(const BodyStory& story, const BodyFrame& frame,
                          const std::vector<BodyDetail>& bodies) {
  std::vector<std::pair<std::int64_t, int>> counts(frame.landmarks.begin(), frame.landmarks.end());
  std::stable_sort(counts.begin(), counts.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::string words = StrCat(frame.Seen());
  const char* before = ": ";
  for (const auto& [label, count] : counts) {
    words += StrCat(before, count, " ",
                    label > 0               ? StrCat("cluster ", label)
                    : label == kStaticLabel ? "static"
                                            : "outliers");
    if (label == story.body.cluster) words += " (its own)";
    before = ", ";
  }
  if (frame.other_body > 0) {
    const BodyDetail* other = FindBy(bodies, &BodyDetail::id, frame.other_body);
    words += "; its cluster is mostly on " +
             (other == nullptr ? StrCat("body ", frame.other_body) : other->name);
  } else if (frame.strangers > 0) {
    words += StrCat("; ", frame.strangers, " of cluster ", story.body.cluster, " on other things");
  }
  return words;
}

std::string ErrorRange(std::span<const BodyFrame> stretch) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const BodyFrame& frame : stretch) {
    if (!frame.error_m) continue;
    low = std::min(low, 100.0 * *frame.error_m);
    high = std::max(high, 100.0 * *frame.error_m);
  }
  if (high < low) return "-";
  const std::string most = FormatGeneral(high, 3);
  const std::string least = FormatGeneral(low, 3);
  return least == most ? most : least + " to " + most;
}

std::string DetectedShare(std::span<const BodyFrame> stretch) {
  int known = 0;
  int shown = 0;
  for (const BodyFrame& frame : stretch) {
    known += frame.detected ? 1 : 0;
    shown += frame.detected.value_or(false) ? 1 : 0;
  }
  return known == 0 ? "" : StrCat(shown, " of ", known);
}

struct StageText {
  const char* name;
  const char* meaning;
};

// In the order of BodyStage.
constexpr std::array<StageText, 9> kStageTexts = {
    {{"not judged", ""},
     {"good", "nothing is wrong with it"},
     {"detection missing", "the detector missed it while no cluster tracked it"},
     {"no landmarks", "too few landmarks are seen on it"},
     {"label wrong", "its landmarks are labelled as something else"},
     {"merged into another body", "its landmarks are in the cluster of another body"},
     {"not confirmed yet", "its cluster waits for a second detection"},
     {"under another id", "a cluster other than the one that is scored tracks it"},
     {"motion wrong", "its landmarks have the right label, but its pose is wrong"}}};

const StageText& TextOf(BodyStage stage) { return kStageTexts[static_cast<std::size_t>(stage)]; }

}  // namespace

std::string_view StageName(BodyStage stage) { return TextOf(stage).name; }

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

BodyStory TellStory(const RunDetail& run, const BodyDetail& body, const LandmarksByFrame& landmarks,
                    const Detected& detected) {
  static const std::vector<LabelledLandmark> kNone;
  std::set<std::pair<int, std::int64_t>> reported;
  for (const ObjectRow& row : run.clusters) {
    if (!row.predicted()) reported.emplace(row.frame, row.id);
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
    story.frames.push_back(std::move(frame));
  }
  return story;
}

std::vector<std::string> StoryLines(const BodyStory& story) {
  const BodyDetail& body = story.body;
  std::vector<std::string> lines;
  lines.push_back(StrCat(body.name, " (", body.category, body.mover ? ", moves" : ", stands",
                         body.cluster > 0 ? StrCat(", cluster ", body.cluster) : ", no cluster",
                         "): ", story.Count(BodyStage::kGood), " of ",
                         Counted(story.Judged(), "judged frame"), " within 10 cm"));
  std::string wrong;
  for (const BodyStage stage : kWrongStages) {
    if (story.Count(stage) == 0) continue;
    wrong += StrCat(wrong.empty() ? "" : ", ", StageName(stage), " ", story.Count(stage));
  }
  if (!wrong.empty()) lines.push_back("frames by failed stage: " + wrong);
  const auto worst = std::max_element(
      story.frames.begin(), story.frames.end(),
      [](const BodyFrame& a, const BodyFrame& b) { return a.error_m < b.error_m; });
  if (worst != story.frames.end() && worst->error_m) {
    lines.push_back(StrCat("worst error: ", FormatGeneral(100.0 * *worst->error_m, 3),
                           " cm in frame ", worst->frame));
  }
  const BodyStage cause = story.Cause();
  const std::string meaning = TextOf(cause).meaning;
  lines.push_back(cause == BodyStage::kGood ? meaning : StrCat(StageName(cause), ": ", meaning));
  return lines;
}

std::vector<TimelineRow> TimelineOf(const BodyStory& story, const std::vector<BodyDetail>& bodies) {
  std::vector<TimelineRow> rows;
  const auto& frames = story.frames;
  for (auto first = frames.begin(); first != frames.end();) {
    const auto last = std::find_if(first, frames.end(), [&](const BodyFrame& frame) {
      return frame.stage != first->stage || frame.frame - first->frame != &frame - &*first;
    });
    if (first->stage != BodyStage::kHidden) {
      const std::span<const BodyFrame> stretch(first, last);
      TimelineRow row;
      row.frames = StrCat(stretch.front().frame);
      if (stretch.size() > 1) row.frames += StrCat("-", stretch.back().frame);
      row.stage = StageName(first->stage);
      row.error_cm = ErrorRange(stretch);
      row.detected = DetectedShare(stretch);
      row.landmarks = LandmarkWords(story, *first, bodies);
      rows.push_back(std::move(row));
    }
    first = last;
  }
  return rows;
}

}  // namespace cvo::reports
