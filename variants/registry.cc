// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "variants/registry.h"

#include <array>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "variants/all.h"

namespace cvo {

namespace {

template <std::size_t kIndex>
std::unique_ptr<Odometry> Make(const OdometrySetup& setup, TaskPool& pool) {
  return Instantiate<kIndex % kInstantiations>(kIndex, setup, pool);
}

// A variant has a name of its own or, on the ladder, one made of its rung's.
template <std::size_t kIndex>
VariantInfo Info() {
  using V = VariantAt<kIndex>;
  constexpr auto kDefaults = [] {
    Options options;
    V::SetDefaults(options);
    return options;
  };
  if constexpr (requires { V::Name(); }) {
    return {V::Name(), V::Changes(), kDefaults, &Make<kIndex>};
  } else {
    return {std::string(V::kName), std::string(V::kChanges), kDefaults, &Make<kIndex>};
  }
}

}  // namespace

std::span<const VariantInfo> Variants() {
  static const auto kInfos = []<std::size_t... kIndex>(std::index_sequence<kIndex...>) {
    return std::array<VariantInfo, kVariants>{Info<kIndex>()...};
  }
  (std::make_index_sequence<kVariants>());
  return kInfos;
}

std::span<const VariantInfo> NamedVariantInfos() { return Variants().first(kNamedVariants); }

const VariantInfo& FindVariant(std::string_view name) {
  for (const VariantInfo& variant : Variants()) {
    if (variant.name == name) return variant;
  }
  std::string names;
  for (const VariantInfo& variant : NamedVariantInfos()) {
    names += names.empty() ? "" : ", ";
    names += variant.name;
  }
  ThrowError("variant", StrCat("\"", name, "\""),
             StrCat("one of: ", names, ", or a step of the ladder"));
}

}  // namespace cvo
