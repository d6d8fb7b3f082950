// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "synth/render/renderer.h"

namespace cvo::synth {

// Corrects the depth of triangles seen edge-on. Such a triangle may cover the centre of a pixel
// only because the rasteriser rounds vertices to 1/256 px. Its depth there is extrapolated, with
// errors of up to some decimetres. On a body, these pixels give points outside the body's box. They
// take the depth of the neighbour on the same body that is closest in depth to the centre of the
// box. Bodies without a size are left unchanged.
void CorrectEdgeDepth(const StereoCamera& rig, const std::vector<Body>& bodies, const View& view,
                      Rendering& rendering);

}  // namespace cvo::synth
