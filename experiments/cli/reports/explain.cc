// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/reports/explain.h"

#include <algorithm>
#include <iostream>
#include <memory>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/closest_names.h"
#include "core/files/text_file.h"
#include "experiments/cli/command.h"
#include "experiments/cli/output_file.h"
#include "experiments/cli/run/run_flags.h"
#include "experiments/cli/run/text_table.h"
#include "experiments/cli/stop_signal.h"
#include "experiments/runner/oracle.h"
#include "reports/overlays/body_sheet.h"
#include "reports/overlays/encode.h"
#include "reports/runs/body_words.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

struct ExplainFlags {
  std::string run;
  std::string body;
  std::string output;
  std::string sequence;
  BoxSources boxes;
  bool oracles = false;
  int threads = 1;
  bool quiet = false;
};

// Everything that is read from the run.
struct ExplainedRun {
  reports::OverlayRun run;
  reports::LandmarksByFrame landmarks;
  std::optional<Sequence> sequence;  // with the detections of the run
  std::map<int, reports::Detected> detected;

  reports::BodyStory Story(const reports::BodyDetail& body) const {
    const auto known = detected.find(body.id);
    return reports::TellStory(run.detail, body, landmarks,
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
  OracleSwitches boxes;
  boxes.boxes = true;
  const Oracle oracle(*sequence, boxes, truth.get());
  const auto detections = DetectionsOf(*sequence, classes);
  for (std::size_t i = 0; i < detections.size(); ++i) {
    StereoFrame frame;
    frame.detections = detections[i];
    oracle.Give(static_cast<int>(i), {}, frame);
    const int number = sequence->first_frame + static_cast<int>(i);
    for (const TruthBody& body : truth->objects().bodies) {
      const auto& shown = frame.given.detection_body;
      detected[body.id][number] =
          std::find(shown.begin(), shown.end(), BodyId{body.id}) != shown.end();
    }
  }
  return detected;
}

// The true boxes of a body, by frame. Empty if its sequence or the true boxes are missing.
std::map<int, reports::PixelBox> TrueBoxesOf(const ExplainFlags& flags, const ExplainedRun& read,
                                             int body) {
  std::map<int, reports::PixelBox> found;
  const auto sequence = FindLabelled(flags.sequence, read.run, flags.boxes.labels);
  const auto truth = sequence ? ReadBodyTruth(*sequence) : nullptr;
  if (!truth) return found;
  const TrueBoxes boxes = BoxesOfBodies(*sequence, *truth);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (const auto& [id, box] : boxes[i]) {
      if (id != body) continue;
      found[sequence->first_frame + static_cast<int>(i)] = {box.left_px, box.top_px, box.right_px,
                                                            box.bottom_px};
    }
  }
  return found;
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
  read.landmarks = reports::ReadLabelledLandmarks(folder / "landmarks.csv");
  read.run = reports::ReadOverlayRun(folder, reports::LandmarkLabel::kCluster);
  for (const std::string& line : read.run.missing) std::cerr << "clustervo: " << line << '\n';
  if (read.run.detail.bodies.empty()) {
    ThrowError(flags.run, "no ground truth of bodies", "a run on a sequence that has it");
  }
  read.sequence = FindDetections(flags.sequence, read.run, flags.boxes);
  // Boxes of another camera are a few pixels off, which does not change the body they are assigned
  // to.
  read.detected = DetectedBodies(read.sequence, read.run.classes);
  AdoptDetections(read.sequence, read.run);
  if (!read.sequence && read.run.sequence.detections > 0) {
    std::cerr << "clustervo: note: missed detections cannot be shown without the run's detection "
                 "file: give --detections, --detections-camera and --min-score as in the run\n";
  }
  return read;
}

const reports::BodyDetail& FindBodyNamed(const std::string& name,
                                         const std::vector<reports::BodyDetail>& bodies) {
  std::vector<std::string> names;
  for (const reports::BodyDetail& body : bodies) {
    if (body.name == name || StrCat(body.id) == name) return body;
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

std::vector<std::string> OracleLines(const std::vector<OracleResult>& results) {
  std::vector<std::string> lines;
  const OracleResult* best = &results.front();
  for (const OracleResult& result : results) {
    lines.push_back(
        StrCat(result.oracle, ": ", result.good, " of ", result.judged,
               " frames within 10 cm, estimated in ", result.estimated,
               result.ate_m ? StrCat(", ATE ", ReadableNumber(*result.ate_m), " m") : ""));
    if (result.good > best->good) best = &result;
  }
  const int wrong = results.front().judged - results.front().good;
  const int repaired = best->good - results.front().good;
  if (wrong == 0) return lines;
  lines.push_back(repaired == 0
                      ? "none of them repairs it"
                      : StrCat(best->oracle, best->oracle.ends_with('s') ? " help" : " helps",
                               " most: ", repaired, " of ", wrong, " frames repaired"));
  return lines;
}

void PrintEvents(const reports::BodyStory& story, const std::vector<reports::BodyDetail>& bodies) {
  for (const reports::BodyEvent& event : story.events) {
    std::cout << "\nframe " << event.frame << ": " << event.what << '\n';
    for (const std::string& line :
         reports::FrameLines(story, reports::FrameOf(story, event.frame), bodies)) {
      std::cout << "  " << line << '\n';
    }
  }
}

int ExplainBody(const ExplainFlags& flags, const ExplainedRun& read) {
  const reports::BodyDetail& body = FindBodyNamed(flags.body, read.run.detail.bodies);
  const reports::BodyStory story = read.Story(body);
  std::vector<std::string> lines = reports::StoryLines(story);
  if (flags.oracles) {
    if (!read.sequence) {
      ThrowError("--oracles", "no detection file of the run", "--detections FILE");
    }
    const auto results = TryOracles(flags.run, *read.sequence, body.id, flags.threads, flags.quiet);
    if (!results) return kStopped;
    std::vector<OracleResult> all = {ResultOf("as run", body)};
    all.insert(all.end(), results->begin(), results->end());
    for (std::string& line : OracleLines(all)) lines.push_back(std::move(line));
  }
  for (const std::string& line : lines) std::cout << line << '\n';
  PrintEvents(story, read.run.detail.bodies);
  if (flags.output.empty()) return 0;
  const RunImages images(read.run, flags.sequence);
  lines.front() = StrCat(read.run.sequence.name, ", ", read.run.variant, ": ", lines.front());
  const cv::Mat sheet =
      reports::BodySheet(read.run, story, lines, TrueBoxesOf(flags, read, body.id),
                         [&](int frame) { return images.Left(frame); });
  WriteOutputFile(flags.output, reports::PngBytes(sheet), {flags.run});
  std::cout << "\nwritten: " << flags.output << '\n';
  return 0;
}

int Explain(const ExplainFlags& flags) {
  if (!flags.output.empty()) {
    if (fs::path(flags.output).extension() != ".png") {
      throw UsageError(StrCat("-o ", flags.output, ": expected a name that ends in .png"));
    }
    CheckOutputFile(flags.output, {flags.run});
  }
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
  const auto add = [app](const char* flag, auto& value, const char* kind, const char* meaning) {
    return app->add_option(flag, value, meaning)->type_name(kind);
  };
  add("RUN", flags->run, "", "output folder of clustervo run --landmarks")->required();
  CLI::Option* body = add("BODY", flags->body, "",
                          "name or number of a ground-truth body; default: list all bodies");
  add("-o,--output", flags->output, "FILE",
      "also write a PNG: a timeline of the failed stage in each frame, and image crops of the "
      "frames in which the body was found, lost, merged or worst estimated")
      ->needs(body);
  app->add_flag("--oracles", flags->oracles,
                "rerun the sequence with true boxes, true labels and the true camera in turn, and "
                "report which of them repairs the body")
      ->needs(body);
  add("--sequence", flags->sequence, "FOLDER", "folder of the images, if they have moved since");
  add("--detections", flags->boxes.detections, "FILE",
      "detection file of the run, if it is not in the sequence's folder");
  add("--detections-camera", flags->boxes.detections_camera, "X",
      "camera (image_0X) in which these were detected");
  add("--min-score", flags->boxes.min_score, "SCORE", "--min-score of the run")
      ->check(FiniteProblem);
  add("--labels", flags->boxes.labels, "FILE",
      "label file of the run, if it is not in the sequence's folder");
  AddThreads(*app, flags->threads);
  AddQuiet(*app, flags->quiet);
  app->footer(
      "Stages: detection missing, no landmarks, label wrong, merged into another body, not "
      "confirmed\nyet, under another id (than the cluster that is scored), motion wrong (the "
      "landmarks are right).\nIn every judged frame, the first stage that applies is counted.\n"
      "Examples:\n"
      "  clustervo explain results/indoor_1\n"
      "  clustervo explain results/indoor_1 ball_1 -o ball_1.png --oracles");
  return {app, [flags] { return Explain(*flags); }};
}

}  // namespace cvo
