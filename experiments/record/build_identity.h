// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/files/json.h"

namespace cvo {

// What decides the bytes of a result beside its input. Two builds with the same identity give the
// same results; the commit is for people and takes no part in it.
struct BuildIdentity {
  std::string version;
  std::string estimator_sources;   // SHA-256 over core, variants and the readers
  std::string evaluation_sources;  // SHA-256 over metrics, runner, record and cache
  std::string compiler;
  std::string build_type;
  std::string flags;
  std::string opencv;
  std::string eigen;
  std::string cpu_level;  // CpuLevelName
  std::string commit;     // with "+changes" where the sources differ from it

  // All of it, and the identity's hash without the commit.
  std::string Hash() const;
  Json ToJson() const;
};

// Of the running program on this CPU.
BuildIdentity ThisBuild();

}  // namespace cvo
