// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reports/tables/cells.h"

namespace cvo::reports {

// One number that another system reached on some frames of a sequence, or on other scenes, for
// which one of our suites is a substitute.
struct ReferenceFigure {
  ReferenceSource source;
  std::string sequence;
  std::string body;   // empty: the camera, or all bodies; tables omit single bodies
  std::string suite;  // prefix of its name; sequence and frames are then unset
  int first_frame = 0;
  int frames = 0;
  std::string system;
  std::string metric;
  double value = 0.0;
  MetricUnit unit = MetricUnit::kOne;
  Contract contract;                  // empty fields: the source does not state them
  std::vector<std::string> inferred;  // fields inferred from its figures, not stated in its text
};

using Reference = std::vector<ReferenceFigure>;

// Adds the contents of a file of reference figures. Throws Error naming `where` and the field.
void AddReference(std::string_view json, const std::string& where, Reference& reference);

// All figures that ship with the program: what others publish, and what we measured of their
// systems.
Reference ShippedReference();

// The files that they are read from: path in the source tree, and JSON.
std::vector<std::pair<std::string, std::string>> ShippedReferenceFiles();

// Adds what other systems reach on the sequences of the table, below our rows: first the rows with
// a comparable figure, then the rest, with the reason in each cell that is not comparable. Figures
// for a whole suite come below all rows.
void AddReferenceRows(const Reference& reference, Table& table);

// Makes the table of the output folder of a suite, however much of the suite has run. Rows are
// based on the runs that exist and state how many these are; the other runs are listed. Throws
// Error for a plan that cannot be read and, naming both files, if two of our own results define the
// same metric differently. `default_options`: nested JSON, empty if unknown. `compared_with`:
// replaces the reference of the plan and is written as it is there; throws Error if it matches no
// row. Empty: the reference of the plan. `beside`: other output folders, such as copies of
// somebody else's, whose runs are further rows, named after their folder.
Table MakeTable(const std::filesystem::path& folder, const Reference& reference,
                const std::string& default_options, const std::string& compared_with = "",
                const std::vector<std::filesystem::path>& beside = {});

// The table of these runs, with links relative to `folder`.
Table MakeTable(const SuitePlan& plan, const std::vector<SuiteRun>& runs,
                const std::filesystem::path& folder, const Reference& reference,
                const std::string& default_options);

// Compares the runs of `folder` with those of `before`, paired by row, scene, seed and body. Values
// are those of `folder`; differences are with respect to the same row of `before`. Throws Error as
// MakeTable does, and if the two have no run in common.
Table CompareFolders(const std::filesystem::path& before, const std::filesystem::path& folder);

// "3 of 40 values changed, 1 distinguishable from noise (*)".
std::string MovedText(const Table& table);

// Whether no job failed or has yet to run, and at least one was completed. Jobs whose sequence is
// not on this machine do not count.
bool IsComplete(const Table& table);

// What is common to the tables of one folder and of two.

// Everything but the rows and the reference. `default_options`: as for MakeTable.
Table DescribeTable(const SuitePlan& plan, const std::vector<SuiteRun>& runs,
                    const std::vector<std::string>& metrics, const std::string& default_options);

// The row that a row is compared with, or nullptr if there is none.
using ReferenceOf = std::function<const RowRuns*(const RowRuns& row)>;

// Adds rows with links relative to `folder`, and corrects their differences for their number.
void AddRows(const std::vector<RowRuns>& rows, const std::filesystem::path& folder,
             const ReferenceOf& reference_of, Table& table);

}  // namespace cvo::reports
