// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/runner/system_run.h"
#include "experiments/suite/suite.h"

namespace cvo {

// An image on a collection's page: frames from runs of one sequence, side by side if there are
// several variants.
struct CollectionFigure {
  std::string suite;  // one of the collection's suites
  std::string sequence;
  std::string variants;  // "2d,full"
  std::vector<int> frames;
};

// A section of the page, for one table or figure of the paper: text, then the table of a suite or
// the published results of other systems, then images.
struct CollectionSection {
  std::string title;
  std::string suite;              // shipped name or suite file; empty: none
  std::vector<std::string> text;  // what the paper shows, what ours shows, how they differ
  std::string data;               // where to get missing data
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;  // results of other systems, as published
  std::vector<CollectionFigure> figures;
  bool times = false;  // show the suite's times instead of its table
};

// Suites that are run one after another and shown on one page.
struct Collection {
  std::string name;
  std::string about;
  std::vector<CollectionSection> sections;
};

// A suite file that comes with the program.
struct ShippedSuite {
  std::string name;  // as stated in `text`
  std::string text;  // JSON
};
// The suite files of experiments/configs in their order of listing, and the collections of suites.
std::vector<ShippedSuite> ShippedSuites();
std::vector<ShippedSuite> ShippedCollections();

// Another system's trajectory on a shipped scene, from a file of reports/reference/trajectories.
struct ShippedTrajectory {
  std::string_view system;
  std::string_view scene;
  std::string_view text;  // TUM poses after a line with the hash of the scene file
};
const std::vector<ShippedTrajectory>& ShippedTrajectories();

// Returns a shipped collection, or one read from a JSON file with "sections". Empty for any other
// name or file. Throws Error if the collection is invalid.
std::optional<Collection> FindCollection(const std::string& name);

// Returns the name of the folder for a suite's results, below the collection's folder.
std::string SuiteFolderName(const std::string& suite);

// Returns an entry for each of the sequences on which the program ships a trajectory of `system`.
// Throws Error at `where` if there is none.
std::vector<SuiteSystem::Files> ShippedFilesOf(const std::string& system,
                                               const std::vector<SuiteSequence>& sequences,
                                               const std::string& where);

// PlanJob::missing starts with this if a shipped trajectory was made from other images.
inline constexpr std::string_view kStale = "stale: ";

// Writes the trajectory of a sequence from ShippedFilesOf below the cache folder and returns the
// file. Throws Error, with kStale, if the scene file has changed since the trajectory was made, or
// if the sequence uses other frames or perturbed images.
SystemFiles ShippedSystemFiles(const std::string& system, const SuiteSequence& sequence,
                               const std::filesystem::path& cache);

}  // namespace cvo
