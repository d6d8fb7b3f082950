// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace cvo {

// Texts made of what --help is made of, so that none of them lacks a command or a flag.
std::string BashCompletion(const CLI::App& program);  // for zsh as well
std::string FishCompletion(const CLI::App& program);
std::string ManPage(const CLI::App& program);

}  // namespace cvo
