// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <string>
#include <type_traits>

#include "core/base/error.h"

namespace cvo {

// User-facing description of one option. Numbers are valid in [min, max].
struct FieldInfo {
  const char* unit;  // "px", "m", "1" for a pure number
  double min;
  double max;
  const char* meaning;  // one line, with the trade-off if there is one
  const char* source;   // paper section, estimator note, or how it was measured
};

// An options struct lists its fields once, for JSON, --set, help and the result record:
//   template <typename Self, typename Visitor>
//   static void VisitFields(Self& self, Visitor& visit) {
//     visit.Field("spatial", self.spatial, FieldInfo{...});   // int, double or bool
//     visit.Group("huber", self.huber);                       // another options struct
//   }
namespace internal {
struct AnyVisitor {
  template <typename T>
  void Field(const char*, T&, const FieldInfo&) {}
  template <typename T>
  void Group(const char*, T&) {}
};
}  // namespace internal

template <typename T>
concept OptionsStruct = requires(T& options, internal::AnyVisitor& visit) {
  T::VisitFields(options, visit);
};

// Visits every leaf with its dotted path: leaf(path, value, info).
template <typename Leaf>
class LeafVisitor {
 public:
  LeafVisitor(Leaf& leaf, std::string prefix) : leaf_(leaf), prefix_(std::move(prefix)) {}

  template <typename T>
  void Field(const char* name, T& value, const FieldInfo& info) {
    leaf_(prefix_ + name, value, info);
  }
  template <typename T>
  void Group(const char* name, T& group) {
    LeafVisitor inner(leaf_, prefix_ + name + ".");
    std::remove_const_t<T>::VisitFields(group, inner);
  }

 private:
  Leaf& leaf_;
  std::string prefix_;
};

template <typename Options, typename Leaf>
void VisitLeaves(Options& options, Leaf leaf) {
  LeafVisitor<Leaf> visit(leaf, "");
  std::remove_const_t<Options>::VisitFields(options, visit);
}

// Throws Error naming the first field outside its range.
template <typename Options>
void CheckRanges(const Options& options) {
  VisitLeaves(options, [](const std::string& path, const auto& value, const FieldInfo& info) {
    const double number = static_cast<double>(value);
    if (!(number >= info.min && number <= info.max)) {
      ThrowError(StrCat("option ", path), StrCat(value),
                 StrCat("a value in [", info.min, ", ", info.max, "]"));
    }
  });
}

}  // namespace cvo
