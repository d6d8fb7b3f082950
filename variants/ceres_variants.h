// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/ceres/ceres_solvers.h"
#include "variants/ablations.h"
#include "variants/paper.h"

namespace cvo {

// Each variant solves its windows with the Ceres library and is otherwise the same as OwnSolver.
struct FullCeres : Full {
  using OwnSolver = Full;
  static constexpr std::string_view kName = "full_ceres";
  static constexpr std::string_view kChanges = "full; windows are solved by Ceres";
  using Solver = CeresSolver;
};

struct PaperCeres : Paper {
  using OwnSolver = Paper;
  static constexpr std::string_view kName = "paper_ceres";
  static constexpr std::string_view kChanges = "paper; windows are solved by Ceres";
  using Solver = CeresSolver;
};

struct StaticCeres : Static {
  using OwnSolver = Static;
  static constexpr std::string_view kName = "static_ceres";
  static constexpr std::string_view kChanges = "static; windows are solved by Ceres";
  using Solver = CeresSolver;
};

}  // namespace cvo
