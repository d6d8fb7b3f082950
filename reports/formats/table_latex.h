// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "reports/tables/table.h"

namespace cvo::reports {

// Returns a document that pdflatex compiles as it is, with booktabs: values, differences, their
// notes and the definitions of the columns. A table that is too wide or too long for a page is
// split into several, each accuracy beside its coverage.
std::string TableLatex(const Table& table);

// Returns the same without title and preamble, for \input. Requires the packages array, booktabs,
// graphicx and xcolor.
std::string TableLatexBare(const Table& table);

}  // namespace cvo::reports
