// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clustering/unary_terms.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace cvo {

void NormalizeEnergies(double max_energy, EnergyMatrix& energies) {
  if (energies.cols() == 0) return;
  for (Eigen::Index i = 0; i < energies.rows(); ++i) {
    auto row = energies.row(i);
    const double least = row.minCoeff();
    if (least == row.maxCoeff()) {
      row.setZero();
      continue;
    }
    double sum = 0.0;
    for (const double energy : row) sum += std::exp(least - energy);
    if (!(sum >= 1.0)) {
      ThrowError(StrCat("unary energies, node ", i), StrCat(row), "numbers: is a covariance bad?");
    }
    const double log_sum = std::log(sum);
    for (double& energy : row) energy = std::min(energy - least + log_sum, max_energy);
  }
}

}  // namespace cvo
