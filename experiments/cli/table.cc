// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/error.h"
#include "experiments/cli/command.h"
#include "experiments/cli/progress.h"
#include "experiments/cli/run_flags.h"
#include "experiments/cli/sequence_flags.h"
#include "experiments/cli/stop_signal.h"
#include "experiments/files/atomic_file.h"
#include "experiments/record/build_identity.h"
#include "experiments/runner/run_job.h"
#include "reports/tables/make_table.h"
#include "reports/tables/run_summary.h"
#include "reports/tables/table_json.h"
#include "reports/tables/table_text.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

constexpr int kIncomplete = 1;
constexpr int kStopped = 130;

struct TableFlags {
  std::vector<std::string> folders;
  std::vector<std::string> variants = {"static"};
  std::string detections;
  std::string output;
  std::optional<double> right_shift_px;
  RunFlags run;
};

// The folder's result is of this very job and complete.
bool IsDone(const fs::path& folder, const std::string& job) {
  if (!fs::exists(folder / "result.json")) return false;
  try {
    const reports::RunSummary run = reports::ReadRun(folder / "result.json");
    return run.job == job && run.status != "failed";
  } catch (const Error&) {
    return false;  // half-written by something else: made anew
  }
}

// Runs one sequence with one variant unless its result is there already; false where the user
// stopped it. Throws Error for a run that failed.
bool RunCell(const fs::path& folder, const RunRequest& request, bool quiet) {
  if (IsDone(folder, IdentifyJob(request))) {
    std::cerr << folder.filename().string() << ": up to date\n";
    return true;
  }
  if (!quiet) std::cerr << folder.filename().string() << '\n';
  const OutputFolder output(folder, RunFileNames());
  Progress progress(request.sequence.images.size(), quiet);
  RunRequest shown = request;
  shown.progress = [&progress](std::size_t done) { progress.Report(done); };
  const auto outcome = RunJob(shown, output.path());
  if (outcome && outcome->run.status == RunStatus::kFailed) throw Error(outcome->run.message);
  return outcome.has_value();
}

std::vector<FoundSequence> FindAll(const std::vector<std::string>& folders) {
  std::vector<FoundSequence> found;
  for (const std::string& folder : folders) {
    const std::vector<FoundSequence> below = FindSequences(folder);
    if (below.empty()) ThrowError(folder, "no sequence", "a folder with KITTI sequences below it");
    found.insert(found.end(), below.begin(), below.end());
  }
  return found;
}

void WriteTable(const TableFlags& flags, const reports::Table& table) {
  WriteFilesAtomically(flags.output, {{"table.md", reports::TableMarkdown(table)},
                                      {"table.json", reports::TableJson(table)}});
  std::cout << reports::TableText(table, isatty(STDOUT_FILENO) != 0)
            << "\nwritten: " << (fs::path(flags.output) / "table.json").string() << '\n';
}

int MakeTable(const TableFlags& flags) {
  RequireRecordedCpu(ThisBuild());
  const Options options = flags.run.Resolve();
  std::vector<const VariantInfo*> variants;
  for (const std::string& name : flags.variants) variants.push_back(&FindVariant(name));
  const OutputFolder output(flags.output, {"table.json", "table.md"});

  reports::TableRequest request{"camera trajectory", reports::CameraMetrics(), flags.output, {}};
  if (!flags.detections.empty()) {
    request.title = "moving bodies";
    request.metrics = reports::ObjectMetrics();
  }
  const StopSignal stop;
  for (const FoundSequence& found : FindAll(flags.folders)) {
    for (const VariantInfo* variant : variants) {
      std::string name = found.folder.filename().string();
      try {
        const Sequence sequence = OpenSequence({.folder = found.folder,
                                                .type = found.type,
                                                .detections_file = flags.detections,
                                                .right_shift_px = flags.right_shift_px});
        name = sequence.name;
        const fs::path folder = output.path() / StrCat(name, "-", variant->name);
        const bool done = RunCell(folder,
                                  {.sequence = sequence,
                                   .variant = *variant,
                                   .options = options,
                                   .threads = flags.run.threads,
                                   .stop = [&stop] { return stop.Requested(); }},
                                  flags.run.quiet);
        if (!done) {
          std::cerr << "clustervo: stopped; what is done is kept\n";
          return kStopped;
        }
        request.entries.push_back({name, folder / "result.json", ""});
      } catch (const Error& error) {
        std::cerr << "clustervo: " << name << ": " << error.what() << '\n';
        request.entries.push_back({name, "", error.what()});
      }
    }
  }
  const reports::Table table = reports::MakeTable(request, reports::ShippedReference());
  WriteTable(flags, table);
  return reports::IsComplete(table) ? 0 : kIncomplete;
}

}  // namespace

Command AddTableCommand(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "table", "Run all sequences below folders, and print and write the table of their errors");
  const auto flags = std::make_shared<TableFlags>();
  app->add_option("FOLDER", flags->folders, "folders with KITTI sequences below them")
      ->type_name("")
      ->required();
  const auto add = [app](const char* flag, auto& value, const char* kind, const char* meaning) {
    return app->add_option(flag, value, meaning)->type_name(kind);
  };
  add("-o,--output", flags->output, "FOLDER", "for table.json, table.md and one folder per run")
      ->required();
  add("--detections", flags->detections, "LEVEL",
      "of synthetic scenes (oracle, good, poor), or labels: the table is of the moving bodies");
  add("--variant", flags->variants, "NAME", "estimators; default: static");
  AddRightShift(*app, flags->right_shift_px);
  flags->run.AddTo(*app);
  app->footer(
      "A result that is there and of the same build, options and input is not computed again.\n"
      "Example: clustervo table kitti_raw kitti_odometry -o results/table");
  return {app, [flags] { return MakeTable(*flags); }};
}

}  // namespace cvo
