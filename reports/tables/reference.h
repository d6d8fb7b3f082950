// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reports/results/contract.h"

namespace cvo::reports {

struct ReferenceSource {
  std::string id;
  std::string source;  // citation for readers
  std::string kind;    // "published" or "measured"
  std::string caveat;
  std::string pair;  // images that were used; empty: unknown

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("id", self.id);
    archive.Field("source", self.source);
    archive.Field("kind", self.kind);
    archive.Field("caveat", self.caveat);
  }
};

// One number that another system reached on some frames of a sequence, or on other scenes, for
// which one of our suites is a substitute.
struct ReferenceFigure {
  std::size_t source = 0;  // index in Reference::sources
  std::string sequence;
  std::string body;   // empty: the camera, or all bodies; tables omit single bodies
  std::string suite;  // prefix of its name; sequence and frames are then unset
  int first_frame = 0;
  int frames = 0;
  std::string system;
  std::string metric;
  double value = 0.0;
  MetricUnit unit = MetricUnit::kOne;
  Contract contract;                  // empty fields: the source does not state them
  std::vector<std::string> inferred;  // fields inferred from its figures, not stated in its text
};

struct Reference {
  std::vector<ReferenceSource> sources;
  std::vector<ReferenceFigure> figures;
};

// Adds the contents of a file of reference figures. Throws Error naming `where` and the field.
void AddReference(std::string_view json, const std::string& where, Reference& reference);

// All figures that ship with the program.
Reference ShippedReference();

}  // namespace cvo::reports
