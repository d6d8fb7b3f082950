// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace cvo::reports {

// A text that stays text in LaTeX, whatever its engine and font encoding; characters that Computer
// Modern lacks are their number, such as U+4E2D. Words may be broken after so many characters.
std::string LatexEscaped(std::string_view text, std::size_t longest_word);

// A number or a range of two, with signs that are signs.
std::string LatexNumber(std::string_view text);

}  // namespace cvo::reports
