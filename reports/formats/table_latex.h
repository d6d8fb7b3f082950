// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "reports/tables/table.h"

namespace cvo::reports {

// A document that pdflatex compiles as it is, with booktabs: values, differences, their notes and
// the definitions of the columns. What is too wide or long for a page is several tables, each
// accuracy beside its coverage.
std::string TableLatex(const Table& table);

// The same without title and preamble, for \input; needs the packages array, booktabs and xcolor.
std::string TableLatexBare(const Table& table);

}  // namespace cvo::reports
