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

BuildIdentity IdentifyBuild() {
  BuildIdentity build;
  build.version = kVersion;
  build.estimator_sources = kEstimatorSources;
  build.evaluation_sources = kEvaluationSources;
  build.compiler = kCompiler;
  build.build_type = kBuildType;
  build.flags = kFlags;
  build.libraries = {cv::getVersionString(), StrCat(EIGEN_WORLD_VERSION, ".", EIGEN_MAJOR_VERSION,
                                                    ".", EIGEN_MINOR_VERSION)};
  build.cpu_level = CpuLevelName();
  build.commit = kCommit;
  build.identity = IdentityOf(build);
  return build;
}

}  // namespace

std::string IdentityOf(const BuildIdentity& build) {
  JsonWriter fields;
  BuildIdentity::VisitIdentity(build, fields);
  return Sha256Hex(DumpJson(fields.Take()));
}

const BuildIdentity& ThisBuild() {
  static const BuildIdentity build = IdentifyBuild();
  return build;
}

}  // namespace cvo
