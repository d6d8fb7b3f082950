// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/suite/run_collection.h"

#include <algorithm>
#include <iostream>
#include <map>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/json/json_record.h"
#include "core/files/text/number.h"
#include "experiments/cli/output_file.h"
#include "experiments/cli/output_place.h"
#include "experiments/cli/pictures/overlay.h"
#include "experiments/cli/reports/report.h"
#include "experiments/cli/reports/suite_table.h"
#include "experiments/cli/run/known_names.h"
#include "experiments/cli/stop_signal.h"
#include "experiments/suite/parse_suite.h"
#include "reports/page/collection_html.h"
#include "reports/results/suite_runs.h"
#include "reports/results/timing.h"
#include "reports/runs/suite_times.h"
#include "reports/tables/make_table.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

// Frames per second of the runs of a variant, in suites with timed_threads only: runs of other
// suites share the machine and may read features from the cache.
struct Speed {
  std::vector<double> frames_per_s;
  int threads = 1;
  std::string cpu;
};

void AddSpeeds(const fs::path& folder, std::map<std::string, Speed>& speeds) {
  for (const reports::PlannedRun& run : reports::ReadPlan(folder / "plan.json").runs) {
    const fs::path file = folder / "jobs" / run.job / "timing.json";
    if (run.job.empty() || run.system || !fs::exists(file)) continue;
    const auto timing = ReadRecord<reports::TimingData>(file);
    Speed& speed = speeds[run.variant];
    speed.frames_per_s.push_back(timing.frames_per_second);
    speed.threads = timing.threads;
    speed.cpu = timing.cpu;
  }
}

std::string SpeedText(Speed speed) {
  if (speed.frames_per_s.empty()) return "not run";
  std::sort(speed.frames_per_s.begin(), speed.frames_per_s.end());
  const double median = speed.frames_per_s[speed.frames_per_s.size() / 2];
  return StrCat(FormatFixed(median, 1), " (", FormatFixed(speed.frames_per_s.front(), 1), " to ",
                FormatFixed(speed.frames_per_s.back(), 1), " in ",
                Counted(speed.frames_per_s.size(), "run"), ", ",
                Counted(static_cast<std::size_t>(speed.threads), "thread"), " of ", speed.cpu, ")");
}

class CollectionRun {
 public:
  CollectionRun(const Collection& collection, const SuiteRunFlags& flags)
      : collection_(collection), flags_(flags), root_(flags.suite.output) {}

  int Run() {
    CheckPlaceOfSuite(root_, collection_.name);
    const OutputFolder output = OpenOutput(root_, {"index.html", "figures/"}, {});
    int worst = 0;
    CheckSuites();
    for (const CollectionSection& section : collection_.sections) {
      if (section.suite.empty() || ran_.contains(section.suite)) continue;
      const int code = RunOne(section.suite);
      if (code == kStopped) return code;
      worst = std::max(worst, code);
    }
    reports::CollectedPage page{collection_.name, collection_.about, {}};
    for (const CollectionSection& section : collection_.sections) {
      page.sections.push_back(Collect(section));
    }
    WriteFilesAtomically(root_, {{"index.html", reports::CollectionHtml(page)}});
    std::cout << "written: " << (root_ / "index.html").string() << '\n';
    return worst;
  }

 private:
  // Checks all suites before the first one runs. A wrong name is an error in the collection's file,
  // a wrong value of an override is a usage error.
  void CheckSuites() const {
    for (const CollectionSection& section : collection_.sections) {
      if (section.suite.empty()) continue;
      const Suite suite = LoadSuite(section.suite);
      LoadNamed(section.suite, [&] { return Override(suite, flags_.suite.overrides); });
    }
  }

  fs::path FolderOf(const std::string& suite) const { return root_ / SuiteFolderName(suite); }

