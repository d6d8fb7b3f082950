// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/record/build_identity.h"

#include <Eigen/Core>
#include <opencv2/core/utility.hpp>

#include "build_sources.h"
#include "build_tools.h"
#include "core/base/error.h"
#include "core/features/cpu_level.h"
#include "core/files/sha256.h"

namespace cvo {
namespace {

Json IdentityFields(const BuildIdentity& build) {
  return {{"version", build.version},
          {"estimator_sources", build.estimator_sources},
          {"evaluation_sources", build.evaluation_sources},
          {"compiler", build.compiler},
          {"build_type", build.build_type},
          {"flags", build.flags},
          {"libraries", {{"opencv", build.opencv}, {"eigen", build.eigen}}},
          {"cpu_level", build.cpu_level}};
}

}  // namespace

std::string BuildIdentity::Hash() const { return Sha256Hex(DumpJson(IdentityFields(*this))); }

Json BuildIdentity::ToJson() const {
  Json json = IdentityFields(*this);
  json["identity"] = Hash();
  json["commit"] = commit;
  return json;
}

BuildIdentity ThisBuild() {
  BuildIdentity build;
  build.version = kVersion;
  build.estimator_sources = kEstimatorSources;
  build.evaluation_sources = kEvaluationSources;
  build.compiler = kCompiler;
  build.build_type = kBuildType;
  build.flags = kFlags;
  build.opencv = cv::getVersionString();
  build.eigen = StrCat(EIGEN_WORLD_VERSION, ".", EIGEN_MAJOR_VERSION, ".", EIGEN_MINOR_VERSION);
  build.cpu_level = CpuLevelName();
  build.commit = kCommit;
  return build;
}

}  // namespace cvo
