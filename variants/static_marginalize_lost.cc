// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "variants/make.h"
#include "variants/static_ablations.h"

namespace cvo {

template std::unique_ptr<Odometry> MakeVariant<StaticMarginalizeLost>(const OdometrySetup&,
                                                                      TaskPool&);

}  // namespace cvo
