// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/record/bodies_json.h"

#include <optional>

namespace cvo {
namespace {

Json OrNull(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json ErrorsToJson(const std::vector<ObjectFrameError>& errors) {
  Json frames = Json::array();
  Json positions_m = Json::array();
  for (const ObjectFrameError& error : errors) {
    frames.push_back(error.frame);
    positions_m.push_back(error.position_m);
  }
  return {{"frames", frames}, {"position_m", positions_m}};
}

void AddRelative(const char* name, const std::optional<RelativeErrors>& errors, Json& body) {
  const std::string prefix = name;
  body[prefix + "_rad"] = errors ? Json(errors->rotation_rad) : Json(nullptr);
  body[prefix + "_m"] = errors ? Json(errors->translation_m) : Json(nullptr);
}

}  // namespace

Json BodiesToJson(const std::vector<BodyScore>& bodies) {
  Json list = Json::array();
  for (const BodyScore& score : bodies) {
    Json body = {{"id", score.id},
                 {"name", score.name},
                 {"category", score.category},
                 {"mover", score.mover},
                 {"travel_m", score.travel_m},
                 {"cluster", score.cluster},
                 {"visible_frames", score.visible_frames},
                 {"estimated_frames", score.estimated_frames},
                 {"id_switches", score.continuity.id_switches},
                 {"fragments", score.continuity.fragments},
                 {"ate_m", OrNull(score.ate_m)},
                 {"predicted_ate_m", OrNull(score.predicted_ate_m)},
                 {"velocity_m_s", OrNull(score.velocity_m_s)}};
    AddRelative("all_pairs", score.all_pairs, body);
    AddRelative("one_frame", score.one_frame, body);
    AddRelative("motion", score.motion, body);
    body["errors"] = ErrorsToJson(score.errors);
    body["predicted"] = ErrorsToJson(score.predicted);
    list.push_back(std::move(body));
  }
  return list;
}

}  // namespace cvo
