// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/table_parts.h"

#include <algorithm>
#include <set>

#include "core/base/lists.h"
#include "core/files/json/json.h"
#include "core/files/text/number.h"

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

// The sequence under its name in the suite, since the name of the folder of a synthetic scene
// includes its seed.
SequenceInfo NamedByPlan(const SuiteRun& run) {
  SequenceInfo sequence = run.run->sequence;
  sequence.name = KeyOf(run.planned, "sequence");
  return sequence;
}

std::map<std::string, std::string> Flattened(const std::string& text, const std::string& where) {
  return text.empty() ? std::map<std::string, std::string>() : FlatJson(ParseJson(text, where));
}

void AddChanges(const std::map<std::string, std::string>& defaults,
                const std::map<std::string, std::string>& options,
                std::map<std::string, ChangedOption>& changed) {
  for (const auto& [path, value] : options) {
    const auto found = defaults.find(path);
    const std::string at_default = found == defaults.end() ? "" : found->second;
    if (value == at_default) continue;
    ChangedOption& option = changed[path];
    option.path = path;
    option.default_value = at_default;
    AddOnce(value, option.values);
  }
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
  if (splits.size() == 1) return *splits.begin();
  return named[0] + ", given";
}

}  // namespace

std::string RowLabel(const Row& row) { return Joined(row.keys, " "); }

JobCounts CountJobs(const std::vector<const SuiteRun*>& runs) {
  JobCounts counts;
  counts.planned = runs.size();
  for (const SuiteRun* run : runs) {
    counts.done += run->run ? 1 : 0;
    counts.lost += run->state == "lost" ? 1 : 0;
    counts.failed += run->state == "failed" ? 1 : 0;
    counts.not_run += run->state == "not run" ? 1 : 0;
    counts.no_data += run->state == "no data" ? 1 : 0;
  }
  return counts;
}

