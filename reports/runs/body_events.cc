// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/number.h"
#include "reports/runs/body_story.h"

namespace cvo::reports {
namespace {

enum class State { kGood, kWrong, kLost };

State StateOf(const BodyFrame& frame) {
  if (!frame.error_m) return State::kLost;
  return frame.stage == BodyStage::kGood ? State::kGood : State::kWrong;
}

// Consecutive judged frames in the same state.
struct Stretch {
  State state = State::kGood;
  std::vector<const BodyFrame*> frames;
};

std::vector<Stretch> StretchesOf(const BodyStory& story) {
  std::vector<Stretch> stretches;
  for (const BodyFrame& frame : story.frames) {
    if (frame.stage == BodyStage::kHidden) continue;
    const State state = StateOf(frame);
    if (stretches.empty() || stretches.back().state != state) stretches.push_back({state, {}});
    stretches.back().frames.push_back(&frame);
  }
  return stretches;
}

// Returns the wrong stage that most of its frames are in.
BodyStage CauseOf(const Stretch& stretch) {
  BodyStory part;
  for (const BodyFrame* frame : stretch.frames) part.frames.push_back(*frame);
  return part.Cause();
}

// Returns the indices of the `most` longest stretches that are not good, longest first.
std::vector<std::size_t> Longest(const std::vector<Stretch>& stretches, std::size_t most) {
  std::vector<std::size_t> bad;
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    if (stretches[i].state != State::kGood) bad.push_back(i);
  }
  std::stable_sort(bad.begin(), bad.end(), [&](std::size_t a, std::size_t b) {
    return stretches[a].frames.size() > stretches[b].frames.size();
  });
  bad.resize(std::min(bad.size(), most));
  return bad;
}

void AddEvent(int frame, const std::string& what, std::vector<BodyEvent>& events) {
  BodyEvent& event = FindOrAdd(events, &BodyEvent::frame, {frame, what});
  if (event.what.find(what) == std::string::npos) event.what += ", " + what;
}

void AddStretch(const std::vector<Stretch>& stretches, std::size_t i,
                std::vector<BodyEvent>& events) {
  const Stretch& stretch = stretches[i];
  const bool begins = i == 0 && stretch.state == State::kLost;
  const std::string what = stretch.state == State::kWrong ? "off by more than 10 cm"
                           : begins                       ? "visible, not estimated"
                                                          : "lost";
  const BodyStage cause = CauseOf(stretch);
  const auto shows = std::find_if(stretch.frames.begin(), stretch.frames.end(),
                                  [cause](const auto* frame) { return frame->stage == cause; });
  AddEvent((*shows)->frame,
           StrCat(what, " for ", Counted(stretch.frames.size(), "frame"), " from ",
                  stretch.frames.front()->frame, " on: ", StageName(cause)),
           events);
  if (i + 1 < stretches.size() && stretch.state == State::kLost && !begins) {
    AddEvent(stretches[i + 1].frames.front()->frame, "found again", events);
  }
}

void AddWorst(const BodyStory& story, std::vector<BodyEvent>& events) {
  const BodyFrame* worst = nullptr;
  for (const BodyFrame& frame : story.frames) {
    if (frame.stage == BodyStage::kHidden || !frame.error_m) continue;
    if (worst == nullptr || *frame.error_m > *worst->error_m) worst = &frame;
  }
  if (worst == nullptr) return;
  AddEvent(worst->frame, StrCat("worst error, ", FormatGeneral(100.0 * *worst->error_m, 3), " cm"),
           events);
}

}  // namespace

std::vector<BodyEvent> FindEvents(const BodyStory& story) {
  constexpr std::size_t kMost = 3;
  const std::vector<Stretch> stretches = StretchesOf(story);
  std::vector<BodyEvent> events;
  for (const Stretch& stretch : stretches) {
    if (stretch.state == State::kLost) continue;
    AddEvent(stretch.frames.front()->frame, "first estimated", events);
    break;
  }
  for (const std::size_t i : Longest(stretches, kMost)) AddStretch(stretches, i, events);
  const auto joined = std::find_if(story.frames.begin(), story.frames.end(), [](const auto& frame) {
    return frame.stage == BodyStage::kJoined;
  });
  if (joined != story.frames.end()) AddEvent(joined->frame, "merged into another body", events);
  AddWorst(story, events);
  std::stable_sort(events.begin(), events.end(),
                   [](const auto& a, const auto& b) { return a.frame < b.frame; });
  return events;
}

}  // namespace cvo::reports
