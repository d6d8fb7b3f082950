// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/record/job_identity.h"

#include "core/files/sha256.h"

namespace cvo {

std::string IdentityHead(const std::string& build, const std::string& variant,
                         const Json& options) {
  const std::string text = DumpJson({{"build", build}, {"variant", variant}, {"options", options}});
  return text.substr(0, text.rfind("\n}")) + ",";
}

// The hash of a JSON object whose first members are those of the head.
std::string JobIdentity(const std::string& head, const JobInput& input) {
  const std::string text = DumpJson({{"content", input.content},
                                     {"detections", input.detections},
                                     {"given", input.given},
                                     {"seed", input.seed}});
  return Sha256Hex(head + text.substr(1));
}

std::string JobIdentity(const Job& job) {
  return JobIdentity(IdentityHead(job.build, job.variant, job.options),
                     {job.content, job.detections, job.given, job.seed});
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