  SuiteRunFlags FlagsOf(const std::string& suite) const {
    SuiteRunFlags flags = flags_;
    flags.suite.suite = suite;
    flags.suite.output = FolderOf(suite).string();
    return flags;
  }

  // A suite without any sequence on this disk has a plan, which says so, and no runs.
  int RunOne(const std::string& suite) {
    const SuiteRunFlags flags = FlagsOf(suite);
    if (!flags.quiet) std::cerr << "suite " << SuiteFolderName(suite) << '\n';
    std::string& problem = ran_[suite];
    int code = 0;
    try {
      code = RunSuite(flags);
    } catch (const NoSequence& error) {
      problem = error.what();
      std::cout << problem << '\n';
    }
    const bool is_timed = LoadSuite(suite).timed_threads > 0;
    if (code != kStopped && is_timed) AddSpeeds(FolderOf(suite), speeds_);
    return code;
  }

  reports::CollectedSection Collect(const CollectionSection& section) {
    reports::CollectedSection collected;
    collected.title = section.title;
    collected.text = section.text;
    collected.data = section.data;
    collected.columns = section.columns;
    collected.rows = section.rows;
    for (const auto& [variant, cells] : section.measured) {
      collected.rows.push_back(cells);
      collected.rows.back().push_back(SpeedText(speeds_[variant]));
    }
    if (!section.suite.empty()) AddTable(section.suite, collected);
    if (section.times && collected.table) ReplaceByTimes(section.suite, collected);
    for (const CollectionFigure& figure : section.figures) AddPictures(figure, collected);
    return collected;
  }

  void AddTable(const std::string& suite, reports::CollectedSection& collected) const {
    const fs::path folder = FolderOf(suite);
    reports::Table table =
        reports::MakeTable(folder, reports::ShippedReference(), DefaultOptions());
    collected.missing = reports::MissingSequences(table);
    collected.problem = ran_.at(suite);
    if (!collected.problem.empty()) return;
    collected.table = std::move(table);
    WriteReport({.folder = folder.string(), .no_images = true});
    collected.report = reports::LinkedFile{SuiteFolderName(suite) + "/report/index.html",
                                           "Figures, and run by run"};
  }

  void ReplaceByTimes(const std::string& suite, reports::CollectedSection& collected) const {
    const reports::SuiteTimes times = reports::ReadSuiteTimes(FolderOf(suite));
    collected.table.reset();
    collected.rows = reports::TimesTable(times);
    collected.columns = collected.rows.front();
    collected.rows.erase(collected.rows.begin());
    collected.text.push_back("Here: " + Joined(times.machines, "; ") + ".");
  }

  void AddPictures(const CollectionFigure& figure, reports::CollectedSection& collected) const {
    const std::string name = StrCat(SuiteFolderName(figure.suite), "-", figure.sequence);
    for (const int frame : figure.frames) {
      const std::string folder = StrCat("figures/", name, "-", frame);
      const std::string what = StrCat(figure.sequence, ", ", figure.variants, ", frame ", frame);
      try {
        DrawOverlays({.suite = FolderOf(figure.suite).string(),
                      .sequence = figure.sequence,
                      .variants = figure.variants,
                      .output = (root_ / folder).string(),
                      .frame = frame,
                      .quiet = true});
        for (const auto& file : fs::directory_iterator(root_ / folder)) {
          collected.pictures.push_back({folder + "/" + file.path().filename().string(), what});
        }
      } catch (const Error& error) {
        collected.text.push_back(StrCat("No picture of ", what, ": ", error.what()));
      }
    }
  }

  const Collection& collection_;
  const SuiteRunFlags& flags_;
  fs::path root_;
  std::map<std::string, std::string> ran_;  // why a suite has no runs; empty if it has
  std::map<std::string, Speed> speeds_;     // by variant
};

}  // namespace

int RunCollection(const Collection& collection, const SuiteRunFlags& flags) {
  return CollectionRun(collection, flags).Run();
}

}  // namespace cvo
