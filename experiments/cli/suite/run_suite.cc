// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/suite/run_suite.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <map>
#include <set>
#include <thread>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/atomic_file.h"
#include "experiments/cli/command.h"
#include "experiments/suite/run_plan.h"
#include "experiments/suite/slurm.h"
#include "synth/write/render_cache.h"

namespace cvo {

namespace fs = std::filesystem;

void SuiteFlags::AddTo(CLI::App& app) {
  const FlagAdder add{app};
  CLI::Option* file =
      add("SUITE", suite, "", "a shipped suite (clustervo list suites) or a suite file");
  CLI::Option* scenes = add("--scenes", sweep.scenes, "A,B,...",
                            "instead of SUITE: shipped scenes and seeds of families, such as "
                            "indoor_1,room@1000:1012, with their good detections");
  scenes->excludes(file);
  add("--variants", sweep.variants, "A,B,...", "with --scenes: variants; default: full")
      ->needs(scenes);
  add("--grid", sweep.grid, "PATH=A,B,...",
      "with --scenes: values of an option, every combination; can be repeated")
      ->allow_extra_args(false)
      ->needs(scenes);
  add("-o,--output", output, "DIR", "output folder of the suite")->required();
  add("--data", data, "FOLDER", "root folder of the real sequences; default: CLUSTERVO_DATA");
  add("--seeds", overrides.seeds, "N", "use seeds 1 to N instead of the suite's")
      ->check(Within(1, 10000));
  add("--frames", overrides.frames, "A:B",
      "use frames A to B-1 of every sequence instead of the suite's");
  add("--set", overrides.set, "PATH=VALUE",
      "set an option (see clustervo list options), an axis of the suite's grid, or, with the "
      "prefix scene., a value of all scenes; can be repeated")
      ->allow_extra_args(false);
}

Suite SuiteFlags::Load() const {
  if (!sweep.scenes.empty()) {
    const fs::path folder = NormalFolder(fs::absolute(output));
    const Json json = SweepDefinition(folder.filename().string(), sweep);
    return LoadNamed("", [&] { return Override(ParseSuite(json, "--scenes"), overrides); });
  }
  if (suite.empty()) throw UsageError("no suite: give SUITE (clustervo list suites) or --scenes");
  return LoadNamed(suite, [&] { return Override(LoadSuite(suite), overrides); });
}

PlanRequest SuiteFlags::Request() const {
  PlanRequest request;
  const char* variable = std::getenv("CLUSTERVO_DATA");
  request.data = !data.empty() ? data : variable == nullptr ? "" : variable;
  request.cache = synth::CacheFolder();
  return request;
}

void EngineFlags::AddTo(CLI::App& app) {
  const FlagAdder add{app};
  add("-j,--jobs", jobs, "N",
      "number of jobs to run in parallel; default: number of CPUs, with slurm all jobs")
      ->check(Within(1, 1024));
  add("--engine", name, "NAME",
      "where jobs run: local (processes on this machine) or slurm (see experiments/README.md)")
      ->check(OneOf({"local", "slurm"}))
      ->capture_default_str();
  add("--sbatch", sbatch, "FLAG",
      "with slurm: additional flag for sbatch, such as --sbatch=--partition=short; can "
      "be repeated")
      ->allow_extra_args(false);
}

std::unique_ptr<Engine> EngineFlags::Make(const SuiteFolder& folder) const {
  if (name == "slurm") {
    SlurmOptions options;
    options.folder = folder.slurm();
    options.sbatch_flags = sbatch;
    options.at_once = jobs;
    return std::make_unique<SlurmEngine>(options);
  }
  if (!sbatch.empty()) ThrowError("--sbatch", "the local engine", "--engine slurm");
  return std::make_unique<LocalEngine>(jobs > 0 ? jobs : DefaultThreads());
}

void PrintJobs(const SuiteFolder& folder, const Plan& plan, const std::vector<JobStatus>& status,
               std::ostream& out) {
  const PlanOutcome counts = CountJobs(status);
  out << status.size() << (status.size() == 1 ? " job: " : " jobs: ") << counts.done << " done";
  if (counts.failed > 0) out << ", " << counts.failed << " failed";
  if (counts.missing > 0) out << ", " << counts.missing << " not run yet";
  if (counts.no_sequence > 0) out << ", " << counts.no_sequence << " with missing input";
  out << '\n';
  std::set<std::string> told;
  for (std::size_t i = 0; i < status.size(); ++i) {
    const PlanJob& job = plan.jobs[i];
    if (status[i].state == JobStatus::State::kFailed) {
      out << "failed: " << Describe(job) << ": " << status[i].message;
      if (!job.job.empty()) out << " (" << folder.log(job.job).string() << ")";
      out << '\n';
    }
    if (status[i].state == JobStatus::State::kNoSequence && told.insert(job.sequence).second) {
      out << "missing input: " << job.sequence << ": " << status[i].message << '\n';
    }
  }
}

namespace {

struct Stopped {};

std::vector<fs::path> ReadBy(const SuiteFlags& suite) {
  const PlanRequest request = suite.Request();
  std::vector<fs::path> read = {request.data, request.cache};
  if (fs::is_regular_file(suite.suite)) read.emplace_back(suite.suite);  // else a shipped suite
  return read;
}

OutputFolder OpenSuiteOutput(const SuiteFlags& flags, const std::string& suite) {
  CheckPlaceOfSuite(flags.output, suite);
  return OpenOutput(flags.output, {"plan.json", "jobs/", "failed/", "logs/"}, ReadBy(flags));
}

// Jobs whose times are measured must not run in parallel.
EngineFlags EngineOf(EngineFlags flags, const Suite& suite) {
  if (suite.timed_threads == 0) return flags;
  if (flags.jobs > 1)
    std::cerr << suite.name << ": one job at a time, because the suite measures times\n";
  flags.jobs = 1;
  return flags;
}

class SuiteRun {
 public:
  explicit SuiteRun(const SuiteRunFlags& flags)
      : flags_(flags),
        suite_(flags.suite.Load()),
        output_(OpenSuiteOutput(flags.suite, suite_.name)),
        folder_{fs::absolute(output_.path())},
        lock_(folder_.lock()),
        engine_(EngineOf(flags.engine, suite_).Make(folder_)) {
    if (flags.suite.sweep.scenes.empty()) return;
    WriteFilesAtomically(folder_.root, {{"suite.json", DumpJson(suite_.definition)}});
  }

