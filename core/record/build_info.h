// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/files/json/json_record.h"

namespace cvo::reports {

struct LibraryVersions {
  std::string opencv;
  std::string eigen;

  CVO_RECORD(CVO_ADDED(opencv, eigen));
};

// The build of the program that made a run.
struct BuildInfo {
  std::string version;
  std::string estimator_sources;   // SHA-256 over core, variants and the readers
  std::string evaluation_sources;  // SHA-256 over metrics and runner
  std::string compiler;
  std::string build_type;
  std::string flags;
  LibraryVersions libraries;
  std::string cpu_level;  // CpuLevelName
  std::string identity;   // hash of the fields above
  std::string commit;     // for human readers; with "+changes" if the sources differ from it

  template <typename Self, typename Archive>
  static void VisitIdentity(Self& self, Archive& archive) {
    archive.Added("version", self.version);
    archive.Added("estimator_sources", self.estimator_sources);
    archive.Added("evaluation_sources", self.evaluation_sources);
    archive.Added("compiler", self.compiler);
    archive.Added("build_type", self.build_type);
    archive.Added("flags", self.flags);
    archive.Added("libraries", self.libraries);
    archive.Added("cpu_level", self.cpu_level);
  }

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    VisitIdentity(self, archive);
    archive.Field("identity", self.identity);
    archive.Added("commit", self.commit);
  }

  // Returns what a program of the same sources must match to give the same bytes: compiler, flags,
  // libraries and CPU level. Empty if the run does not state them.
  std::string Platform() const {
    if (compiler.empty() || cpu_level.empty()) return "";
    return StrCat(compiler, ", ", build_type, ", ", flags, ", OpenCV ", libraries.opencv,
                  ", Eigen ", libraries.eigen, ", ", cpu_level);
  }
};

}  // namespace cvo::reports
