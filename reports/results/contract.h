// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

namespace cvo::reports {

// What a number means, field by field: frame, poses, truth, alignment, pairing, delta, aggregation,
// left_out. An empty field is one that a source does not state.
using Contract = std::map<std::string, std::string>;

// What makes numbers of different runs one column. The truth belongs to a row (each dataset has its
// own), left_out to a run, and so do the frames first to first + frames - 1 where they are named.
Contract ColumnContract(const Contract& contract, int first_frame, int frames);

// The first field in which the two say different things; empty where there is none. Fields that one
// of them leaves empty or lacks are not compared.
std::string DifferingField(const Contract& a, const Contract& b);

// Fields of `wanted` that `contract` lacks or leaves empty.
std::vector<std::string> UnstatedFields(const Contract& contract, const Contract& wanted);

}  // namespace cvo::reports
