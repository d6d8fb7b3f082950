// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "variants/registry.h"

#include <array>
#include <string>

#include "core/base/error.h"
#include "variants/make.h"
#include "variants/static.h"

namespace cvo {

extern template std::unique_ptr<Odometry> MakeVariant<Static>(const OdometrySetup&, TaskPool&);

namespace {

template <typename Variant>
constexpr VariantInfo InfoOf() {
  return {Variant::kName, Variant::kChanges, &MakeVariant<Variant>};
}

constexpr std::array kVariants = {InfoOf<Static>()};

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
