// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "synth/render/renderer.h"

namespace cvo::synth {

// A triangle seen edge-on may cover a pixel's centre only because the rasteriser rounds its corners
// to 1/256 px; its depth there is extrapolated, by decimetres at worst. Such pixels of bodies show
// as points outside of the body's box: they take the depth of the neighbour of the same body that
// is nearest to the box's middle. Bodies without a size are left alone.
void CorrectEdgeDepth(const StereoCamera& rig, const std::vector<Body>& bodies, const View& view,
                      Rendering& rendering);

}  // namespace cvo::synth
