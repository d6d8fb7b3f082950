// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/json/json_record.h"
#include "core/files/json/options_json.h"
#include "core/files/text/closest_names.h"
#include "core/record/run_summary.h"
#include "experiments/cli/command.h"
#include "experiments/cli/reports/reports.h"
#include "experiments/runner/given.h"
#include "experiments/runner/run_job.h"
#include "reports/runs/body_story.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

struct ExplainFlags {
  std::string run;
  std::string body;
  std::string sequence;
};

// Everything that is read from the run.
struct ExplainedRun {
  reports::OverlayRun run;
  std::optional<Sequence> sequence;  // with the detections of the run
  std::map<int, reports::Detected> detected;

  reports::BodyStory Story(const reports::BodyDetail& body) const {
    const auto known = detected.find(body.id);
    return reports::TellStory(run.detail, body, run.landmarks,
                              known == detected.end() ? reports::Detected() : known->second);
  }
};

// For each body, whether a detection shows it, by frame. Empty if the run's boxes or the true boxes
// are not known.
std::map<int, reports::Detected> DetectedBodies(const std::optional<Sequence>& sequence,
                                                const std::vector<std::string>& classes) {
  std::map<int, reports::Detected> detected;
  if (!sequence) return detected;
  const std::unique_ptr<BodyTruthReader> truth = ReadBodyTruth(*sequence);
  if (!truth) return detected;
  const TrueBoxes true_boxes = BoxesOfBodies(*sequence, *truth);
  const auto detections = DetectionsOf(*sequence, classes);
  for (std::size_t i = 0; i < detections.size(); ++i) {
    const std::vector<BodyId> shown = BodiesOfDetections(detections[i], true_boxes.at(i));
    const int number = sequence->first_frame + static_cast<int>(i);
    for (const TruthBody& body : truth->objects().bodies) {
      detected[body.id][number] =
          std::find(shown.begin(), shown.end(), BodyId{body.id}) != shown.end();
    }
  }
  return detected;
}

ExplainedRun ReadExplained(const ExplainFlags& flags) {
  const fs::path folder = flags.run;
  if (!fs::exists(folder / "result.json")) {
    ThrowError(flags.run, "no result.json", "the output folder of clustervo run");
  }
  if (!fs::exists(folder / "landmarks.csv")) {
    ThrowError(flags.run, "no landmarks.csv", "a run with --landmarks");
  }
  ExplainedRun read;
  read.run = reports::ReadOverlayRun(folder, reports::LandmarkLabel::kCluster);
  if (!read.run.missing.empty()) throw Error(read.run.missing.front());
  if (read.run.detail.bodies.empty()) {
    ThrowError(flags.run, "no ground truth of bodies", "a run on a sequence that has it");
  }
  read.sequence = FindDetections(flags.sequence, read.run);
  // Boxes of another camera are a few pixels off, which does not change the body they are assigned
  // to.
  read.detected = DetectedBodies(read.sequence, read.run.classes);
  if (!read.sequence && read.run.sequence.detections > 0) {
    PrintNotice(
        "note: the run's detection file was not found, so missed detections cannot be told");
  }
  return read;
}

// A number is that of a track of the labels: "1", "track1" and "track 1" are the same body.
const reports::BodyDetail& FindBodyNamed(const std::string& name,
                                         const std::vector<reports::BodyDetail>& bodies) {
  std::vector<std::string> names;
  for (const reports::BodyDetail& body : bodies) {
    std::string joined = body.name;
    std::erase(joined, ' ');
    if (body.name == name || joined == name || joined == "track" + name) return body;
    names.push_back(body.name);
  }
  ThrowError("BODY", Quoted(name) + DidYouMean(name, names), "one of " + Joined(names, ", "));
}

// Prints one line per body, those with the most wrong frames first.
void PrintBodies(const ExplainedRun& read) {
  std::vector<reports::BodyStory> stories;
  for (const reports::BodyDetail& body : read.run.detail.bodies) {
    stories.push_back(read.Story(body));
  }
  const auto wrong = [](const reports::BodyStory& story) {
    return story.Judged() - story.Count(reports::BodyStage::kGood);
  };
  std::stable_sort(stories.begin(), stories.end(),
                   [&](const auto& a, const auto& b) { return wrong(a) > wrong(b); });
  TextTable table({"body", "class", "moves", "judged", "within 10 cm", "mostly"});
  for (const reports::BodyStory& story : stories) {
    table.Add({story.body.name, story.body.category, story.body.mover ? "yes" : "no",
               StrCat(story.Judged()), StrCat(story.Count(reports::BodyStage::kGood)),
               std::string(reports::StageName(story.Cause()))});
  }
  table.Print(std::cout);
}

int ExplainBody(const ExplainFlags& flags, const ExplainedRun& read) {
  const reports::BodyDetail& body = FindBodyNamed(flags.body, read.run.detail.bodies);
  const reports::BodyStory story = read.Story(body);
  for (const std::string& line : reports::StoryLines(story)) std::cout << line << '\n';
  std::cout << '\n';
  TextTable table({"frames", "stage", "error, cm", "detected", "landmarks at first"});
  for (const reports::TimelineRow& row : reports::TimelineOf(story, read.run.detail.bodies)) {
    table.Add({row.frames, row.stage, row.error_cm, row.detected, row.landmarks});
  }
  table.Print(std::cout);
  return 0;
}

int Explain(const ExplainFlags& flags) {
  const ExplainedRun read = ReadExplained(flags);
  if (!flags.body.empty()) return ExplainBody(flags, read);
  PrintBodies(read);
  return 0;
}

}  // namespace

Command AddExplainCommand(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("explain",
                             "Explain why a run lost or misplaced a body: which stage failed, in "
                             "which frames, and how its landmarks were labelled");
  const auto flags = std::make_shared<ExplainFlags>();
  const FlagAdder add{*app};
  add("RUN", flags->run, "", "output folder of clustervo run --landmarks")->required();
  add("BODY", flags->body, "",
      "name of a ground-truth body, or number of its track; default: list all bodies");
  add("--sequence", flags->sequence, "FOLDER", "folder of the images, if they have moved since");
  app->footer(
      "Stages: detection missing, no landmarks, label wrong, merged into another body, not "
      "confirmed\nyet, under another id (than the cluster that is scored), motion wrong (the "
      "landmarks are right).\nIn every judged frame, the first stage that applies is counted.\n"
      "Examples:\n"
      "  clustervo explain results/indoor_1\n"
      "  clustervo explain results/indoor_1 ball_1");
  return {app, [flags] { return Explain(*flags); }};
}

}  // namespace cvo