Row DescribeRow(const RowRuns& row, const std::filesystem::path& folder) {
  Row described;
  described.keys = row.keys;
  described.split = SplitOf(row);
  described.jobs = CountJobs(row.runs);
  std::set<std::string> scenes;
  std::set<double> shifts_px;
  for (const SuiteRun* run : row.runs) {
    if (!run->run) continue;
    shifts_px.insert(run->run->sequence.camera.right_shift_px);
    described.runs.push_back(
        {KeyOf(run->planned, "sequence"), run->planned.seed, Link(run->run->file, folder)});
    if (scenes.empty()) {
      described.sequence = NamedByPlan(*run);
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

std::vector<Problem> ListProblems(const std::vector<RowRuns>& rows) {
  std::vector<Problem> problems;
  for (const char* state : {"failed", "lost", "not run", "no data"}) {
    for (const RowRuns& row : rows) {
      for (const SuiteRun* run : row.runs) {
        if (run->state != state) continue;
        Row label;
        label.keys = row.keys;
        problems.push_back({RowLabel(label), KeyOf(run->planned, "sequence"), run->planned.seed,
                            state, run->message, run->log});
      }
    }
  }
  return problems;
}

Provenance DescribeRuns(const std::vector<SuiteRun>& runs, const std::string& default_options) {
  Provenance provenance;
  const auto defaults = Flattened(default_options, "default options");
  std::set<std::string> seen;
  std::map<std::string, ChangedOption> changed;
  for (const SuiteRun& run : runs) {
    if (!run.run) continue;
    AddOnce(run.run->build.identity, provenance.builds);
    AddOnce(run.planned.seed, provenance.seeds);
    if (defaults.empty() || !seen.insert(run.run->options.dump()).second) continue;
    AddChanges(defaults, FlatJson(run.run->options), changed);
  }
  for (const auto& [path, option] : changed) provenance.options.push_back(option);
  return provenance;
}

namespace {

// The scenes and repetitions that a row is based on.
std::set<std::string> RunsOf(const RowRuns& row, const std::vector<std::string>& keys) {
  std::set<std::string> names;
  for (const SuiteRun* run : row.runs) {
    if (run->run) names.insert(StrCat(SceneOf(*run), " ", RepetitionOf(*run, keys)));
  }
  return names;
}

// Whether the rows vary the perturbation. Then they say themselves what was done.
bool VariesPerturbation(const Table& table) {
  return std::any_of(table.keys.begin(), table.keys.end(),
                     [](const std::string& key) { return key.starts_with("perturb."); });
}

// Whether the run says how far its calibration is from the truth.
bool ScoresCalibration(const RunSummary& run) {
  return FindBy(run.metrics, &MetricValue::name, std::string("calibration_error")) != nullptr;
}

// What self-calibration found on sequences without a true calibration, if rows tell them apart.
void AddCalibrations(const std::vector<SuiteRun>& runs, const Table& table,
                     std::vector<std::string>& notes) {
  if (std::find(table.keys.begin(), table.keys.end(), "sequence") == table.keys.end()) return;
  std::vector<std::pair<std::string, std::vector<std::string>>> found;  // by sequence
  for (const SuiteRun& run : runs) {
    if (!run.run || !run.run->calibration || ScoresCalibration(*run.run)) continue;
    auto& [sequence, texts] =
        FindOrAdd(found, &decltype(found)::value_type::first, {KeyOf(run.planned, "sequence"), {}});
    AddOnce(
        StrCat(KeyOf(run.planned, "variant"), " ", RoundedTo(run.run->calibration->Mean_px(), 2),
               " +- ", RoundedTo(run.run->calibration->MeanSigma_px(), 2)),
        texts);
  }
  for (const auto& [sequence, texts] : found) {
    notes.push_back(StrCat(
        sequence, ": calibration error found, mean over the image, px: ", Joined(texts, ", ")));
  }
}

}  // namespace

std::string CpuLevelNote(const std::set<std::string>& levels) {
  if (levels.size() < 2) return "";
  return StrCat("results come from processors of different levels (", Joined(levels, ", "),
                "): differences at the level of rounding mean nothing");
}

std::set<std::string> CpuLevels(const std::vector<SuiteRun>& runs) {
  std::set<std::string> levels;
  for (const SuiteRun& run : runs) {
    if (run.run && !run.run->build.cpu_level.empty()) levels.insert(run.run->build.cpu_level);
  }
  return levels;
}

std::vector<std::string> TableNotes(const std::vector<SuiteRun>& runs, const Table& table) {
  std::vector<std::string> notes;
  for (const SuiteRun& run : runs) {
    if (!run.run || run.run->sequence.camera.right_shift_px == 0.0) continue;
    AddOnce(StrCat(KeyOf(run.planned, "sequence"), ", ", KeyOf(run.planned, "variant"),
                   ": calibration corrected, u_right by ", run.run->sequence.camera.right_shift_px,
                   " px; not comparable with rows on the published calibration"),
            notes);
  }
  AddCalibrations(runs, table, notes);
  for (const SuiteRun& run : runs) {
    if (!run.run || !run.run->sequence.perturbation || VariesPerturbation(table)) continue;
    AddOnce(StrCat(KeyOf(run.planned, "sequence"),
                   ": images or calibration perturbed: ", run.run->sequence.perturbation->dump()),
            notes);
  }
  const auto older = std::count_if(runs.begin(), runs.end(), [](const SuiteRun& run) {
    return run.run && run.run->upgraded_from != 0;
  });
  if (older > 0) {
    notes.push_back(StrCat(older, " of ", runs.size(),
                           " results are of schema 2: comparable only with each other"));
  }
  for (const std::string& pooled : PooledKeys(runs, table.keys)) {
    notes.push_back("rows are means over " + pooled);
  }
  const std::vector<RowRuns> rows = GroupRuns(runs, table.keys);
  const bool by_sequence =
      std::find(table.keys.begin(), table.keys.end(), "sequence") != table.keys.end();
  if (!by_sequence && std::any_of(rows.begin(), rows.end(), [&](const RowRuns& row) {
        return RunsOf(row, table.keys) != RunsOf(rows[0], table.keys);
      })) {
    notes.emplace_back(
        "rows are based on different runs: compare them by their paired differences only");
  }
  const std::vector<std::string>& builds = table.provenance.builds;
  const std::set<std::string> levels = CpuLevels(runs);
  if (levels.size() > 1) AddOnce(CpuLevelNote(levels), notes);
  if (builds.size() > std::max<std::size_t>(levels.size(), 1)) {
    notes.push_back(StrCat("results come from ", builds.size(),
                           " builds of the program: run the suite again to have one"));
  }
  return notes;
}

}  // namespace cvo::reports
