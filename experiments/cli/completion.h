// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

namespace cvo {

std::vector<const CLI::App*> CommandsBelow(const CLI::App& app);

using VisitApp = std::function<void(const std::string& path, const CLI::App& app)>;

// Visits `app` and every command below it, with the words that lead to it, such as "clustervo
// experiment run".
void ForEachCommand(const std::string& path, const CLI::App& app, const VisitApp& visit);

// Completion scripts, generated from the same data as --help so that no command or flag is missing.
// They are read with eval, or installed where the shell looks for completions.
std::string BashCompletion(const CLI::App& program);
std::string ZshCompletion(const CLI::App& program);
std::string FishCompletion(const CLI::App& program);

}  // namespace cvo
