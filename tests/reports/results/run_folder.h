// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tests/reports/results/result_files.h"

namespace cvo::test {

inline Json PoseAt(double x, double y, double z) { return {x, y, z, 0.0, 0.0, 0.0, 1.0}; }

// The files of a run of frames 10, 11 and 12. The estimated camera moves 1 m per frame along z; the
// true one is 0.5 m to its right, and unknown in frame 12. Body 3, matched to cluster 7, is
// estimated in the first two frames and predicted in the last.
struct RunFiles {
  Json result = {{"schema_version", 3}, {"kind", "run"}, {"frames", Json::array()}};
  Json truth = {{"schema_version", 1}, {"kind", "truth"}, {"job", "a"}, {"camera", Json::array()}};
  Json timing = TimingOf("detect", 2.0);
  std::string objects =
      "frame,timestamp_ns,id,category,status,x,y,z,qx,qy,qz,qw,vx,vy,vz,refined_status,refined_x,"
      "refined_y,"
      "refined_z,refined_qx,refined_qy,refined_qz,refined_qw,refined_vx,refined_vy,refined_vz,"
      "center_x,center_y,center_z,half_x_m,half_y_m,half_z_m,"
      "box_x,box_y,box_z,box_qx,box_qy,box_qz,box_qw,length_m,height_m,width_m,"
      "left_px,top_px,right_px,bottom_px,"
      "observed_landmarks,detection,score\n"
      "11,2,7,car,tracked,9,9,9,0,0,0,1,9,9,9,tracked,1,2,3,0,0,0,1,0.1,0.2,0.3,4,5,6,0.4,0.5,0.6,"
      "7,7,7,0,"
      "1,0,0,4,1.5,2,"
      "0,0,1,1,20,0,0.9\n"
      "12,3,7,car,predicted,7,8,9,0,0,0,1,0.7,0.8,0.9,,,,,,,,,,,,4,5,6,0.4,0.5,0.6,7,7,7,0,1,0,0,4,"
      "1.5,2,,,,,0,,0\n";

  RunFiles() {
    for (int i = 0; i < 3; ++i) {
      result["frames"].push_back({{"frame", 10 + i},
                                  {"timestamp_ns", i + 1},
                                  {"status", i == 0 ? "first" : "tracked"},
                                  {"refined", PoseAt(0.0, 0.0, i)}});
      truth["camera"].push_back(i == 2 ? Json(nullptr) : PoseAt(0.5, 0.0, i));
    }
    truth["bodies"] = {
        {{"id", 3},
         {"name", "the car"},
         {"category", "car"},
         {"mover", true},
         {"diagonal_m", 2.5},
         {"cluster", 7},
         {"truth",
          {{"frames", {0, 1, 2}},
           {"poses", {PoseAt(1, 0, 5), PoseAt(1, 0, 6), PoseAt(1, 0, 7)}},
           {"visible", {true, true, false}}}},
         {"estimated", {{"frames", {0, 1}}, {"positions_m", {{1.0, 0.0, 5.0}, {1.3, 0.4, 6.0}}}}},
         {"predicted", {{"frames", {2}}, {"positions_m", {{1.0, 0.0, 9.0}}}}}}};
  }
  void Write(const TempFolder& folder) const {
    folder.Write("result.json", result.dump());
    folder.Write("truth.json", truth.dump());
    folder.Write("timing.json", timing.dump());
    folder.Write("objects.csv", objects);
  }
};

}  // namespace cvo::test
