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
  std::string source;  // as a reader would cite it
  std::string kind;    // "published" or "measured"
  std::string caveat;
  std::string pair;  // images that were used; empty: not known

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("id", self.id);
    archive.Field("source", self.source);
    archive.Field("kind", self.kind);
    archive.Field("caveat", self.caveat);
  }
};

// One number that others reach on some frames of a sequence, or on scenes of their own that a suite
// of ours stands in for.
struct ReferenceFigure {
  std::size_t source = 0;  // index
  std::string sequence;
  std::string body;   // empty: the camera, or all bodies; tables leave out single bodies
  std::string suite;  // whose name starts so; then without sequence and frames
  int first_frame = 0;
  int frames = 0;
  std::string system;
  std::string metric;
  double value = 0.0;
  MetricUnit unit = MetricUnit::kOne;
  Contract contract;                  // without what the source does not state
  std::vector<std::string> inferred;  // fields that follow from its figures, not from its text
};

struct Reference {
  std::vector<ReferenceSource> sources;
  std::vector<ReferenceFigure> figures;
};

// Adds what a file of reference figures holds. Throws Error naming `where` and the field.
void AddReference(std::string_view json, const std::string& where, Reference& reference);

// All figures that ship with the program.
Reference ShippedReference();

}  // namespace cvo::reports
