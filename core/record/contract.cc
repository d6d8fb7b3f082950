// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/record/contract.h"

#include "core/base/error.h"

namespace cvo::reports {
namespace {

// Visits the fields of two contracts pairwise, in their order: visit(name, value in a, value in b).
template <typename Visit>
class PairVisitor {
 public:
  PairVisitor(const Json& other, Visit& visit) : other_(other), visit_(visit) {}

  template <typename T>
  void Optional(const char* key, const std::optional<T>& value) {
    const auto found = other_.find(key);
    visit_(key, ToJson(value), found == other_.end() ? Json() : *found);
  }

 private:
  const Json& other_;
  Visit& visit_;
};

template <typename Visit>
void ForEachField(const Contract& a, const Contract& b, Visit visit) {
  const Json other = ToJson(b);
  PairVisitor<Visit> visitor(other, visit);
  Contract::VisitFields(a, visitor);
}

}  // namespace

Contract ColumnContract(const Contract& contract, const FrameSpan& run) {
  Contract column = WithTruthOf(contract, Contract());
  if (column.frames == run) column.frames = kFramesOfRun;
  return column;
}

Contract WithTruthOf(Contract contract, const Contract& other) {
  contract.truth = other.truth;
  contract.camera_truth = other.camera_truth;
  contract.visible = other.visible;
  contract.right_shift_px = other.right_shift_px;
  return contract;
}

std::string FirstDifference(const Contract& a, const Contract& b) {
  std::string first;
  ForEachField(a, b, [&](const char* name, const Json& in_a, const Json& in_b) {
    if (first.empty() && in_a != in_b) first = name;
  });
  return first;
}

std::string ContradictingField(const Contract& a, const Contract& b) {
  std::string first;
  ForEachField(a, b, [&](const char* name, const Json& in_a, const Json& in_b) {
    if (first.empty() && !in_a.is_null() && !in_b.is_null() && in_a != in_b) first = name;
  });
  return first;
}

std::vector<std::string> UnstatedFields(const Contract& contract, const Contract& wanted) {
  std::vector<std::string> unstated;
  ForEachField(contract, wanted, [&](const char* name, const Json& stated, const Json& asked) {
    if (stated.is_null() && !asked.is_null()) unstated.emplace_back(name);
  });
  return unstated;
}

std::string FieldText(const Contract& contract, const std::string& field) {
  const Json json = ToJson(contract);
  const auto found = json.find(field);
  if (found == json.end()) return "";
  return found->is_string() ? found->get<std::string>() : found->dump();
}

namespace {

std::string Joined(const std::string& a, const std::string& b) {
  return a.empty() || b.empty() ? a + b : a + "; " + b;
}

template <typename E>
std::string Name(const std::optional<E>& value) {
  return value ? NameOf(*value) : "";
}

std::string SubjectText(const Contract& contract) {
  std::string text = Name(contract.subject);
  if (!contract.travel_m) return text;
  if (contract.subject == Subject::kLandmarks) {
    return StrCat(text, " observed in a frame; moving: its point of the body moved by more than ",
                  *contract.travel_m, " m within ", contract.travel_frames.value_or(0),
                  " frames, now or before");
  }
  const char* limit = contract.subject == Subject::kStanding ? "at most " : "more than ";
  return StrCat("bodies that travel ", limit, *contract.travel_m, " m, in the world of the truth");
}

std::string MatchingText(const Contract& contract) {
  if (contract.matching == Matching::kNearness) {
    return "cluster of a body: by nearness (1 - distance of the centres seen from the camera / "
           "diagonal of the true box)";
  }
  if (contract.matching != Matching::kLandmarks) return "";
  std::string text = "cluster of a body: by shared landmarks";
  if (contract.least_landmarks) {
    text += StrCat("; an estimate counts with at least ", *contract.least_landmarks,
                   " observed landmarks");
  }
  return text;
}

std::string FramesText(const Contract& contract) {
  if (!contract.frames) return "";
  if (contract.frames == kFramesOfRun) return "within the frames of the run";
  return StrCat("within frames ", contract.frames->first, " to ", contract.frames->last);
}

std::string VisibleText(const Contract& contract) {
  if (!contract.visible) return "";
  const Visibility& visible = *contract.visible;
  switch (visible.by) {
    case VisibleBy::kMask:
      return StrCat("visible: at least ", visible.least_px, " px of its mask and ", visible.limit,
                    " % unoccluded");
    case VisibleBy::kLabel:
      return StrCat("visible: label occlusion 0 to ", visible.limit, " and a box of at least ",
                    visible.least_px, " px in height");
    case VisibleBy::kCentre:
      return "visible: its centre in the left image";
    case VisibleBy::kLandmarks:
      return StrCat("visible: at least ", visible.limit, " of its landmarks in the left image");
  }
  throw Error("VisibleBy: not one of the enumerators");
}

// An alignment in a few words, for titles.
const char* Brief(Alignment alignment) {
  switch (alignment) {
    case Alignment::kNone:
      return "not aligned";
    case Alignment::kPositions:
      return "aligned by SE(3) over positions";
    case Alignment::kWorld:
    case Alignment::kWorldAndBody:
      return "aligned in the world frame by the camera";
    case Alignment::kSeen:
    case Alignment::kSeenAndBody:
      return "compared as the camera sees them";
    case Alignment::kAllPoses:
      return "aligned by one transform over all poses";
    case Alignment::kAllMotions:
      return "aligned by one transform over all motions";
    case Alignment::kFirstMotions:
      return "aligned by one transform over 25 frames";
  }
  throw Error("Alignment: not one of the enumerators");
}

const char* Brief(Delta delta) {
  if (delta == Delta::kKittiLengths) return "100 to 800 m";
  return delta == Delta::kCentral ? "central difference" : NameOf(delta);
}

}  // namespace

std::string TruthText(const Contract& contract) {
  std::string text = Name(contract.truth);
  if (contract.camera_truth) text += ", camera " + Name(contract.camera_truth);
  return Joined(text, VisibleText(contract));
}

std::string CorrectionText(const Contract& contract) {
  const double shift_px = contract.right_shift_px.value_or(0.0);
  return shift_px == 0.0 ? "" : StrCat("u_right shifted by ", shift_px, " px");
}

std::vector<std::pair<std::string, std::string>> ContractTexts(const Contract& contract) {
  std::string aggregation = Name(contract.aggregation);
  if (contract.limit_m) {
    aggregation = Joined(aggregation, StrCat("limit ", 100.0 * *contract.limit_m, " cm"));
  }
  const std::string pairing =
      Joined(Joined(Name(contract.pairing), MatchingText(contract)), FramesText(contract));
  std::vector<std::pair<std::string, std::string>> texts;
  const auto add = [&texts](const char* name, const std::string& text) {
    if (!text.empty() && text != NameOf(Delta::kNone)) texts.emplace_back(name, text);
  };
  add("aggregation", aggregation);
  add("pairing", pairing);
  add("delta", Name(contract.delta));
  add("alignment", Name(contract.alignment));
  add("poses", Name(contract.poses));
  add("frame", SubjectText(contract));
  add("truth", TruthText(contract));
  add("correction", CorrectionText(contract));
  return texts;
}

std::string RelationText(const Contract& contract) {
  std::string text = "delta not stated, ";
  if (contract.delta) {
    text = contract.delta == Delta::kNone ? "" : StrCat("delta ", Brief(*contract.delta), ", ");
  }
  return text + (contract.alignment ? Brief(*contract.alignment) : "alignment not stated");
}

}  // namespace cvo::reports
