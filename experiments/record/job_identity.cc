// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/record/job_identity.h"

#include "core/files/sha256.h"

namespace cvo {

std::string JobIdentity(const Job& job) {
  return Sha256Hex(DumpJson({{"build", job.build},
                             {"variant", job.variant},
                             {"options", job.options},
                             {"content", job.content},
                             {"detections", job.detections},
                             {"given", job.given},
                             {"seed", job.seed}}));
}

std::string DetectionsHash(const Sequence& sequence) {
  Json boxes = Json::array();
  for (const ObjectBox& box : sequence.detections) {
    boxes.push_back({box.frame, box.type, box.left_px, box.top_px, box.right_px, box.bottom_px,
                     box.score ? Json(*box.score) : Json(nullptr)});
  }
  return Sha256Hex(DumpJson({{"offset_m", sequence.detections_offset_m}, {"boxes", boxes}}));
}

Json GivenToJson(const std::vector<std::string>& classes, const std::vector<std::string>& oracle) {
  return {{"classes", classes}, {"oracle", oracle}};
}

}  // namespace cvo
