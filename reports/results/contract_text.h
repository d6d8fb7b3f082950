// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "reports/results/contract.h"

namespace cvo::reports {

// A contract in words, by what it is about: aggregation, pairing, delta, alignment, poses, frame,
// truth. What is not stated, and "none", lacks.
std::vector<std::pair<std::string, std::string>> ContractTexts(const Contract& contract);

// "devkit"; "rendered scene; visible: at least 400 px of its mask and 30 % unoccluded".
std::string TruthText(const Contract& contract);

// "u_right shifted by 0.16 px"; empty where a calibration is as published.
std::string CorrectionText(const Contract& contract);

// For the titles of figures: "delta all, not aligned".
std::string RelationText(const Contract& contract);

}  // namespace cvo::reports
