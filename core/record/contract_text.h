// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/record/contract.h"

namespace cvo::reports {

// Returns a contract in words, by topic: aggregation, pairing, delta, alignment, poses, frame,
// truth, correction. Topics that are not stated, or "none", are omitted.
std::vector<std::pair<std::string, std::string>> ContractTexts(const Contract& contract);

// Returns the truth in words, such as "devkit" or "rendered scene; visible: at least 400 px of its
// mask and 30 % unoccluded".
std::string TruthText(const Contract& contract);

// Returns the correction in words, such as "u_right shifted by 0.16 px"; empty if the calibration
// is as published.
std::string CorrectionText(const Contract& contract);

// Returns delta and alignment for the titles of figures, such as "delta all, not aligned".
std::string RelationText(const Contract& contract);

}  // namespace cvo::reports
