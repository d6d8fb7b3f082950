// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/files/json/json.h"
#include "core/record/run_summary.h"
#include "experiments/datasets/sequence.h"
#include "experiments/runner/system_run.h"

namespace cvo {

// Another system of a suite: a program that is run on each sequence, or the trajectories that one
// has left.
struct SuiteSystem {
  std::string name;
  // Arguments with placeholders (CheckPlaceholders); empty: `camera` exists already.
  std::vector<std::string> command;
  std::vector<std::string> version;  // a command that prints the version; empty: none
  std::string calibration;           // form of {calibration}, one of CalibrationForms()
  // The files that hold its poses, as SystemFiles: with a command below {out}, else below the data
  // folder. Both empty: shipped with the program (ShippedTrajectories).
  std::string camera;
  std::string objects;
  std::vector<std::uint64_t> seeds;
  // Limits of one job instead of those of all jobs (PlanRun); 0: none.
  std::optional<double> limit_s;
  std::optional<double> limit_memory_mb;

  bool shipped() const { return camera.empty(); }
  bool Uses(const std::string& placeholder) const;  // such as "{detections}"
};

std::vector<std::string> CalibrationForms();

// Returns `text` with the placeholders {sequence} and {seed} filled in.
std::string ForJob(std::string text, const std::string& sequence, std::uint64_t seed);

// Makes the files in the commands of a suite file absolute: paths that exist below `folder`, and
// arguments that name a file in it. Empty: the suite has been read before.
void ResolveCommands(const std::filesystem::path& folder, Json& suite);

// Throws Error at `where` for a misspelt placeholder.
void CheckPlaceholders(const SuiteSystem& system, const std::string& where);

// Returns what identifies the program of a system: its command, with hashes in place of files, what
// its version command prints, and what it reads and writes. Throws Error for a program that cannot
// be run.
Json IdentifyProgram(const SuiteSystem& system);

// The same, found once for each system, with what was wrong.
class IdentifiedPrograms {
 public:
  Json Of(const SuiteSystem& system);

 private:
  std::map<std::string, std::pair<Json, std::string>> known_;  // identity or problem, by name
};

// Adds to the identity of a program what it takes besides the content of the sequence.
Json WithInput(Json program, const SuiteSystem& system, const Sequence& sequence);
// Returns a key of what WriteInputs writes.
std::string InputsKey(const Sequence& sequence, const std::string& content,
                      const std::vector<std::string>& classes);

// Where a system runs, and on what.
struct SystemJob {
  const Sequence& sequence;
  std::string name;  // of the sequence in the suite
  std::vector<std::string> classes;
  std::uint64_t seed = 0;
  std::filesystem::path inputs;  // shared by all jobs on the sequence
  std::filesystem::path folder;  // of the job: the program's output is kept there
};

// What the program left, and how long it took.
struct SystemEnd {
  SystemFiles files;
  reports::TimingData timing;
};

// Runs the program of a system on a sequence, in a folder of its own. Its images are links to those
// of the sequence, or written once if they are rectified or perturbed. Throws Error if the program
// fails.
SystemEnd RunProgram(const SuiteSystem& system, const SystemJob& job);

}  // namespace cvo
