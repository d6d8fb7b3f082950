// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/page/glossary.h"

#include <array>
#include <string_view>
#include <utility>

namespace cvo::reports {
namespace {

using Meaning = std::pair<std::string_view, const char*>;

constexpr std::array<Meaning, 20> kMeanings = {{
    {"camera_coverage", "Part of the frames in which the camera has a position."},
    {"camera_ate",
     "Absolute trajectory error of the camera: distance between estimated and true positions after "
     "the two trajectories are laid over each other; root mean square over frames."},
    {"camera_rrpe_all_pairs",
     "Relative rotation error of the camera between every two frames of a run."},
    {"camera_trpe_all_pairs",
     "Relative translation error of the camera between every two frames of a run."},
    {"object_success_5cm",
     "Part of all object-frames that should be seen in which the object is within 5 cm of the "
     "truth. One that is missed counts as a failure."},
    {"object_success_10cm",
     "Part of all object-frames that should be seen in which the object is within 10 cm of the "
     "truth. One that is missed counts as a failure."},
    {"object_success_20cm",
     "Part of all object-frames that should be seen in which the object is within 20 cm of the "
     "truth. One that is missed counts as a failure."},
    {"object_coverage",
     "Part of the frames in which an object should be seen and has an estimate. An error without "
     "it favours who loses what is hard."},
    {"object_ate",
     "Absolute trajectory error of moving objects, in the world of the camera: no object is "
     "aligned by itself. Over the frames that have an estimate."},
    {"object_rrpe_all_pairs", "Relative rotation error of objects between every two frames."},
    {"object_trpe_all_pairs", "Relative translation error of objects between every two frames."},
    {"object_motion_r", "Error of the rotation that an object makes from one frame to the next."},
    {"object_motion_t",
     "Error of the translation that an object makes from one frame to the next."},
    {"object_velocity", "Error of the speed of objects."},
    {"object_id_switches", "How often a true object gets another id."},
    {"object_fragments", "How often the estimate of an object breaks off and begins again."},
    {"object_unmatched_clusters", "Clusters that belong to no true object."},
    {"moving_precision", "Part of the landmarks said to move that do move."},
    {"moving_recall", "Part of the landmarks that move and are said to."},
    {"clustering_iou", "Overlap of the landmarks of a cluster with those of its true object."},
}};

}  // namespace

std::vector<Term> Terms() {
  return {
      {"variant",
       "One form of the estimator. full is the whole method; the others lack or change one part."},
      {"cluster", "A set of landmarks that move together: the estimate of one object."},
      {"landmark", "A point in the scene that is seen in the images."},
      {"sequence", "A recorded or rendered drive of images with its truth."},
      {"seed",
       "A number that starts the random draws. Runs that differ only in the seed show how much is "
       "chance."},
      {"interval",
       "Where 95 % of the values lie when the bodies (or scenes) that a mean is made of are drawn "
       "again at random. Seeds are averaged first."},
      {"pair", "A body or scene that both rows of a difference have."},
      {"occluded, predicted", "Hidden by something else; then only the motion model says where."},
      {"left out", "What does not count in a value, and why."},
  };
}

std::string MeasureMeaning(const std::string& metric) {
  for (const auto& [name, meaning] : kMeanings) {
    if (metric == name) return meaning;
  }
  return "As defined below.";
}

}  // namespace cvo::reports
