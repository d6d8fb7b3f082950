// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/association/image_box.h"
#include "core/geometry/stereo_camera.h"

namespace cvo {

// The part of the box within the left image. Empty where no pixel of the image is inside.
[[nodiscard]] std::optional<ImageBox> ClipToImage(const ImageBox& box, const StereoCamera& camera);

}  // namespace cvo
