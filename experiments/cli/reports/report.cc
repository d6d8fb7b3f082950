// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/reports/report.h"

#include <iostream>
#include <memory>
#include <utility>

#include "core/base/error.h"
#include "experiments/cli/command.h"
#include "experiments/cli/output_file.h"
#include "experiments/cli/output_place.h"
#include "experiments/cli/pictures/report_images.h"
#include "experiments/cli/reports/report_runs.h"
#include "experiments/cli/reports/suite_table.h"
#include "experiments/cli/scratch_folder.h"
#include "reports/page/page_html.h"
#include "variants/registry.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

// Absolute path that ends in the folder's own name, also for "results/ci/" and ".".
fs::path Named(const std::string& folder) {
  fs::path path = fs::absolute(folder).lexically_normal();
  return path.has_filename() ? path : path.parent_path();
}

void LeaveOutImages(reports::PageContent& content) {
  for (reports::PageScene& scene : content.scenes) {
    if (scene.wants_images) scene.no_images = "left out by --no-images";
  }
}

}  // namespace

int WriteRunsReport(const ReportFlags& flags) {
  const ScratchFolder scratch;
  MakeSuiteOfRuns(flags.runs, scratch.path());
  ReportFlags of_suite = flags;
  of_suite.folder = scratch.path().string();
  return WriteReport(of_suite);
}

int WriteReport(const ReportFlags& flags) {
  const fs::path folder = Named(flags.folder);
  CheckNoCollection(flags.folder);
  reports::PageRequest request;
  request.folder = folder;
  if (!flags.against.empty()) request.against = Named(flags.against);
  if (!flags.against.empty() && !fs::exists(request.against / "plan.json")) {
    throw UsageError(
        StrCat("--against ", flags.against, ": found no plan.json, expected a suite's folder"));
  }
  request.default_options = DefaultOptions();
  request.images_of_all = !flags.runs.empty();
  for (const VariantInfo& variant : Variants()) {
    request.variants.emplace_back(variant.name, variant.changes);
  }
  reports::PageContent content = reports::ReadPage(request);
  const fs::path out = flags.out.empty() ? fs::path(flags.folder) / "report" : fs::path(flags.out);
  std::vector<std::string> names = {"index.html"};
  if (flags.all_images) names.emplace_back("images/");
  std::vector<fs::path> read = {folder, request.against};
  read.insert(read.end(), flags.runs.begin(), flags.runs.end());
  const OutputFolder output = OpenOutput(out, names, read);
  if (flags.no_images) {
    LeaveOutImages(content);
  } else {
    AddSceneImages(folder, flags.every, content);
  }
  if (flags.all_images) WriteAllImages(folder, out, content);
  WriteFilesAtomically(out, {{"index.html", reports::PageHtml(content)}});
  std::cout << "written: " << (out / "index.html").string() << '\n';
  for (const std::string& problem : content.problems) std::cerr << "missing: " << problem << '\n';
  return content.problems.empty() ? 0 : 1;
}

Command AddReportCommand(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("report", "Write the results of a suite as a single HTML page");
  const auto flags = std::make_shared<ReportFlags>();
  app->add_option("DIR", flags->runs,
                  "output folder of a suite, or the output folders of runs on one sequence, which "
                  "are shown side by side")
      ->type_name("")
      ->required();
  app->add_option("-o,--output", flags->out,
                  "output folder for index.html; default: DIR/report; required for runs")
      ->type_name("OUT");
  app->add_option("--against", flags->against, "second output folder of the suite to compare with")
      ->type_name("DIR");
  CLI::Option* every =
      app->add_option("--every", flags->every,
                      "include images of every K-th frame; default: as many as fit")
          ->type_name("K")
          ->check(CLI::Range(1, 1000000).description(""));
  CLI::Option* none =
      app->add_flag("--no-images", flags->no_images, "write the page without images");
  none->excludes(every);
  app->add_flag("--all-images", flags->all_images,
                "also write OUT/images: every drawable frame of every run, as JPEG")
      ->excludes(none);
  app->footer(
      "The page is self-contained and works offline. It lists what is missing or failed.\nExit "
      "code 1 if a whole section of the page could not be made.\n"
      "Examples:\n"
      "  clustervo report results/ablation\n"
      "  clustervo report results/room_2d results/room_full -o page");
  return {app, [flags] {
            const fs::path first = flags->runs.front();
            if (flags->runs.size() == 1 && !fs::exists(first / "result.json")) {
              flags->folder = std::exchange(flags->runs, {}).front();
              return WriteReport(*flags);
            }
            if (flags->out.empty()) throw UsageError("--output is required for runs");
            return WriteRunsReport(*flags);
          }};
}

}  // namespace cvo
