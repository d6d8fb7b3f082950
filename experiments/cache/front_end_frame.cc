// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cache/front_end_frame.h"

#include <cstdint>

#include "core/base/error.h"
#include "core/files/bytes.h"

namespace cvo {
namespace {

constexpr std::size_t kFeatureBytes = 3 * sizeof(double) + sizeof(std::int32_t) +
                                      6 * sizeof(float) + sizeof(std::uint8_t) +
                                      sizeof(Descriptor) + sizeof(FeaturePatch::pixels);

void AppendFeature(const StereoFeature& feature, std::string& bytes) {
  for (const double coordinate_px : feature.z_px) AppendNumber(coordinate_px, bytes);
  AppendNumber(static_cast<std::int32_t>(feature.octave), bytes);
  AppendNumber(feature.angle_rad, bytes);
  AppendNumber(feature.response, bytes);
  AppendNumber(feature.disagreement_px, bytes);
  AppendNumber(feature.row_offset_px, bytes);
  AppendNumber(static_cast<std::uint8_t>(feature.is_reserve), bytes);
  for (const std::uint64_t word : feature.descriptor) AppendNumber(word, bytes);
  AppendNumber(feature.patch.corner_u, bytes);
  AppendNumber(feature.patch.corner_v, bytes);
  bytes.append(feature.patch.pixels.begin(), feature.patch.pixels.end());
}

StereoFeature TakeFeature(ByteReader& reader) {
  StereoFeature feature;
  for (double& coordinate_px : feature.z_px) coordinate_px = reader.Number<double>();
  feature.octave = reader.Number<std::int32_t>();
  feature.angle_rad = reader.Number<float>();
  feature.response = reader.Number<float>();
  feature.disagreement_px = reader.Number<float>();
  feature.row_offset_px = reader.Number<float>();
  feature.is_reserve = reader.Number<std::uint8_t>() != 0;
  for (std::uint64_t& word : feature.descriptor) word = reader.Number<std::uint64_t>();
  feature.patch.corner_u = reader.Number<float>();
  feature.patch.corner_v = reader.Number<float>();
  for (std::uint8_t& pixel : feature.patch.pixels) pixel = reader.Number<std::uint8_t>();
  return feature;
}

}  // namespace

std::string EncodeFrame(const FrontEndFrame& frame) {
  std::string bytes;
  bytes.reserve(64 + frame.features.size() * kFeatureBytes);
  AppendNumber(static_cast<std::uint32_t>(frame.problems.size()), bytes);
  for (const SideProblem& problem : frame.problems) {
    AppendNumber(static_cast<std::int32_t>(problem.side), bytes);
    AppendNumber(static_cast<std::uint32_t>(problem.reason.size()), bytes);
    bytes += problem.reason;
  }
  AppendNumber(static_cast<std::uint32_t>(frame.features.size()), bytes);
  for (const StereoFeature& feature : frame.features) AppendFeature(feature, bytes);
  return bytes;
}

FrontEndFrame DecodeFrame(std::string_view bytes) {
  ByteReader reader(bytes);
  FrontEndFrame frame;
  const auto problems = reader.Number<std::uint32_t>();
  for (std::uint32_t i = 0; i < problems; ++i) {
    SideProblem problem;
    problem.side = reader.Number<std::int32_t>();
    if (problem.side != 0 && problem.side != 1) {
      ThrowError("side of an image pair", StrCat(problem.side), "0 or 1");
    }
    problem.reason = reader.Take(reader.Number<std::uint32_t>());
    frame.problems.push_back(std::move(problem));
  }
  const auto features = reader.Number<std::uint32_t>();
  if (reader.left() != features * kFeatureBytes) {
    ThrowError("features", StrCat(reader.left(), " bytes"), StrCat(features * kFeatureBytes));
  }
  frame.features.reserve(features);
  for (std::uint32_t i = 0; i < features; ++i) frame.features.push_back(TakeFeature(reader));
  return frame;
}

}  // namespace cvo
