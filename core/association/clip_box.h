// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/association/image_box.h"
#include "core/geometry/stereo_camera.h"

namespace cvo {

// Returns the part of the box within the left image. Empty if the box is outside the image.
[[nodiscard]] std::optional<ImageBox> ClipToImage(const ImageBox& box, const StereoCamera& camera);

}  // namespace cvo
