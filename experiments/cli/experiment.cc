// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// clustervo experiment: run suites, or show what would run.
#include <unistd.h>

#include <cstdlib>
#include <iostream>
#include <map>
#include <memory>
#include <set>
#include <thread>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/atomic_file.h"
#include "experiments/cli/command.h"
#include "experiments/suite/build_plan.h"
#include "experiments/suite/engine.h"
#include "experiments/suite/job_status.h"
#include "experiments/suite/run_plan.h"
#include "experiments/suite/slurm.h"
#include "experiments/suite/suite.h"
#include "synth/write/render_cache.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

struct ExperimentFlags {
  std::string suite;
  SuiteSweep sweep;  // with scenes or systems: instead of `suite`
  bool is_sweep() const { return !sweep.scenes.empty() || !sweep.systems.empty(); }
  std::string output;
  std::string data;
  SuiteOverrides overrides;
  std::string engine = "local";
  int jobs = 0;  // in parallel; 0: not specified
  std::vector<std::string> sbatch;
  double limit_s = 3600.0;          // wall time of one job; 0: unlimited
  double limit_memory_mb = 8000.0;  // address space of one job; 0: unlimited
  bool dry_run = false;
  bool quiet = false;
};

// Throws Error for an invalid suite.
Suite LoadSuiteOf(const ExperimentFlags& flags) {
  if (flags.is_sweep()) {
    const fs::path folder = NormalFolder(fs::absolute(flags.output));
    const Json json = SweepDefinition(folder.filename().string(), flags.sweep);
    const std::string where = flags.sweep.systems.empty() ? "--scenes" : flags.sweep.systems;
    return LoadNamed("", [&] { return Override(ParseSuite(json, where), flags.overrides); });
  }
  if (flags.suite.empty()) {
    throw UsageError("no suite: give SUITE (clustervo list suites), --scenes or --systems");
  }
  return LoadNamed(flags.suite, [&] { return Override(LoadSuite(flags.suite), flags.overrides); });
}

fs::path DataFolderOf(const ExperimentFlags& flags) {
  const char* variable = std::getenv("CLUSTERVO_DATA");
  return !flags.data.empty() ? flags.data : variable == nullptr ? "" : variable;
}

// Throws Error for flags that do not apply to the engine.
std::unique_ptr<Engine> MakeEngine(const ExperimentFlags& flags, const Suite& suite,
                                   const SuiteFolder& folder) {
  int jobs = flags.jobs;
  if (suite.timed_threads > 0) {  // jobs whose times are measured must not run in parallel
    if (jobs > 1) {
      std::cerr << suite.name << ": one job at a time, because the suite measures times\n";
    }
    jobs = 1;
  }
  if (flags.engine == "slurm") {
    return std::make_unique<SlurmEngine>(
        SlurmOptions{.folder = folder.slurm(), .sbatch_flags = flags.sbatch, .at_once = jobs});
  }
  if (!flags.sbatch.empty()) ThrowError("--sbatch", "the local engine", "--engine slurm");
  return std::make_unique<LocalEngine>(jobs > 0 ? jobs : DefaultThreads());
}

// Plans a suite, with its progress on a terminal. `stop` is called before each job; it may throw.
BuiltPlan PlanSuite(
    const Suite& suite, const ExperimentFlags& flags, const std::function<void()>& stop = [] {}) {
  // Progress is only of interest if images have to be read, and is only shown on a terminal.
  Progress stage(flags.quiet || ::isatty(STDERR_FILENO) == 0, "jobs planned");
  return BuildPlan(suite, {.data = DataFolderOf(flags),
                           .cache = synth::CacheFolder(),
                           .notice = PrintNotice,
                           .progress = [&](std::size_t done, std::size_t total) {
                             stop();
                             stage.Report(done, total);
                           }});
}

// Prints "80 jobs: 76 done, 2 failed, 2 with missing input", then a line for each failed job, with
// its message and log, and for each sequence with missing input.
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

struct Stopped {};

