// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "variants/registry.h"

#include <array>
#include <string>

#include "core/base/error.h"
#include "variants/differences.h"
#include "variants/static_ablations.h"

namespace cvo {

// Instantiated in the variant's own .cc.
template <typename Variant>
std::unique_ptr<Odometry> MakeVariant(const OdometrySetup& setup, TaskPool& pool);

namespace {

template <typename Variant>
constexpr VariantInfo InfoOf() {
  return {Variant::kName, Variant::kChanges, &MakeVariant<Variant>};
}

// A variant that changes so many axes of Base.
template <typename Base, typename Variant, int kAxes = 1>
constexpr VariantInfo AblationOf() {
  static_assert(CountDifferences<Base, Variant>() == kAxes);
  return InfoOf<Variant>();
}

constexpr std::array kVariants = {
    InfoOf<Full>(),
    AblationOf<Full, Only2d, 2>(),
    AblationOf<Full, Only2d3d>(),
    AblationOf<Full, NoGpPrior>(),
    AblationOf<Full, NoTurnPrior>(),
    AblationOf<Full, NoPairwiseTerm>(),
    AblationOf<Full, NoProbabilisticAssociation>(),
    AblationOf<Full, WithoutBoxRematch>(),
    AblationOf<Full, NoMarginalization>(),
    AblationOf<Full, NoSpatialTrack>(),
    AblationOf<Full, NoLabelConfidence>(),
    AblationOf<Full, PaperLiteral, 10>(),
    AblationOf<Full, Static>(),
    AblationOf<Static, StaticNoMarginalization>(),
    AblationOf<Static, StaticMarginalizeLost>(),
    AblationOf<Static, StaticPriorGauge>(),
    AblationOf<Static, StaticNoSpatialTrack>(),
    AblationOf<Static, StaticSelfCalibration>(),
};

}  // namespace

std::span<const VariantInfo> Variants() { return kVariants; }

const VariantInfo& FindVariant(std::string_view name) {
  std::string names;
  for (const VariantInfo& variant : Variants()) {
    if (variant.name == name) return variant;
    names += names.empty() ? "" : ", ";
    names += variant.name;
  }
  ThrowError("variant", StrCat("\"", name, "\""), StrCat("one of: ", names));
}

}  // namespace cvo
