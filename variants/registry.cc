// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "variants/registry.h"

#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "variants/all.h"

namespace cvo {

namespace {

template <typename V>
VariantInfo InfoOf(std::string name, std::string changes) {
  constexpr auto kDefaults = [] {
    Options options;
    V::SetDefaults(options);
    return options;
  };
  constexpr auto kMake = [](const OdometrySetup& setup, TaskPool& pool) {
    return MakeOdometry(StepsOf<V>(), setup, pool);
  };
  return {std::move(name), std::move(changes), kDefaults, kMake};
}

template <typename... L>
void Add(const std::tuple<L...>*, std::vector<VariantInfo>& infos) {
  (infos.push_back(InfoOf<typename L::Variant>(std::string(L::Variant::kName),
                                               std::string(L::Variant::kChanges))),
   ...);
}

template <typename... V>
void AddCeres(const std::tuple<V...>*, std::vector<VariantInfo>& infos) {
  Add(static_cast<std::tuple<Listed<typename V::OwnSolver, V>...>*>(nullptr), infos);
}

// Full without each rung, then Paper with the rungs up to each but the last.
template <std::size_t... kRung>
void AddLadder(std::index_sequence<kRung...>, std::vector<VariantInfo>& infos) {
  (infos.push_back(InfoOf<PaperWith<(kAllRungs & ~(1U << kRung))>>(
       StrCat("no_", kLadder[kRung].name),
       StrCat("full without this addition: ", kLadder[kRung].adds))),
   ...);
  (infos.push_back(InfoOf<PaperWith<(2U << kRung) - 1U>>(
       StrCat("paper_to_", kLadder[kRung].name),
       StrCat("paper with the additions of the ladder up to and including: ",
              kLadder[kRung].adds))),
   ...);
  infos.pop_back();  // Full itself
}

std::vector<VariantInfo> NamedInfos() {
  std::vector<VariantInfo> infos;
  Add(static_cast<NamedVariants*>(nullptr), infos);
  AddCeres(static_cast<CeresVariants*>(nullptr), infos);
  return infos;
}

}  // namespace

std::span<const VariantInfo> NamedVariantInfos() {
  static const std::vector<VariantInfo> infos = NamedInfos();
  return infos;
}

std::span<const VariantInfo> Variants() {
  static const std::vector<VariantInfo> kInfos = [] {
    std::vector<VariantInfo> infos = NamedInfos();
    AddLadder(std::make_index_sequence<kRungs>(), infos);
    return infos;
  }();
  return kInfos;
}

const VariantInfo& FindVariant(std::string_view name) {
  for (const VariantInfo& variant : Variants()) {
    if (variant.name == name) return variant;
  }
  ThrowError("variant", StrCat("\"", name, "\""),
             StrCat("one of: ", Joined(NamedVariantInfos(), ", ", &VariantInfo::name),
                    ", or a step of the ladder"));
}

}  // namespace cvo
