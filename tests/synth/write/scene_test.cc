// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <stdlib.h>

#include <opencv2/core.hpp>

#include "core/files/images/image_codec.h"
#include "synth/truth/object_table.h"
#include "synth/write/write_scene.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"

namespace cvo::synth {
namespace {

// The first frame of `tiny`, drawn by the real renderer.
TEST(WriteScene, TruthAgreesWithWhatIsDrawn) {
  const std::string missing = ErrorMessage([] { FindRendererVersion(); });
  if (!missing.empty()) GTEST_SKIP() << missing;
  const cvo::test::TempFolder temp;
  ::setenv("CLUSTERVO_CACHE", (temp.path() / "cache").c_str(), 1);
  RenderRequest request;
  request.frames = {0, 1};
  request.detector_levels = {"oracle"};
  const auto set = temp.path() / "set";
  WriteDataset(SceneDescription::Load("tiny", {}), request, set);
  ::unsetenv("CLUSTERVO_CACHE");

  const ObjectTable table = ReadObjectTable(set / "objects.csv", {0.0});
  ASSERT_FALSE(table.frames[0].bodies.empty());
  const cv::Mat depth = ReadImageFile(set / "depth_0/000000.tiff", cv::IMREAD_UNCHANGED);
  const cv::Mat mask = ReadImageFile(set / "instance_0/000000.png", cv::IMREAD_UNCHANGED);
  for (const BodyTruth& body : table.frames[0].bodies) {
    ASSERT_TRUE(body.visible_box && body.amodal_box);
    // Where nothing occludes its rim, a mask ends within a pixel of the projected mesh.
    EXPECT_GE(body.visible_box->left, body.amodal_box->left - 0.1);
    EXPECT_LE(body.visible_box->right, body.amodal_box->right + 0.1);
    EXPECT_NEAR(body.visible_box->top, body.amodal_box->top, 1.1);
    const double radius_m = table.sizes_m[static_cast<std::size_t>(body.id - 1)].norm() / 2.0;
    double nearest_m = 0.0, farthest_m = 0.0;
    cv::minMaxLoc(depth, &nearest_m, &farthest_m, nullptr, nullptr, mask == body.id);
    const double middle_m = body.state.world_from_body.translation().z();
    EXPECT_GT(nearest_m, middle_m - radius_m);
    EXPECT_LT(farthest_m, middle_m + radius_m);
  }
}

}  // namespace
}  // namespace cvo::synth
