// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/gate/check_runs.h"

namespace cvo::reports {

using TextRows = std::vector<std::vector<std::string>>;  // the first is the header

// What moved beyond its tolerance, then, of the rest, the comparisons over all scenes that came
// nearest to it. Empty where nothing moved.
TextRows MovedRows(const GateReport& report);
// Empty where there is no time to compare.
TextRows TimeRows(const GateReport& report);

// One line: how many runs, how many comparisons of each verdict.
std::string Headline(const GateReport& report);

// "no regression", "changed" or "regression".
std::string GateVerdict(const GateReport& report);

// How many values changed, in an exact check; empty where none did.
std::string ChangeLine(const GateReport& report);

// One line each: what fails the check apart from its numbers, then what else is worth knowing, such
// as a baseline to renew.
std::vector<std::string> ProblemLines(const GateReport& report);
std::vector<std::string> NoteLines(const GateReport& report);

// Columns aligned with blanks, one line per row.
std::string AlignedText(const TextRows& rows);

// A line for each variant that was checked in place of another: what noticed it.
std::string PowerText(const std::vector<LostPart>& parts);

// The whole report for a terminal, as Markdown, and as JUnit XML: a test case per comparison and
// per problem or change.
std::string GateText(const GateReport& report);
std::string GateMarkdown(const GateReport& report);
std::string GateJunit(const GateReport& report);

}  // namespace cvo::reports
