// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "variants/ablations.h"
#include "variants/make.h"

namespace cvo {

template std::unique_ptr<Odometry> MakeVariant<NoTurnPrior>(const OdometrySetup&, TaskPool&);

}  // namespace cvo
