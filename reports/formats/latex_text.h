// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace cvo::reports {

// Escapes a text so that LaTeX prints it verbatim, with any engine and font encoding. Characters
// that Computer Modern lacks are printed as code points, such as U+4E2D. Words may be broken after
// `longest_word` characters.
std::string LatexEscaped(std::string_view text, std::size_t longest_word);

// Formats a number or a range of two, with proper minus signs.
std::string LatexNumber(std::string_view text);

}  // namespace cvo::reports
