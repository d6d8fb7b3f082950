// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/temp_folder.h"

namespace cvo::test {

using Json = nlohmann::ordered_json;

// The part of a result.json that tables read, with ATE and coverage of 108 frames.
inline Json Result(const std::string& sequence = "2011_09_26_drive_0001", int frames = 108) {
  const Json contract = {{"frame", "left camera"},
                         {"poses", "refined"},
                         {"truth", "devkit"},
                         {"alignment", "SE(3) over positions, Umeyama without scale"},
                         {"pairing", "all frames with truth and estimate"},
                         {"delta", "none"},
                         {"aggregation", "root mean square of position errors"},
                         {"left_out", "1 frame"}};
  Json coverage = contract;
  coverage["alignment"] = "none";
  coverage["pairing"] = "all frames with truth";
  coverage["aggregation"] = "fraction with an estimate";
  return {{"schema_version", 2},
          {"kind", "run"},
          {"job", "job of " + sequence},
          {"status", "ok"},
          {"message", ""},
          {"variant", "static"},
          {"seed", 0},
          {"sequence",
           {{"name", sequence},
            {"type", "kitti-raw"},
            {"pair", "grey"},
            {"first_frame", 0},
            {"frames", frames},
            {"total_frames", frames}}},
          {"options", {{"orb", {{"features", 2000}}}}},
          {"build", {{"identity", "abc"}}},
          {"metrics",
           {{{"name", "camera_coverage"},
             {"value", 1.0},
             {"unit", "1"},
             {"n", frames},
             {"contract", coverage}},
            {{"name", "camera_ate"},
             {"value", 0.0625},
             {"unit", "m"},
             {"n", frames},
             {"contract", contract}}}}};
}

inline std::filesystem::path WriteResult(const TempFolder& folder, const std::string& name,
                                         const Json& result) {
  return folder.Write(name + "/result.json", result.dump());
}

}  // namespace cvo::test
