// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <iostream>
#include <memory>
#include <set>
#include <utility>

#include "core/base/error.h"
#include "core/files/atomic_file.h"
#include "core/files/json/json_record.h"
#include "core/files/text/closest_names.h"
#include "core/record/metric_catalogue.h"
#include "core/record/suite_runs.h"
#include "experiments/cli/command.h"
#include "experiments/cli/reports/reports.h"
#include "reports/figures/figure_style.h"
#include "reports/overlays/draw_overlay.h"
#include "reports/overlays/picture_files.h"
#include "reports/page/page.h"
#include "variants/registry.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

// ---- Runs that are no suite

// Metrics of the table, if any of the runs has them.
constexpr std::array<const char*, 8> kTableMetrics = {
    "camera_ate",      "camera_trpe_1_frame", "object_ate",       "object_success_10cm",
    "object_coverage", "object_id_switches",  "moving_precision", "moving_recall"};

std::vector<reports::RunSummary> ReadAll(const std::vector<std::string>& folders) {
  std::vector<reports::RunSummary> runs;
  for (const std::string& folder : folders) {
    const fs::path file = fs::path(folder) / "result.json";
    if (!fs::exists(file)) {
      ThrowError(folder, "no result.json", "the output folder of a run, as the others");
    }
    runs.push_back(reports::ReadRun(file, reports::AllMetricNames()));
    const std::string& sequence = runs.back().sequence.name;
    if (sequence != runs.front().sequence.name) {
      ThrowError(folder, "a run of " + sequence, "one of " + runs.front().sequence.name);
    }
  }
  return runs;
}

std::vector<std::string> MetricsOf(const std::vector<reports::RunSummary>& runs) {
  std::vector<std::string> metrics;
  for (const char* name : kTableMetrics) {
    const bool any = std::any_of(runs.begin(), runs.end(), [&](const auto& run) {
      return reports::FindMetric(run, name) != nullptr;
    });
    if (any) metrics.emplace_back(name);
  }
  return metrics;
}

reports::PlanJob JobOf(const reports::RunSummary& run) {
  reports::PlanJob job;
  job.sequence = run.sequence.name;
  job.variant = run.variant;
  if (run.system) {
    job.system = run.variant.substr(reports::SystemVariant("").size());
    job.variant.clear();
  }
  job.seed = run.seed;
  job.oracle = run.given.value("oracle", std::vector<std::string>());
  job.frames = run.sequence.frames;
  job.job = run.job;
  return job;
}

// Makes `folder` look like the output folder of a suite of these runs, which must be on one
// sequence. Throws Error for a folder without a run, for runs on different sequences and for a run
// given twice.
void MakeSuiteOfRuns(const std::vector<std::string>& folders, const fs::path& folder) {
  const std::vector<reports::RunSummary> runs = ReadAll(folders);
  std::vector<std::string> variants;
  for (const reports::RunSummary& run : runs) variants.push_back(run.variant);
  const std::vector<std::string> names = UniqueNames(variants, folders);
  reports::PlanFile plan;
  plan.suite.name = "Runs on " + runs.front().sequence.name;
  plan.build = runs.front().build.identity;
  plan.table.metrics = MetricsOf(runs);
  plan.table.reference = names.front();
  if (names != variants) {
    plan.table.rows = {"variant", "run"};
    plan.table.reference = "run=" + names.front();
  }
  fs::create_directories(folder / "jobs");
  std::set<std::string> jobs;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!jobs.insert(runs[i].job).second) ThrowError(folders[i], "the same run twice", "each once");
    plan.jobs.push_back(JobOf(runs[i]));
    if (names != variants) plan.jobs.back().parameters["run"] = names[i];
    fs::create_directory_symlink(fs::absolute(folders[i]), folder / "jobs" / runs[i].job);
  }
  WriteFilesAtomically(folder, {{"plan.json", FileText(plan)}});
}

// ---- Images

constexpr std::size_t kMaxPageBytes = 14'500'000;
constexpr std::size_t kMaxImageBytes = 4'500'000;   // all images of a page, 6 MB in base64
constexpr std::size_t kMinBytes = 1'000'000;        // left for images even if runs are long
constexpr std::size_t kTypicalImageBytes = 12'000;  // one image
constexpr int kWidth = 320;                         // of those in the page
constexpr int kQuality = 60;
constexpr std::size_t kMinFrames = 8;
constexpr std::size_t kMaxFrames = 150;

// Drops scenes from the end until there is room for images. Returns the number of bytes for images.
std::size_t MakeRoom(reports::PageContent& content) {
  constexpr std::size_t kMinBase64 = kMinBytes / 3 * 4;
  std::size_t size = reports::PageHtml(content).size();
  while (size + kMinBase64 > kMaxPageBytes && content.scenes.size() > 1) {
    content.scenes.pop_back();
    ++content.scenes_left_out;
    size = reports::PageHtml(content).size();
  }
  if (size + kMinBase64 > kMaxPageBytes) return kMinBytes;
  return std::min(kMaxImageBytes, (kMaxPageBytes - size) / 4 * 3);
}

std::size_t NumberOfImages(std::size_t most_bytes, int every, std::size_t frames) {
  if (every > 0) return std::max<std::size_t>(1, frames / static_cast<std::size_t>(every));
  return std::clamp(most_bytes / kTypicalImageBytes, kMinFrames, kMaxFrames);
}

