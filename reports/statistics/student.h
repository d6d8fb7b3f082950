// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace cvo::reports {

// The probability that a variable of Student's t distribution with `degrees` >= 1 degrees of
// freedom exceeds t >= 0. Computed by the finite series of its distribution function (Abramowitz
// and Stegun, 26.7.3 and 26.7.4).
double StudentTail(double t, int degrees);

// The t that such a variable exceeds with probability `tail`, 1e-9 <= tail <= 0.5.
double StudentQuantile(double tail, int degrees);

}  // namespace cvo::reports
