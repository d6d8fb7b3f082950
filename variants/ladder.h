// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "variants/clustervo.h"
#include "variants/joined_text.h"
#include "variants/rungs.h"

namespace cvo {

// The ladder from ClusterVo to Full, one addition at a time, in the order of the paper's sections.
// All rungs together make Full: all.h asserts this for the axes, a test for the options.
template <template <typename> class R>
struct Rung {
  template <typename Base>
  using On = R<Base>;
  static constexpr std::string_view kName = R<ClusterVo>::kRung;
  static constexpr std::string_view kAdds = R<ClusterVo>::kAdds;
};
using Rungs = std::tuple<Rung<AddBoundedBoxes>, Rung<AddReacquisition>, Rung<AddLeftImage>,
                         Rung<AddMissedDetections>, Rung<AddBoxSize>, Rung<AddBodiesByDepth>,
                         Rung<AddMotionEvidence>, Rung<AddReserve>, Rung<AddConfirmation>,
                         Rung<AddAlignedPatches>, Rung<AddPatchNoise>, Rung<AddSelfCalibration>,
                         Rung<AddOutlierRemoval>, Rung<AddEarlyStop>, Rung<AddBodyMotion>,
                         Rung<AddPastInformation>, Rung<AddTraceBack>, Rung<AddIdentity>>;
inline constexpr std::size_t kRungs = std::tuple_size_v<Rungs>;

namespace internal {

// ClusterVo with the first kCount rungs, except for rung kLeftOut.
template <std::size_t kCount, std::size_t kLeftOut>
struct Climbed {
  using Below = typename Climbed<kCount - 1, kLeftOut>::Type;
  using Type =
      std::conditional_t<kCount - 1 == kLeftOut, Below,
                         typename std::tuple_element_t<kCount - 1, Rungs>::template On<Below>>;
};
template <std::size_t kLeftOut>
struct Climbed<0, kLeftOut> {
  using Type = ClusterVo;
};

inline constexpr std::string_view kUpTo = "clustervo_to_";
inline constexpr std::string_view kUpToChanges =
    "clustervo with the additions of ladder up to and including: ";
inline constexpr std::string_view kWithout = "no_";
inline constexpr std::string_view kWithoutChanges = "full without this addition: ";

}  // namespace internal

// ClusterVo with all rungs up to and including rung kRung.
template <std::size_t kRung>
struct UpTo : internal::Climbed<kRung + 1, kRungs>::Type {
  using Added = std::tuple_element_t<kRung, Rungs>;
  static constexpr std::string_view kName = kJoined<internal::kUpTo, Added::kName>;
  static constexpr std::string_view kChanges = kJoined<internal::kUpToChanges, Added::kAdds>;
};

// Full without rung kRung.
template <std::size_t kRung>
struct Without : internal::Climbed<kRungs, kRung>::Type {
  using Left = std::tuple_element_t<kRung, Rungs>;
  static constexpr std::string_view kName = kJoined<internal::kWithout, Left::kName>;
  static constexpr std::string_view kChanges = kJoined<internal::kWithoutChanges, Left::kAdds>;
};

}  // namespace cvo