// Draws on the images of a run that is shown. Returns why that is impossible; empty: it is not.
std::string DrawScene(
    const fs::path& run_folder,
    const std::function<void(const reports::OverlayRun&, const RunImages&)>& draw) {
  try {
    if (!fs::exists(run_folder / "landmarks.csv")) {
      return "the run has no landmarks.csv, so its images are not shown";
    }
    reports::OverlayRun run = reports::ReadOverlayRun(run_folder, reports::LandmarkLabel::kCluster);
    AddDetections("", run);
    draw(run, RunImages(run, ""));
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

fs::path RunFolder(const fs::path& folder, const reports::PageScene& scene,
                   const reports::PageContent& content) {
  return folder / "jobs" / content.runs[scene.run].run.planned.job;
}

// Adds to each scene that wants images the drawn left images of every `every`-th frame; 0: of as
// many as fit into the page. Removes scenes from the end of a page that leaves no room for images.
void AddSceneImages(const fs::path& folder, int every, reports::PageContent& content) {
  const std::size_t most_bytes = MakeRoom(content);
  const auto wanting =
      static_cast<std::size_t>(std::count_if(content.scenes.begin(), content.scenes.end(),
                                             [](const auto& scene) { return scene.wants_images; }));
  for (reports::PageScene& scene : content.scenes) {
    if (!scene.wants_images) continue;
    const auto draw = [&](const reports::OverlayRun& run, const RunImages& images) {
      const reports::CameraInfo& camera = run.sequence.camera;
      const reports::OverlayStyle style =
          reports::StyleFor(camera, std::min(kWidth, camera.width_px));
      const std::size_t frames = run.detail.camera.size();
      for (const std::size_t i :
           reports::EvenlySpaced(frames, NumberOfImages(most_bytes / wanting, every, frames))) {
        const int number = run.detail.camera[i].frame;
        const cv::Mat image = images.Left(number);
        if (image.empty()) continue;
        const reports::OverlayFrame frame = reports::FrameOf(run, number);
        const cv::Mat drawn = reports::DrawOverlay(image, frame, camera, style);
        scene.images.push_back(
            {number, reports::JpegBytes(drawn, kQuality), reports::StatusText(frame)});
      }
      for (const std::string& line : run.missing) {
        scene.detail.missing.push_back("images: " + line);
      }
    };
    scene.no_images = DrawScene(RunFolder(folder, scene, content), draw);
    if (scene.images.empty() && scene.no_images.empty()) {
      scene.no_images = "none of the run's images can be read";
    }
  }
}

// ---- The page

// Absolute path that ends in the folder's own name, also for "results/ci/" and ".".
fs::path Named(const std::string& folder) {
  fs::path path = fs::absolute(folder).lexically_normal();
  return path.has_filename() ? path : path.parent_path();
}

reports::PageRequest RequestOf(const ReportFlags& flags) {
  reports::PageRequest request;
  request.folder = Named(flags.folder);
  if (!flags.against.empty()) {
    request.against = Named(flags.against);
    if (!fs::exists(request.against / "plan.json")) {
      throw UsageError(
          StrCat("--against ", flags.against, ": found no plan.json, expected a suite's folder"));
    }
  }
  request.default_options = DefaultOptions();
  request.images_of_all = !flags.runs.empty();
  for (const VariantInfo& variant : Variants()) {
    request.variants.emplace_back(variant.name, variant.changes);
  }
  return request;
}

int WriteRunsReport(const ReportFlags& flags) {
  const ScratchFolder scratch;
  MakeSuiteOfRuns(flags.runs, scratch.path());
  ReportFlags of_suite = flags;
  of_suite.folder = scratch.path().string();
  return WriteReport(of_suite);
}

}  // namespace

int WriteReport(const ReportFlags& flags) {
  CheckNoCollection(flags.folder);
  const reports::PageRequest request = RequestOf(flags);
  reports::PageContent content = reports::ReadPage(request);
  const fs::path out = flags.out.empty() ? fs::path(flags.folder) / "report" : fs::path(flags.out);
  std::vector<fs::path> read = {request.folder, request.against};
  read.insert(read.end(), flags.runs.begin(), flags.runs.end());
  const OutputFolder output = OpenOutput(out, {"index.html"}, read);
  if (!flags.no_images) {
    AddSceneImages(request.folder, flags.every, content);
  } else {
    for (reports::PageScene& scene : content.scenes) {
      if (scene.wants_images) scene.no_images = "left out by --no-images";
    }
  }
  WriteFilesAtomically(out, {{"index.html", reports::PageHtml(content)}});
  std::cout << "written: " << (out / "index.html").string() << '\n';
  for (const std::string& problem : content.problems) std::cerr << "missing: " << problem << '\n';
  return content.problems.empty() ? 0 : 1;
}

Command AddReportCommand(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("report", "Write the results of a suite as a single HTML page");
  const FlagAdder add{*app};
  const auto flags = std::make_shared<ReportFlags>();
  add("DIR", flags->runs, "",
      "output folder of a suite, or the output folders of runs on one sequence, which "
      "are shown side by side")
      ->required();
  add("-o,--output", flags->out, "OUT",
      "output folder for index.html; default: DIR/report; required for runs");
  add("--against", flags->against, "DIR", "second output folder of the suite to compare with");
  CLI::Option* every = add("--every", flags->every, "K",
                           "include images of every K-th frame; default: as many as fit")
                           ->check(Within(1, 1000000));
  CLI::Option* none =
      app->add_flag("--no-images", flags->no_images, "write the page without images");
  none->excludes(every);
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
