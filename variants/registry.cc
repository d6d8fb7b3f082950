// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "variants/registry.h"

#include <array>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "variants/all.h"
#include "variants/instantiate.h"

namespace cvo {

namespace {

template <std::size_t kIndex>
std::unique_ptr<Odometry> Make(const OdometrySetup& setup, TaskPool& pool) {
  return Instantiate<kIndex % kInstantiations>(kIndex, setup, pool);
}

template <std::size_t kIndex>
Options Defaults() {
  Options options;
  VariantAt<kIndex>::SetDefaults(options);
  return options;
}

constexpr auto kInfos = []<std::size_t... kIndex>(std::index_sequence<kIndex...>) {
  return std::array<VariantInfo, kVariants>{VariantInfo{
      VariantAt<kIndex>::kName, VariantAt<kIndex>::kChanges, &Defaults<kIndex>, &Make<kIndex>}...};
}
(std::make_index_sequence<kVariants>());

}  // namespace

std::span<const VariantInfo> Variants() { return kInfos; }

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
