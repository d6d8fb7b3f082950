// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/results/schema_2.h"

#include <map>

#include "reports/results/run_summary.h"

namespace cvo::reports {
namespace {

using Sentences = std::map<std::string, std::string>;

// Moves the frames of the run out of a sentence into the contract, because runs of different length
// share a column.
void ExtractFrames(const FrameSpan& run, std::string& sentence, Contract& contract) {
  const std::string words = StrCat("within frames ", run.first, " to ", run.last);
  const std::size_t at = sentence.find(words);
  if (at == std::string::npos) return;
  sentence.replace(at, words.size(), "within the frames of the run");
  contract.frames = run;
}

Contract UpgradedContract(Sentences sentences, const FrameSpan& run) {
  Contract contract;
  contract.poses = EnumOf<PoseTime>(sentences["poses"]);
  contract.truth = EnumOf<TruthSource>(sentences["truth"]);
  std::string text;
  for (const char* field : {"frame", "alignment", "pairing", "delta", "aggregation"}) {
    ExtractFrames(run, sentences[field], contract);
    text += StrCat(text.empty() ? "" : "; ", field, ": ", sentences[field]);
  }
  contract.sentences = text;
  return contract;
}

}  // namespace

Json UpgradedFromSchema2(Json result, const std::string& where) {
  result["upgraded_from"] = 2;
  if (!result.contains("metrics") || !result["metrics"].is_array()) return result;
  const Json* sequence = internal::FindField(result, "sequence", where);
  if (sequence == nullptr) internal::FailMissing("sequence", where);
  const FrameSpan run = FromJson<SequenceInfo>(*sequence, where + ", sequence").range();
  for (Json& metric : result["metrics"]) {
    const Json* stated = internal::FindField(metric, "contract", where + ", metrics");
    if (stated == nullptr) continue;
    const auto sentences = FromJson<Sentences>(*stated, where + ", metrics, contract");
    if (const auto left_out = sentences.find("left_out"); left_out != sentences.end()) {
      metric["left_out"] = left_out->second;
    }
    metric["contract"] = ToJson(UpgradedContract(sentences, run));
  }
  return result;
}

}  // namespace cvo::reports
