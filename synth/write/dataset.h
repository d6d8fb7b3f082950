// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/task_pool.h"
#include "core/files/json/json.h"
#include "synth/detector/detector.h"
#include "synth/render/renderer.h"
#include "synth/scene/description.h"
#include "synth/scene/world.h"
#include "synth/sensor/sensor.h"
#include "synth/write/render_cache.h"

namespace cvo::synth {

// Encodes a PNG with the fast run-length strategy. For 8-bit images the result is as small as at
// higher levels, in a third of the time, since noise does not compress.
std::string EncodePng(const cv::Mat& image);
// Encodes masks (16 bits) as PNG with the default strategy, which pays off for their large
// uniform areas.
std::string EncodeMaskPng(const cv::Mat& image);

// Encodes CV_32FC1 as lossless TIFF (Deflate with the floating-point predictor): a sixth of the raw
// size, in 6 ms for 640x480. OpenCV's own writer cannot compress floats.
std::string EncodeDepthTiff(const cv::Mat& depth);

// The functions of a renderer, or of a substitute in tests.
struct DrawingTools {
  std::function<Rendering(const View&)> draw;
  std::function<void(const View&, cv::Mat& left, cv::Mat& right)> draw_images;
};

struct CleanRender {
  int first_frame = 0;
  int frames = 0;
  MotionBlurOptions motion_blur;
};

View ViewAt(const World& world, double time_s);

// Writes everything in a sequence that does not depend on a seed: clean images, depth, masks,
// poses and tables. Renders on the calling thread while the pool encodes and
// writes the last few frames. Throws Stopped.
void WriteCleanRender(const World& world, const CleanRender& render, const DrawingTools& tools,
                      TaskPool& pool, const WorkHooks& hooks, FolderBuild& out);

// Returns the default options, overridden by the "sensor" section of a scene. `where` names the
// scene in errors.
SensorOptions ReadSensor(const Json& section, const std::string& where);

// A detector whose detections are written to detections/<name>.txt.
struct NamedDetector {
  std::string name;
  DetectorOptions options;
};

// Returns the detectors of a sequence: every level, plus "custom" if the "detector" section of the
// scene overrides values of its "level" (default "good"). If `chosen` is not empty, returns only
// the detectors with these names. Throws Error for an unknown key, value or name.
std::vector<NamedDetector> ReadDetectors(const Json& section, const std::string& where,
                                         const std::vector<std::string>& chosen);

// Frames [first, end) of a scene; without `end`, up to its last frame.
struct SceneFrames {
  int first = 0;
  std::optional<int> end;
};

struct RenderRequest {
  SceneFrames frames;
  std::optional<std::uint64_t> seed;         // overrides the scene's
  std::vector<std::string> detector_levels;  // empty: all
  int threads = 2;
  WorkHooks hooks;
};

// A scene in the form that WriteDataset needs. `build_world` and `open_tools` are called only if
// the cache has no matching render.
struct DatasetSource {
  std::string scene;
  Json description;        // for scene.json
  std::string render_key;  // text that determines the render, except frames and program
  std::uint64_t seed = 0;
  SensorOptions sensor;
  std::vector<NamedDetector> detectors;
  RendererVersion version;
  std::function<World()> build_world;
  std::function<DrawingTools(const World&)> open_tools;
};

// Returns the cache key of the clean render. It does not depend on the seed, the detectors or the
// sensor (except motion blur), so requests that differ only in these share an entry.
std::string DrawingKey(const DatasetSource& source, const RenderRequest& request);
// Returns a key of everything that WriteDataset would write.
std::string DatasetKey(const DatasetSource& source, const RenderRequest& request);

// Throws Error if WriteDataset would refuse to replace what is at `folder`: a file, a folder with
// other content, or a dataset with files that its manifest does not list. Scenes in the cache are
// always replaced.
void RequireReplaceable(const std::filesystem::path& folder);

// Writes a sequence in the layout of KITTI odometry, plus the ground truth (synth/README.md). Takes
// the clean render from the cache, or renders it into the cache first. The folder appears complete
// or not at all, and only if RequireReplaceable allows it. Throws Stopped.
void WriteDataset(const DatasetSource& source, const RenderRequest& request,
                  const std::filesystem::path& folder);

// Opens a renderer of `world`, which must outlive it. It belongs to the calling thread.
DrawingTools OpenRenderer(const World& world);

// Prepares a scene for WriteDataset. Throws Error for a mistake in its sensor or detector section,
// and if this build cannot render (see Renderer).
DatasetSource SourceOf(const SceneDescription& scene, const RenderRequest& request);

// Renders a scene into a folder, or takes it from the cache; see WriteDataset in dataset.h.
void WriteDataset(const SceneDescription& scene, const RenderRequest& request,
                  const std::filesystem::path& folder);

// Returns a contact sheet, CV_8UC3 (BGR): eleven frames spread over the scene's frames [first,
// end), as left images in colour with tinted masks, visible boxes and names, and a map of the paths
// of the camera and the bodies from above. Throws Stopped.
cv::Mat MakeContactSheet(const World& world, int first, int end, const DrawingTools& tools,
                         const WorkHooks& hooks);

// Returns one colour (BGR) per body; those of consecutive bodies are easy to distinguish.
std::vector<cv::Scalar> BodyColours(std::size_t bodies);

// Draws the scene from above, with the world's x to the right and y up: the paths over frames
// [first, end) of the camera (black) and of the bodies (in their colours, with their boxes at the
// start), and a dot at the end of each path. Fills `canvas` (CV_8UC3).
void DrawPathMap(const World& world, int first, int end, const std::vector<cv::Scalar>& colours,
                 cv::Mat canvas);

}  // namespace cvo::synth
