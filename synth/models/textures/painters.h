// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "synth/models/textures/canvas.h"
#include "synth/models/textures/texture.h"

namespace cvo::synth {

// Each function paints one material. Texture sizes in metres are those of the real material.
Texture PaintWood(Rng& rng);
Texture PaintParquet(Rng& rng);
Texture PaintFabric(Rng& rng);
Texture PaintCarpet(Rng& rng);
Texture PaintTiles(Rng& rng);
Texture PaintPoster(Rng& rng);
Texture PaintWallpaper(Rng& rng);
Texture PaintEmbossed(Rng& rng);
Texture PaintPlaster(Rng& rng);
Texture PaintBlock(Rng& rng);

Texture PaintBrick(Rng& rng);
Texture PaintConcrete(Rng& rng);
Texture PaintAsphalt(Rng& rng);
Texture PaintPavement(Rng& rng);
Texture PaintGrass(Rng& rng);
Texture PaintLeaves(Rng& rng);
Texture PaintBark(Rng& rng);
Texture PaintCarPaint(Rng& rng);
Texture PaintFacade(Rng& rng);
Texture PaintRoof(Rng& rng);

}  // namespace cvo::synth
