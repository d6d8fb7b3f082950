// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace cvo::test {

// A text file of the project. The path is relative to its top, with '/'.
struct SourceFile {
  std::string path;
  std::string content;
};

// Each check returns one line "<path>:<line>: <what is wrong>" per violation.

// Each part includes only parts to its left: core/base <- geometry <- features <- association <-
// clustering <- solvers <- estimation <- interface <- clusters <- bodies <- labelling <- odometry
// <- ceres <- variants <- experiments; reports and synth are beside them. No part includes the
// system and library headers that are banned in it (files, JSON, clocks in the estimator).
std::vector<std::string> CheckIncludes(const SourceFile& file);

// Files begin with the two-line SPDX header, after an interpreter line if there is one.
std::vector<std::string> CheckLicense(const SourceFile& file);

// Sources have at most 400 lines.
std::vector<std::string> CheckLength(const SourceFile& file);

// A file is a concept: a source, or a header with its .cc, has at least 60 lines or three files
// that include it, and a header that only one file includes would make that file too long.
std::vector<std::string> CheckConcepts(const std::vector<SourceFile>& files);

// No part contains text that is forbidden in it: preprocessor branches and macros in the estimator,
// flags that change arithmetic, printing or ending the process in libraries, mutable statics,
// sleeps.
std::vector<std::string> CheckForbiddenText(const SourceFile& file);

// Every .cc is named by the CMakeLists.txt of its folder or of a folder above it.
std::vector<std::string> CheckRegistered(const std::vector<SourceFile>& files);

// Headers define a type name once per namespace: the linker would merge two definitions.
std::vector<std::string> CheckTypeNames(const std::vector<SourceFile>& files);

// Sources and documents cite only existing documents and existing sections of core/METHOD.md; the
// files and options that METHOD.md names exist.
std::vector<std::string> CheckCitations(const std::vector<SourceFile>& files,
                                        const std::vector<SourceFile>& documents);

}  // namespace cvo::test
