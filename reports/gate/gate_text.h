// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/gate/check_runs.h"

namespace cvo::reports {

using TextRows = std::vector<std::vector<std::string>>;  // the first is the header

// Returns the comparisons that moved beyond their tolerance and then, of the rest, those over all
// scenes that came nearest to it. Empty if nothing moved.
TextRows MovedRows(const GateReport& report);
// Returns the comparisons of times; empty if there are none.
TextRows TimeRows(const GateReport& report);

// Returns one line with the number of runs and the number of comparisons by verdict.
std::string Headline(const GateReport& report);

// Returns "no regression", "changed" or "regression".
std::string GateVerdict(const GateReport& report);

// Returns how many values changed in an exact check; empty if none did.
std::string ChangeLine(const GateReport& report);

// One line each for whatever fails the check apart from worse values, and for whatever else is
// worth knowing, such as a baseline to update.
std::vector<std::string> ProblemLines(const GateReport& report);
std::vector<std::string> NoteLines(const GateReport& report);

// Aligns columns with spaces, one line per row.
std::string AlignedText(const TextRows& rows);

// Returns a line for each variant that was checked in place of another: whether the gate noticed,
// and in which metrics.
std::string PowerText(const std::vector<LostPart>& parts);

// Returns the whole report for a terminal, as Markdown, or as JUnit XML with a test case per
// comparison and per problem or change.
std::string GateText(const GateReport& report);
std::string GateMarkdown(const GateReport& report);
std::string GateJunit(const GateReport& report);

}  // namespace cvo::reports
