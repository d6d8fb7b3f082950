// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reports/results/build_info.h"

namespace cvo {

// What decides the bytes of a result beside its input. Two builds with the same identity give the
// same results; the commit is for people and takes no part in it.
using BuildIdentity = reports::BuildInfo;

// Hash of its fields without the commit.
std::string IdentityOf(const BuildIdentity& build);

// Of the running program on this CPU.
const BuildIdentity& ThisBuild();

}  // namespace cvo
