// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include "ceres_list.h"
#include "core/odometry/axes.h"
#include "variants/ablations.h"
#include "variants/full.h"
#include "variants/ladder.h"

namespace cvo {

template <typename... A, typename... B>
constexpr int CountDifferences(Axes<A...>, Axes<B...>) {
  return (!std::is_same_v<A, B> + ...);
}

// Number of axes in which two variants differ; 0 for an ablation that misspells its axis.
template <EstimatorVariant A, EstimatorVariant B>
constexpr int CountDifferences() {
  return CountDifferences(AxesOf<A>(), AxesOf<B>());
}

// A variant of the program that differs from `Base` in kAxes axes.
template <typename Base, typename V, int kAxes = 1>
struct Listed {
  static_assert(CountDifferences<Base, V>() == kAxes);
  using Variant = V;
};

namespace internal {

template <typename Indices>
struct LadderVariants;
template <std::size_t... kRung>
struct LadderVariants<std::index_sequence<kRung...>> {
  // The last rung gives Full itself, which AllVariants leaves out of the steps.
  using Steps = std::tuple<Listed<UpTo<kRung>, UpTo<kRung>, 0>...>;
  using LeftOut = std::tuple<Listed<Without<kRung>, Without<kRung>, 0>...>;
};

template <typename Variants>
struct ListedSolvers;
template <typename... V>
struct ListedSolvers<std::tuple<V...>> {
  using Type = std::tuple<Listed<typename V::OwnSolver, V>...>;
};

}  // namespace internal

static_assert(CountDifferences<UpTo<kRungs - 1>, Full>() == 0);

// The variants with a definition of their own, except CeresVariants.
using NamedVariants = std::tuple<Listed<Full, Full, 0>,                                        //
                                 Listed<Paper, Paper, 0>,                                      //
                                 Listed<Paper, Paper2d, 2>,                                    //
                                 Listed<Paper, Paper2d3d>,                                     //
                                 Listed<Paper, PaperNoMotionPrior>,                            //
                                 Listed<Paper, PrintedGate>,                                   //
                                 Listed<Paper, PrintedBoxes>,                                  //
                                 Listed<Paper, PrintedAffinity>,                               //
                                 Listed<Paper, PrintedKernel>,                                 //
                                 Listed<Full, Only2d, 2>,                                      //
                                 Listed<Full, Only2d3d>,                                       //
                                 Listed<Full, NoGpPrior>,                                      //
                                 Listed<Full, NoTurnPrior>, Listed<Full, WithoutMotionPrior>,  //
                                 Listed<Full, NoPairwiseTerm>,                                 //
                                 Listed<Full, NoProbabilisticAssociation>,                     //
                                 Listed<Full, WithoutBoxRematch>,                              //
                                 Listed<Full, NoMarginalization>,                              //
                                 Listed<Full, NoSpatialTrack>,                                 //
                                 Listed<Full, NoLabelConfidence>,                              //
                                 Listed<Full, Static>,                                         //
                                 Listed<Static, StaticNoMarginalization>,                      //
                                 Listed<Static, StaticNoSpatialTrack>,                         //
                                 Listed<Static, StaticShiftOnly, 0>,                           //
                                 Listed<Static, StaticNoRowEvidence, 0>,                       //
                                 Listed<Static, StaticTrustCalibration, 0>>;
// Every variant in the program, in the order in which they are listed to users: NamedVariants,
// CeresVariants, then those that the ladder makes.
using AllVariants = decltype(std::tuple_cat(
    NamedVariants(), internal::ListedSolvers<CeresVariants>::Type(),
    internal::LadderVariants<std::make_index_sequence<kRungs>>::LeftOut(),
    internal::LadderVariants<std::make_index_sequence<kRungs - 1>>::Steps()));
inline constexpr std::size_t kNamedVariants =
    std::tuple_size_v<NamedVariants> + std::tuple_size_v<CeresVariants>;
inline constexpr std::size_t kVariants = std::tuple_size_v<AllVariants>;

template <std::size_t kIndex>
using VariantAt = typename std::tuple_element_t<kIndex, AllVariants>::Variant;

}  // namespace cvo
