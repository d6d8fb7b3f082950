// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/suite/run_suite.h"

#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <thread>

#include "core/base/error.h"
#include "core/files/temporary.h"
#include "experiments/cli/output_file.h"
#include "experiments/cli/progress.h"
#include "experiments/cli/stop_signal.h"
#include "experiments/cli/suite/job_report.h"
#include "experiments/jobs/folder_lock.h"
#include "experiments/jobs/run_plan.h"
#include "experiments/suite/build_plan.h"
#include "synth/write/render_cache.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

constexpr int kIncomplete = 1;

struct Stopped {};

std::vector<fs::path> ReadBy(const SuiteFlags& suite) {
  const PlanRequest request = suite.Request();
  std::vector<fs::path> read = {request.data, request.cache};
  if (fs::is_regular_file(suite.suite)) read.emplace_back(suite.suite);  // else a shipped one
  return read;
}

// One after the other, each stage with a bar of its own.
class Stage {
 public:
  Stage(bool quiet, const ProgressUnit& unit) : quiet_(quiet), unit_(unit) {}

  void Report(std::size_t done, std::size_t total) {
    if (!progress_) progress_.emplace(total, quiet_, Progress::Clock::now(), unit_);
    progress_->Report(done);
  }
  void Note(const std::string& line) const {
    if (progress_) progress_->Note(line);
    if (!progress_) std::cerr << line << '\n';
  }

 private:
  bool quiet_;
  ProgressUnit unit_;
  std::optional<Progress> progress_;
};

class SuiteRun {
 public:
  explicit SuiteRun(const SuiteRunFlags& flags)
      : flags_(flags),
        suite_(flags.suite.Load()),
        output_(OpenOutput(flags.suite.output, {"plan.json", "jobs/", "failed/", "logs/"},
                           ReadBy(flags.suite))),
        folder_{fs::absolute(output_.path())},
        lock_(folder_.lock()),
        engine_(flags.engine.Make(folder_)) {
    RemoveTemporaries(folder_.root);
    synth::RemoveLeftoversOfCache(flags.suite.Request().cache);
  }

  int Run() {
    BuiltPlan built = MakePlan();
    if (!built.renders.empty()) {
      WritePlan(built.plan);
      const auto messages = Render(built.renders);
      built = MakePlan();
      // Scenes that were rendered elsewhere may be late.
      for (double late_s = 0.0;
           messages.empty() && !built.renders.empty() && late_s < engine_->latency_s();
           late_s += 1.0) {
        std::this_thread::sleep_for(std::chrono::seconds(1));
        built = MakePlan();
      }
      NoteUnrendered(messages, built.plan);
    }
    WritePlan(built.plan);
    return RunJobs(built.plan);
  }

  int ReportStopped() const {
    std::cerr << "clustervo: stopped; finished jobs are kept, and running the same command again "
                 "continues\n";
    return kStopped;
  }

 private:
  BuiltPlan MakePlan() const {
    // Only worth showing where images have to be read, which is felt on a terminal.
    Stage stage(flags_.quiet || ::isatty(STDERR_FILENO) == 0, kPlanned);
    PlanRequest request = flags_.suite.Request();
    request.notice = [](const std::string& line) { std::cerr << "clustervo: " << line << '\n'; };
    request.progress = [&](std::size_t done, std::size_t total) {
      if (stop_.Requested()) throw Stopped();
      stage.Report(done, total);
    };
    return BuildPlan(suite_, request);
  }

  void WritePlan(const Plan& plan) const {
    WriteFilesAtomically(folder_.root, {{"plan.json", PlanText(plan)}});
  }

  PlanRun Settings(Stage& stage) const {
    PlanRun run;
    run.folder = folder_;
    run.program = fs::read_symlink("/proc/self/exe").string();
    run.limit_s = flags_.limit_s;
    run.limit_memory_mb = flags_.limit_memory_mb;
    run.stop = [this] { return stop_.Requested(); };
    run.progress = [&stage](std::size_t ended, std::size_t total) { stage.Report(ended, total); };
    run.notice = [&stage](const std::string& line) { stage.Note(line); };
    return run;
  }

  // Messages of the scenes that could not be rendered, by the sequence's name.
  std::map<std::string, std::string> Render(const std::vector<SceneRender>& renders) {
    std::map<std::string, std::string> failed;
    // What is drawn is shared: those that draw it come first.
    for (const bool draws : {true, false}) {
      std::vector<const SceneRender*> scenes;
      for (const SceneRender& render : renders) {
        if (render.draws == draws) scenes.push_back(&render);
      }
      RenderAtOnce(scenes, failed);
    }
    return failed;
  }

  void RenderAtOnce(const std::vector<const SceneRender*>& scenes,
                    std::map<std::string, std::string>& failed) {
    if (scenes.empty()) return;
    Stage stage(flags_.quiet, kScenes);
    const PlanRun run = Settings(stage);
    std::vector<Task> tasks;
    for (const SceneRender* scene : scenes) {
      Task task{.name = scene->name, .argv = {run.program}, .log = folder_.log(scene->name)};
      task.argv.insert(task.argv.end(), scene->arguments.begin(), scene->arguments.end());
      task.limit_s = flags_.limit_s;
      tasks.push_back(std::move(task));
    }
    if (!flags_.quiet) std::cerr << "rendering " << scenes.size() << " scenes\n";
    const auto messages = RunPreparations(tasks, run, *engine_);
    if (!messages) throw Stopped();
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      if ((*messages)[i].empty()) continue;
      failed[scenes[i]->sequence] = StrCat((*messages)[i], " (", tasks[i].log.string(), ")");
    }
  }

  static void NoteUnrendered(const std::map<std::string, std::string>& messages, Plan& plan) {
    for (PlannedJob& job : plan.jobs) {
      if (job.missing != kNotRendered) continue;
      const auto message = messages.find(job.cell.sequence.name);
      job.missing = StrCat("the scene was not rendered",
                           message == messages.end() ? "" : ": " + message->second);
    }
  }

  int RunJobs(const Plan& plan) {
    PlanOutcome outcome;
    {
      Stage stage(flags_.quiet, kJobs);
      outcome = RunPlan(plan, Settings(stage), *engine_);
    }
    if (outcome.stopped) return ReportStopped();
    std::cout << plan.suite.name << ": ";
    PrintJobs(folder_, plan, StatusOfAll(folder_, plan), std::cout);
    if (outcome.done == 0 && outcome.failed == 0) {
      throw Error(
          StrCat(plan.suite.name, ": found no sequence, expected at least one below --data"));
    }
    if (outcome.failed == 0) return 0;
    std::cerr << "clustervo: " << outcome.failed << " of " << plan.jobs.size()
              << " jobs failed; the same command tries them again\n";
    return kIncomplete;
  }

  const SuiteRunFlags& flags_;
  Suite suite_;
  OutputFolder output_;
  SuiteFolder folder_;
  FolderLock lock_;
  std::unique_ptr<Engine> engine_;
  StopSignal stop_;
};

}  // namespace

int RunSuite(const SuiteRunFlags& flags) {
  SuiteRun run(flags);
  try {
    return run.Run();
  } catch (const Stopped&) {
    return run.ReportStopped();
  }
}

}  // namespace cvo