OutputFolder OpenSuiteOutput(const ExperimentFlags& flags, const std::string& suite) {
  CheckPlaceOfSuite(flags.output, suite);
  std::vector<fs::path> read = {DataFolderOf(flags), synth::CacheFolder()};
  if (fs::is_regular_file(flags.suite)) read.emplace_back(flags.suite);  // else a shipped suite
  return OpenOutput(flags.output, {"plan.json", "jobs/", "failed/", "logs/"}, read);
}

// Renders, plans and runs a suite.
class SuiteRun {
 public:
  explicit SuiteRun(const ExperimentFlags& flags)
      : flags_(flags),
        suite_(LoadSuiteOf(flags)),
        output_(OpenSuiteOutput(flags, suite_.name)),
        folder_{fs::absolute(output_.path())},
        lock_(folder_.lock()),
        engine_(MakeEngine(flags, suite_, folder_)) {
    RemoveTemporariesOf(folder_.plan());  // of killed runs; others write here as well
    if (!flags.is_sweep()) return;
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
    return PlanSuite(suite_, flags_, [this] {
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
    for (const bool draws : {true, false}) {
      std::vector<const Preparation*> at_once;
      for (const Preparation& one : preparations) {
        if (one.draws == draws) at_once.push_back(&one);
      }
      if (!at_once.empty()) PrepareAtOnce(at_once, failed);
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
      throw Error(
          StrCat(plan.suite.name, ": found no sequence, expected at least one below --data"));
    }
    if (outcome.failed == 0) return 0;
    PrintNotice(StrCat(outcome.failed, " of ", plan.jobs.size(),
                       " jobs failed; the same command tries them again"));
    return kIncomplete;
  }

  const ExperimentFlags& flags_;
  Suite suite_;
  OutputFolder output_;
  SuiteFolder folder_;
  FolderLock lock_;
  std::unique_ptr<Engine> engine_;
  StopSignal stop_;
};

int RunSuite(const ExperimentFlags& flags) {
  SuiteRun run(flags);
  try {
    return run.Run();
  } catch (const Stopped&) {
    return run.ReportStopped();
  }
}

// Prints what is done in the output folder, and what would run.
int PrintPlan(const ExperimentFlags& flags) {
  const Suite suite = LoadSuiteOf(flags);
  const BuiltPlan built = PlanSuite(suite, flags);
  const SuiteFolder folder{flags.output};
  std::cout << suite.name << " (" << SplitOf(suite) << " split): ";
  PrintJobs(folder, built.plan, StatusOfAll(folder, built.plan), std::cout);
  int frames = 0;
  for (const Preparation& scene : built.preparations) frames += scene.frames;
  if (frames > 0) {
    std::cout << "scenes to render: " << built.preparations.size() << " (" << frames
              << " frames)\n";
  }
  return 0;
}

Command AddExperimentRunCommand(CLI::App& experiment) {
  CLI::App* app = experiment.add_subcommand(
      "run", "Run a suite: render its scenes, then run every job that is not done");
  const auto flags = std::make_shared<ExperimentFlags>();
  const FlagAdder add{*app};
  CLI::Option* file =
      add("SUITE", flags->suite, "", "a shipped suite (clustervo list suites) or a suite file");
  CLI::Option* scenes = add("--scenes", flags->sweep.scenes, "A,B,...",
                            "instead of SUITE: shipped scenes and seeds of families, such as "
                            "indoor_1,room@1000:1012, with their good detections");
  scenes->excludes(file);
  add("--systems", flags->sweep.systems, "FILE",
      "run the systems of a suite file on --scenes, by default on tiny alone; see "
      "experiments/systems")
      ->excludes(file);
  add("--variants", flags->sweep.variants, "A,B,...",
      "with --scenes or --systems: variants; default: full, or none beside --systems")
      ->excludes(file);
  add("--grid", flags->sweep.grid, "PATH=A,B,...",
      "with --scenes: values of an option, every combination; can be repeated")
      ->allow_extra_args(false)
      ->excludes(file);
  add("-o,--output", flags->output, "DIR", "output folder of the suite")->required();
  add("--data", flags->data, "FOLDER",
      "root folder of the real sequences; default: CLUSTERVO_DATA");
  add("--seeds", flags->overrides.seeds, "N", "use seeds 1 to N instead of the suite's")
      ->check(Within(1, 10000));
  add("--frames", flags->overrides.frames, "A:B",
      "use frames A to B-1 of every sequence instead of the suite's");
  add("--set", flags->overrides.set, "PATH=VALUE",
      "set an option (see clustervo list options), an axis of the suite's grid, or, with the "
      "prefix scene., a value of all scenes; can be repeated")
      ->allow_extra_args(false);
  add("-j,--jobs", flags->jobs, "N",
      "number of jobs to run in parallel; default: number of CPUs, with slurm all jobs")
      ->check(Within(1, 1024));
  add("--engine", flags->engine, "NAME",
      "where jobs run: local (processes on this machine) or slurm (see experiments/README.md)")
      ->check(OneOf({"local", "slurm"}))
      ->capture_default_str();
  add("--sbatch", flags->sbatch, "FLAG",
      "with slurm: additional flag for sbatch, such as --sbatch=--partition=short; can "
      "be repeated")
      ->allow_extra_args(false);
  add("--time-limit", flags->limit_s, "S", "wall time limit of one job; 0: no limit")
      ->check(Within(0.0, 1e9))
      ->capture_default_str();
  add("--memory-limit", flags->limit_memory_mb, "MB", "address space limit of one job; 0: no limit")
      ->check(Within(0.0, 1e9))
      ->capture_default_str();
  app->add_flag("--dry-run", flags->dry_run,
                "only print what is done and what would run; nothing is written");
  AddQuiet(*app, flags->quiet);
  app->footer(
      "A job is one estimator with one set of options on one sequence with one seed, and runs "
      "in\nits own process. A failed job leaves its message and log and does not stop the "
      "others.\nRunning the same command again runs failed and missing jobs, also after an "
      "interrupt or a\ncrash.\nOutput files: plan.json, jobs/<id>/ (as clustervo run), "
      "failed/<id>.json, logs/<id>.log.\n"
      "Exit code 0: all jobs succeeded, 1: some "
      "failed or the suite is invalid, 2: wrong usage, 130:\ninterrupted.\n"
      "Examples:\n"
      "  clustervo experiment run ablation -o results/ablation\n"
      "  clustervo experiment run --scenes room@1000:1012 --variants full,paper "
      "--grid pairwise.alpha=0,5,20 \\\n      -o results/alpha   # keeps the suite as suite.json "
      "there");
  return {app, [flags] { return flags->dry_run ? PrintPlan(*flags) : RunSuite(*flags); }};
}

int RunOne(const SuiteFolder& folder, const std::string& id) {
  RunPlannedJob(ParsePlan(ReadJson(folder.plan()), folder.plan().string()), id, folder,
                synth::CacheFolder(), PrintNotice);
  return 0;
}

Command AddExperimentJobCommand(CLI::App& experiment) {
  CLI::App* app = experiment.add_subcommand(
      "job", "Run one job of a suite folder; experiment run starts this for each job");
  const FlagAdder add{*app};
  app->group("");  // hidden from help
  const auto folder = std::make_shared<std::string>();
  const auto id = std::make_shared<std::string>();
  add("DIR", *folder, "", "the suite's folder")->required();
  add("ID", *id, "", "id of the job in DIR/plan.json")->required();
  return {app, [folder, id] { return RunOne({*folder}, *id); }};
}

}  // namespace

Command AddExperimentCommand(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "experiment",
      "Run suites of sequences, estimators, options and seeds, and tabulate their results");
  app->footer("Start with: clustervo list suites, then clustervo experiment run ci -o DIR.");
  return Group(*app, {AddExperimentRunCommand(*app), AddExperimentTableCommand(*app),
                      AddExperimentCompareCommand(*app), AddExperimentJobCommand(*app)});
}

}  // namespace cvo
