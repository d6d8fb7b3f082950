// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/make_table.h"

#include <algorithm>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/json/json.h"
#include "core/files/text/closest_names.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"

namespace cvo::reports {
namespace {

std::string Link(const std::filesystem::path& file, const std::filesystem::path& folder) {
  return std::filesystem::absolute(file)
      .lexically_proximate(std::filesystem::absolute(folder))
      .generic_string();
}

// The contract of the truth of a run. Empty if none of its metrics uses a truth (such as coverage
// of a run without truth).
Contract TruthOfRun(const RunSummary& run) {
  for (const MetricValue& metric : run.metrics) {
    if (metric.contract.truth) return WithTruthOf(Contract(), metric.contract);
  }
  return {};
}

// The split of the scenes of a row. Throws Error if a row averages over scenes on which options
// were chosen and scenes on which results are reported.
std::string SplitOf(const RowRuns& row) {
  std::set<std::string> splits;
  for (const SuiteRun* run : row.runs) splits.insert(run->planned.split);
  std::vector<std::string> named(splits.begin(), splits.end());
  std::erase(named, "given");
  if (named.size() > 1) {
    ThrowError("row " + Joined(row.keys, " "),
               StrCat("scenes of the ", named[0], " split and of the ", named[1], " split"),
               "scenes of one split in a row");
  }
  return splits.size() == 1 ? *splits.begin() : named[0] + ", given";
}

JobCounts CountJobs(const std::vector<const SuiteRun*>& runs) {
  const auto in = [&runs](const char* state) {
    return static_cast<std::size_t>(std::ranges::count(runs, state, &SuiteRun::state));
  };
  return {runs.size(),  in("ok") + in("lost"), in("lost"),
          in("failed"), in("not run"),         in("no data")};
}

// Describes a row without its cells. Links are relative to `folder`. The sequence has its name in
// the suite, since the name of the folder of a synthetic scene includes its seed.
Row DescribeRow(const RowRuns& row, const std::filesystem::path& folder) {
  Row described;
  described.keys = row.keys;
  described.split = SplitOf(row);
  described.jobs = CountJobs(row.runs);
  std::set<std::string> scenes;
  std::set<double> shifts_px;
  for (const SuiteRun* run : row.runs) {
    if (!run->run) continue;
    const std::string name = KeyOf(run->planned, "sequence");
    shifts_px.insert(run->run->sequence.camera.right_shift_px);
    described.runs.push_back({name, run->planned.seed, Link(run->run->file, folder)});
    if (scenes.empty()) {
      described.sequence = run->run->sequence;
      described.sequence->name = name;
      described.truth = TruthOfRun(*run->run);
    }
    scenes.insert(SceneOf(*run));
  }
  if (scenes.size() != 1) {
    described.sequence.reset();
    described.truth = Contract();
  }
  shifts_px.erase(0.0);
  described.corrections =
      Joined(shifts_px, ", ", [](double shift_px) { return StrCat(shift_px, " px"); });
  return described;
}

// The jobs that did not end well, grouped by state and, within a state, in the order of the rows.
std::vector<Problem> ListProblems(const std::vector<RowRuns>& rows) {
  std::vector<Problem> problems;
  for (const char* state : {"failed", "lost", "not run", "no data"}) {
    for (const RowRuns& row : rows) {
      for (const SuiteRun* run : row.runs) {
        if (run->state != state) continue;
        problems.push_back({Joined(row.keys, " "), KeyOf(run->planned, "sequence"),
                            run->planned.seed, state, run->message, run->log});
      }
    }
  }
  return problems;
}

// The builds, seeds and options of the runs. `default_options`: nested JSON, empty if unknown.
Provenance DescribeRuns(const std::vector<SuiteRun>& runs, const std::string& default_options) {
  Provenance provenance;
  std::map<std::string, std::string> defaults;
  if (!default_options.empty()) defaults = FlatJson(ParseJson(default_options, "default options"));
  std::set<std::string> seen;
  std::map<std::string, ChangedOption> changed;
  for (const SuiteRun& run : runs) {
    if (!run.run) continue;
    AddOnce(run.run->build.identity, provenance.builds);
    AddOnce(run.planned.seed, provenance.seeds);
    if (defaults.empty() || !seen.insert(run.run->options.dump()).second) continue;
    for (const auto& [path, value] : FlatJson(run.run->options)) {
      const auto found = defaults.find(path);
      const std::string at_default = found == defaults.end() ? "" : found->second;
      if (value == at_default) continue;
      ChangedOption& option =
          changed.try_emplace(path, ChangedOption{path, at_default, {}}).first->second;
      AddOnce(value, option.values);
    }
  }
  for (const auto& [path, option] : changed) provenance.options.push_back(option);
  return provenance;
}

// The values of a row by scene and repetition.
std::map<std::string, std::string> ValuesOf(const RowRuns& row,
                                            const std::vector<std::string>& keys) {
  std::map<std::string, std::string> values;
  for (const SuiteRun* run : row.runs) {
    if (!run->run) continue;
    std::string& text = values[StrCat(SceneOf(*run), " ", RepetitionOf(*run, keys))];
    for (const MetricValue& metric : run->run->metrics) {
      text += StrCat(metric.name, " ", FormatDouble(metric.value), "\n");
    }
    if (run->run->bodies) text += DumpJson(ToJson(*run->run->bodies));
  }
  return values;
}

// Notes about rows that are based on different runs, unless they are of different scenes anyway,
// and about rows with the same values in every run, down to the last bit.
void CompareRows(const std::vector<RowRuns>& rows, bool by_sequence, Table& table) {
  std::vector<std::pair<std::map<std::string, std::string>, std::vector<std::string>>> alike;
  std::set<std::string> runs;
  for (const RowRuns& row : rows) {
    std::map<std::string, std::string> values = ValuesOf(row, table.keys);
    runs.insert(Joined(values, "\n", &decltype(values)::value_type::first));
    if (values.empty()) continue;
    FindOrAdd(alike, &decltype(alike)::value_type::first, {values, {}})
        .second.push_back(Joined(row.keys, " "));
  }
  if (!by_sequence && runs.size() > 1) {
    table.notes.emplace_back(
        "rows are based on different runs: compare them by their paired differences only");
  }
  for (const auto& [values, labels] : alike) {
    if (labels.size() < 2) continue;
    table.notes.push_back(
        Joined(labels, " = ") +
        ": the same values in every run, so what tells them apart changed nothing");
  }
}

// What a reader must know to compare rows: corrected calibrations, perturbed images (unless rows
// vary the perturbation and say so themselves), what rows average over, several builds.
void AddNotes(const std::vector<SuiteRun>& runs, Table& table) {
  const bool by_perturbation = std::ranges::any_of(
      table.keys, [](const std::string& key) { return key.starts_with("perturb."); });
  for (const SuiteRun& run : runs) {
    if (!run.run) continue;
    const RunSequence& sequence = run.run->sequence;
    const std::string name = KeyOf(run.planned, "sequence");
    if (sequence.camera.right_shift_px != 0.0) {
      AddOnce(StrCat(name, ", ", KeyOf(run.planned, "variant"),
                     ": calibration corrected, u_right by ", sequence.camera.right_shift_px,
                     " px; not comparable with rows on the published calibration"),
              table.notes);
    }
    if (sequence.perturbation && !by_perturbation) {
      AddOnce(name + ": images or calibration perturbed: " + sequence.perturbation->dump(),
              table.notes);
    }
  }
  const std::vector<RowRuns> rows = GroupRuns(runs, table.keys);
  for (const std::string& pooled : PooledKeys(rows, table.keys)) {
    table.notes.push_back("rows are means over " + pooled);
  }
  const bool by_sequence = FindBy(table.keys, std::identity(), std::string("sequence")) != nullptr;
  CompareRows(rows, by_sequence, table);
  const std::size_t builds = table.provenance.builds.size();
  if (builds > 1) {
    table.notes.push_back(StrCat("results come from ", builds,
                                 " builds of the program: run the suite again to have one"));
  }
}

}  // namespace

Table DescribeTable(const SuitePlan& plan, const std::vector<SuiteRun>& runs,
                    const std::vector<std::string>& metrics, const std::string& default_options) {
  Table table;
  table.title = plan.name;
  table.about = plan.about;
  table.keys = plan.rows;
  table.columns = MakeColumns(metrics, runs);
  std::vector<const SuiteRun*> all;
  for (const SuiteRun& run : runs) all.push_back(&run);
  table.jobs = CountJobs(all);
  table.problems = ListProblems(GroupRuns(runs, plan.rows));
  table.provenance = DescribeRuns(runs, default_options);
  AddNotes(runs, table);
  return table;
}

void AddRows(const std::vector<RowRuns>& rows, const std::filesystem::path& folder,
             const ReferenceOf& reference_of, Table& table) {
  for (const RowRuns& runs : rows) {
    Row row = DescribeRow(runs, folder);
    const RowRuns* reference = reference_of(runs);
    for (const Column& column : table.columns) {
      Cell cell = MakeCell(runs, table.keys, column);
      cell.not_comparable = DifferingMeaning(runs, column);
      if (reference != nullptr && cell.value && AreComparable(runs, *reference, column)) {
        cell.difference = MakeDifference(runs, *reference, table.keys, column);
      }
      row.cells.push_back(std::move(cell));
    }
    table.rows.push_back(std::move(row));
  }
  std::vector<Difference*> differences;
  for (Row& row : table.rows) {
    for (Cell& cell : row.cells) {
      if (cell.difference) differences.push_back(&*cell.difference);
    }
  }
  CorrectForMany(differences);
}

Table MakeTable(const SuitePlan& plan, const std::vector<SuiteRun>& runs,
                const std::filesystem::path& folder, const Reference& reference,
                const std::string& default_options) {
  const std::string full_reference = FullReference(plan);
  const std::vector<RowRuns> rows = GroupRuns(runs, plan.rows);
  Table table = DescribeTable(plan, runs, WithCoverage(plan.metrics), default_options);
  table.reference = plan.reference;
  const auto reference_of = [&](const RowRuns& row) {
    return FindReference(rows, row, plan.rows, full_reference);
  };
  AddRows(rows, folder, reference_of, table);
  AddReferenceRows(reference, table);
  return table;
}

Table MakeTable(const std::filesystem::path& folder, const Reference& reference,
                const std::string& default_options, const std::string& compared_with,
                const std::vector<std::filesystem::path>& beside) {
  SuitePlan plan = ReadPlan(folder / "plan.json");
  if (!compared_with.empty()) plan.reference = compared_with;
  if (!beside.empty()) AddOnce(std::string("variant"), plan.rows);
  const std::vector<std::string> metrics = WithCoverage(plan.metrics);
  std::vector<SuiteRun> runs = ReadRuns(folder, plan, metrics);
  std::vector<std::string> names;
  std::vector<std::string> paths;
  for (const std::filesystem::path& other : beside) {
    paths.push_back(
        std::filesystem::absolute(other / "plan.json").lexically_normal().parent_path());
    names.push_back(std::filesystem::path(paths.back()).filename());
  }
  names = UniqueNames(names, paths);
  for (std::size_t i = 0; i < beside.size(); ++i) {
    for (SuiteRun& run : ReadRuns(beside[i], ReadPlan(beside[i] / "plan.json"), metrics)) {
      run.planned.keys["variant"] += StrCat(" (", names[i], ")");
      runs.push_back(std::move(run));
    }
  }
  const std::vector<RowRuns> rows = GroupRuns(runs, plan.rows);
  const auto has_reference = [&, full = FullReference(plan)](const RowRuns& row) {
    return FindReference(rows, row, plan.rows, full) != nullptr;
  };
  if (!compared_with.empty() && std::none_of(rows.begin(), rows.end(), has_reference)) {
    ThrowError("reference " + Quoted(compared_with), "no such row in " + plan.file.string(),
               "the variant or the key=value of a row");
  }
  return MakeTable(plan, runs, folder, reference, default_options);
}

bool IsComplete(const Table& table) {
  return table.jobs.failed == 0 && table.jobs.not_run == 0 && table.jobs.done > 0;
}

}  // namespace cvo::reports
