// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/record/build_info.h"

namespace cvo {

// What determines the bytes of a result besides its input. Two builds with the same identity give
// the same results. The commit is informative and not part of the identity.
using BuildIdentity = reports::BuildInfo;

// Hash of all fields except the commit.
std::string IdentityOf(const BuildIdentity& build);

// The running program on this CPU.
const BuildIdentity& ThisBuild();

}  // namespace cvo
