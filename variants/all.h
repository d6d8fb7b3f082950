// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>
#include <type_traits>

#include "ceres_list.h"
#include "core/odometry/axes.h"
#include "variants/ablations.h"
#include "variants/ladder.h"

namespace cvo {

template <typename... A, typename... B>
constexpr int CountDifferences(std::tuple<A...>*, std::tuple<B...>*) {
  return (!std::is_same_v<A, B> + ...);
}

// Number of axes in which two variants differ; 0 for an ablation that misspells its axis.
template <typename A, typename B>
constexpr int CountDifferences() {
  return CountDifferences(static_cast<AxesOf<A>*>(nullptr), static_cast<AxesOf<B>*>(nullptr));
}

// A variant of the program that differs from `Base` in kAxes axes.
template <typename Base, typename V, int kAxes = 1>
struct Listed {
  static_assert(CountDifferences<Base, V>() == kAxes);
  using Variant = V;
};

static_assert(CountDifferences<PaperWith<kAllRungs>, Full>() == 0);

// The variants with a definition of their own, except CeresVariants, in the order in which they are
// listed to users.
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
                                 Listed<Static, FrameToFrame>,                                 //
                                 Listed<Static, MaskStatic>,                                   //
                                 Listed<Only2d, Boxes3d>,                                      //
                                 Listed<Static, StaticNoMarginalization>,                      //
                                 Listed<Static, StaticNoSpatialTrack>,                         //
                                 Listed<Static, StaticShiftOnly, 0>,                           //
                                 Listed<Static, StaticNoRowEvidence, 0>,                       //
                                 Listed<Static, StaticTrustCalibration, 0>>;

}  // namespace cvo