  int Run() {
    BuiltPlan built = MakePlan();
    Messages messages;
    if (!built.preparations.empty()) {
      WritePlan(built.plan);
      Prepare(built.preparations, messages);
      built = MakePlan();
      // Files made on other machines may become visible late.
      for (double late_s = 0.0;
           messages.empty() && !built.preparations.empty() && late_s < engine_->latency_s();
           late_s += 1.0) {
        std::this_thread::sleep_for(std::chrono::seconds(1));
        built = MakePlan();
      }
    }
    NoteUnprepared(messages, built.plan);
    WritePlan(built.plan);
    return RunJobs(built.plan);
  }

  int ReportStopped() const {
    PrintNotice("stopped; finished jobs are kept, and running the same command again continues");
    return kInterrupted;
  }

 private:
  // Why the input of a sequence could not be made, by sequence.
  using Messages = std::map<std::string, std::string>;

  BuiltPlan MakePlan() const {
    return PlanSuite(suite_, flags_.suite, flags_.quiet, [this] {
      if (stop_.Requested()) throw Stopped();
    });
  }

  void WritePlan(const Plan& plan) const {
    WriteFilesAtomically(folder_.root, {{"plan.json", PlanText(plan)}});
  }

  PlanRun Settings(Progress& stage) const {
    PlanRun run;
    run.folder = folder_;
    run.program = fs::read_symlink("/proc/self/exe").string();
    run.limit_s = flags_.limit_s;
    run.limit_memory_mb = flags_.limit_memory_mb;
    run.stop = [this] { return stop_.Requested(); };
    run.progress = stage.Reporter();
    run.notice = [&stage](const std::string& line) { stage.Note(line); };
    return run;
  }

  void Prepare(const std::vector<Preparation>& preparations, Messages& failed) {
    for (const Stage stage : kStages) {
      std::vector<const Preparation*> of_stage;
      for (const Preparation& one : preparations) {
        if (one.stage == stage) of_stage.push_back(&one);
      }
      if (!of_stage.empty()) PrepareAtOnce(of_stage, failed);
    }
  }

  void PrepareAtOnce(const std::vector<const Preparation*>& wanted, Messages& failed) {
    Progress progress(flags_.quiet, "scenes");
    const PlanRun run = Settings(progress);
    std::vector<Task> tasks;
    for (const Preparation* one : wanted) {
      Task task{.name = one->name, .argv = {run.program}, .log = folder_.log(one->name)};
      task.argv.insert(task.argv.end(), one->arguments.begin(), one->arguments.end());
      task.limit_s = flags_.limit_s;
      tasks.push_back(std::move(task));
    }
    if (!flags_.quiet) {
      std::cerr << "rendering " << Counted(wanted.size(), "scene") << '\n';
    }
    const auto messages = RunPreparations(tasks, run, *engine_);
    if (!messages) throw Stopped();
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      if ((*messages)[i].empty()) continue;
      failed[wanted[i]->sequence] = StrCat((*messages)[i], " (", tasks[i].log.string(), ")");
    }
  }

  static void NoteUnprepared(const Messages& messages, Plan& plan) {
    for (PlanJob& job : plan.jobs) {
      if (job.missing != kNotRendered) continue;
      const auto message = messages.find(job.sequence);
      job.missing =
          "the scene was not rendered" + (message == messages.end() ? "" : ": " + message->second);
    }
  }

  int RunJobs(const Plan& plan) {
    PlanOutcome outcome;
    {
      Progress stage(flags_.quiet, "jobs");
      outcome = RunPlan(plan, Settings(stage), *engine_);
    }
    if (outcome.stopped) return ReportStopped();
    std::cout << plan.suite.name << ": ";
    PrintJobs(folder_, plan, StatusOfAll(folder_, plan), std::cout);
    if (outcome.done == 0 && outcome.failed == 0) {
      throw NoSequence(
          StrCat(plan.suite.name, ": found no sequence, expected at least one below --data"));
    }
    if (outcome.failed == 0) return 0;
    PrintNotice(StrCat(outcome.failed, " of ", plan.jobs.size(),
                       " jobs failed; the same command tries them again"));
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

BuiltPlan PlanSuite(const Suite& suite, const SuiteFlags& flags, bool quiet,
                    const std::function<void()>& stop) {
  // Progress is only of interest if images have to be read, and is only shown on a terminal.
  Progress stage(quiet || ::isatty(STDERR_FILENO) == 0, "jobs planned");
  PlanRequest request = flags.Request();
  request.notice = PrintNotice;
  request.progress = [&](std::size_t done, std::size_t total) {
    stop();
    stage.Report(done, total);
  };
  return BuildPlan(suite, request);
}

int RunSuite(const SuiteRunFlags& flags) {
  SuiteRun run(flags);
  try {
    return run.Run();
  } catch (const Stopped&) {
    return run.ReportStopped();
  }
}

}  // namespace cvo
