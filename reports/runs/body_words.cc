// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/runs/body_words.h"

#include <algorithm>
#include <numeric>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/number.h"

namespace cvo::reports {
namespace {

std::string LabelName(std::int64_t label) {
  if (label > 0) return StrCat("cluster ", label);
  return label == 0 ? "static" : "outliers";
}

std::string BodyName(std::int64_t id, const std::vector<BodyDetail>& bodies) {
  const BodyDetail* found = FindBy(bodies, &BodyDetail::id, id);
  return found == nullptr ? StrCat("body ", id) : found->name;
}

std::string LandmarksLine(const BodyStory& story, const BodyFrame& frame) {
  std::vector<std::pair<std::int64_t, int>> counts(frame.landmarks.begin(), frame.landmarks.end());
  std::stable_sort(counts.begin(), counts.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::string line = StrCat(frame.Seen(), " landmarks on it");
  const char* before = ": ";
  for (const auto& [label, count] : counts) {
    line += StrCat(before, count, " ", LabelName(label));
    if (label == story.body.cluster) line += " (its own)";
    before = ", ";
  }
  return line;
}

std::string ErrorText(const BodyFrame& frame) {
  if (!frame.error_m) return "not estimated";
  return FormatGeneral(100.0 * *frame.error_m, 3) + " cm off";
}

std::string StateLine(const BodyStory& story, const BodyFrame& frame,
                      const std::vector<BodyDetail>& bodies) {
  std::string line = ErrorText(frame);
  if (frame.stage == BodyStage::kHidden) line += "; hidden: not judged";
  if (frame.detected) line += *frame.detected ? "; detected" : "; not detected";
  if (frame.strangers > 0) {
    line += StrCat("; ", frame.strangers, " of cluster ", story.body.cluster, " on other things");
  }
  if (frame.other_body > 0) {
    line += StrCat("; its cluster is mostly on ", BodyName(frame.other_body, bodies));
  }
  return line;
}

double Sum(const std::array<double, 3>& energies) {
  return std::accumulate(energies.begin(), energies.end(), 0.0);
}

std::string SumText(const std::array<double, 3>& energies) {
  const auto text = [](double nats) { return FormatFixed(nats, 1); };
  return StrCat(text(energies[0]), " + ", text(energies[1]), " + ", text(energies[2]), " = ",
                text(Sum(energies)));
}

// Returns the term that favours the winning label most, or the neighbours if that label has the
// higher energy.
std::string DecidedBy(const LabelContest& contest) {
  constexpr std::array kTerms = {"the 2D boxes decide", "the 3D positions decide",
                                 "the motion decides"};
  if (Sum(contest.true_energies) < Sum(contest.energies)) return "the neighbours' labels decide";
  std::size_t most = 0;
  const auto gap = [&](std::size_t i) { return contest.true_energies[i] - contest.energies[i]; };
  for (std::size_t i = 1; i < 3; ++i) {
    if (gap(i) > gap(most)) most = i;
  }
  return kTerms[most];
}

std::vector<std::string> ContestLines(const BodyFrame& frame) {
  const LabelContest& contest = frame.contest;
  if (contest.wrong == 0) return {};
  const std::string own = LabelName(frame.cluster);
  const std::string won = LabelName(contest.label);
  std::string first = StrCat(contest.wrong, " not inferred as ", own, ", most of them ", won);
  if (contest.told == 0) {
    return {first + StrCat("; ", own, " is second best for none of these")};
  }
  return {first,
          StrCat("2D + 3D + motion, nats: ", won, " ", SumText(contest.energies), ", ", own, " ",
                 SumText(contest.true_energies)),
          StrCat("mean of ", contest.told, ": ", DecidedBy(contest))};
}

std::string Advice(BodyStage cause) {
  switch (cause) {
    case BodyStage::kNoDetection:
      return "the detector missed it while no cluster tracked it";
    case BodyStage::kNoLandmarks:
      return "too few landmarks are seen on it";
    case BodyStage::kLabel:
      return "its landmarks are labelled as something else";
    case BodyStage::kJoined:
      return "its landmarks are in the cluster of another body";
    case BodyStage::kUnconfirmed:
      return "its cluster waits for a second detection";
    case BodyStage::kIdentity:
      return "a cluster other than the one that is scored tracks it";
    case BodyStage::kMotion:
      return "its landmarks have the right label, but its pose is wrong";
    case BodyStage::kHidden:
    case BodyStage::kGood:
      break;
  }
  return "nothing is wrong with it";
}

}  // namespace

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
  const BodyStage cause = story.Cause();
  lines.push_back(cause == BodyStage::kGood ? Advice(cause)
                                            : StrCat(StageName(cause), ": ", Advice(cause)));
  return lines;
}

std::vector<std::string> FrameLines(const BodyStory& story, const BodyFrame& frame,
                                    const std::vector<BodyDetail>& bodies) {
  std::vector<std::string> lines = {StateLine(story, frame, bodies), LandmarksLine(story, frame)};
  for (std::string& line : ContestLines(frame)) lines.push_back(std::move(line));
  return lines;
}

}  // namespace cvo::reports
