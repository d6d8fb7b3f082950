// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/write/dataset.h"

#include <algorithm>
#include <memory>
#include <set>

#include "core/base/error.h"
#include "core/files/images/image_file.h"
#include "core/files/json/options_json.h"
#include "core/files/sha256.h"
#include "core/files/text/closest_names.h"
#include "core/files/text_file.h"
#include "synth/detector/detector.h"
#include "synth/render/renderer.h"
#include "synth/truth/truth.h"
#include "synth/write/render_cache.h"
#include "synth_sources.h"

namespace cvo::synth {
namespace {

namespace fs = std::filesystem;

bool Among(const std::vector<std::string>& list, const std::string& name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

// Returns the options of the level that the scene names, and removes "level" from `values`.
DetectorOptions TakeLevel(const std::string& where, Json& values) {
  if (!values.contains("level")) return DetectorLevel("good");
  const Json level = values["level"];
  values.erase("level");
  if (!level.is_string() || !Among(DetectorLevels(), level)) {
    ThrowError(where + ": detector.level", level.dump(), "\"oracle\", \"good\" or \"poor\"");
  }
  return DetectorLevel(level);
}

constexpr char kReplaceable[] =
    "a new folder or a sequence that this program wrote, as it wrote it";

// Whether the folder is <cache>/scenes/<name>-<key>/<name>, which belongs to this program, damaged
// or not.
bool IsSceneOfCache(const fs::path& folder) {
  std::error_code none;
  const fs::path below = fs::relative(folder, ScenesFolder(CacheFolder()), none);
  return std::distance(below.begin(), below.end()) == 2 && *below.begin() != "..";
}

// Throws Error if the folder holds a file that its manifest does not list.
void RequireNothingElse(const fs::path& folder, const Manifest& manifest) {
  std::set<fs::path> named = {folder / kManifestName};
  for (const FileRecord& file : manifest.files) named.insert(folder / file.name);
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (named.contains(entry.path()) || (entry.is_directory() && !entry.is_symlink())) continue;
    ThrowError(entry.path().string(), "a file that manifest.json does not name", kReplaceable);
  }
}

CleanRender ChooseFrames(const DatasetSource& source, const RenderRequest& request,
                         const World& world) {
  const int end = request.frames.end.value_or(world.frames);
  if (request.frames.first < 0 || end > world.frames || request.frames.first >= end) {
    ThrowError(source.scene + ", frames", StrCat(request.frames.first, ":", end),
               StrCat("a range within 0:", world.frames));
  }
  return {request.frames.first, end - request.frames.first, source.sensor.motion_blur};
}

CachedRender Draw(const DatasetSource& source, const RenderRequest& request, const fs::path& cache,
                  const std::string& key, TaskPool& pool) {
  const World world = source.build_world();
  const CleanRender render = ChooseFrames(source, request, world);
  return AddCachedRender(cache, key, [&](FolderBuild& build) {
    WriteCleanRender(world, render, source.open_tools(world), pool, request.hooks, build);
    Manifest manifest;
    manifest.scene = source.scene;
    manifest.frames = {render.first_frame, render.frames};
    manifest.image = {world.rig.width_px, world.rig.height_px};
    manifest.rig_error = world.rig_error;
    manifest.renderer = source.version;
    manifest.program_sources = kSynthSources;
    return manifest;
  });
}

cv::Mat ReadClean(const fs::path& path) {
  cv::Mat image = ReadImageFile(path, cv::IMREAD_UNCHANGED);
  if (image.empty() || image.type() != CV_8UC1)
    ThrowError(path.string(), "no grey image", "a clean render");
  return image;
}

// Writes both images of all frames, in small batches so that a stop takes effect soon.
void WriteImages(const DatasetSource& source, const RenderRequest& request, std::uint64_t seed,
                 const CachedRender& clean, TaskPool& pool, FolderBuild& build) {
  const int total = clean.manifest.frames.count;
  const int batch = 4 * request.threads;
  for (int begin = 0; begin < total; begin += batch) {
    request.hooks.ThrowIfStopped();
    const int count = std::min(batch, total - begin);
    pool.ParallelFor(2 * count, [&](int i) {
      const int camera = i % 2;
      const int frame = begin + i / 2;
      const std::string name = StrCat("image_", camera, "/", SixDigits(frame), ".png");
      build.Write(name, EncodePng(ApplySensor(ReadClean(clean.folder / name), source.sensor, seed,
                                              camera, clean.manifest.frames.first + frame)));
    });
    request.hooks.Report(begin + count, total, "apply the sensor");
  }
}

std::vector<double> ReadTimes_s(const fs::path& path) {
  const TextFile file(path);
  std::vector<double> times_s;
  for (std::size_t i = 0; i < file.size(); ++i) times_s.push_back(TextRow(file, i).Number(0));
  return times_s;
}

void WriteDetections(const DatasetSource& source, std::uint64_t seed, const CachedRender& clean,
                     FolderBuild& build) {
  const ObjectTable table =
      ReadObjectTable(clean.folder / "objects.csv", ReadTimes_s(clean.folder / "times.txt"));
  const DetectorInput input = {clean.manifest.image.width_px, clean.manifest.image.height_px,
                               table.categories, table.frames};
  for (const NamedDetector& detector : source.detectors) {
    build.Write("detections/" + detector.name + ".txt",
                FormatDetections(Detect(input, detector.options, seed)));
  }
}

// The content of scene.json: what the folder was made from.
Json DescriptionOf(const DatasetSource& source, std::uint64_t seed) {
  Json description = source.description;
  description["seed"] = seed;
  return description;
}

bool IsSensorImage(const std::string& name) {
  return name.starts_with("image_0/") || name.starts_with("image_1/");
}

}  // namespace

SensorOptions ReadSensor(const Json& section, const std::string& where) {
  SensorOptions options;
  MergeOptions(section, where + ": sensor", OptionLeaves(options));
  return options;
}

std::vector<NamedDetector> ReadDetectors(const Json& section, const std::string& where,
                                         const std::vector<std::string>& chosen) {
  Json values = section;
  DetectorOptions custom = TakeLevel(where, values);
  MergeOptions(values, where + ": detector", OptionLeaves(custom));

  std::vector<NamedDetector> detectors;
  std::vector<std::string> names = DetectorLevels();
  for (const std::string& name : names) detectors.push_back({name, DetectorLevel(name)});
  if (!values.empty()) {
    detectors.push_back({"custom", custom});
    names.emplace_back("custom");
  }
  for (const std::string& name : chosen) {
    if (Among(names, name)) continue;
    ThrowError("detector level", Quoted(name) + DidYouMean(name, names),
               names.size() > 3 ? "oracle, good, poor or custom" : "oracle, good or poor");
  }
  if (!chosen.empty()) {
    std::erase_if(detectors, [&](const NamedDetector& d) { return !Among(chosen, d.name); });
  }
  return detectors;
}

std::string DrawingKey(const DatasetSource& source, const RenderRequest& request) {
  return Sha256Hex(StrCat("clustervo render 1\n", source.render_key, "\nframes ",
                          request.frames.first, ":", request.frames.end.value_or(-1), "\n",
                          kSynthSources, "\n", source.version.gl, "\n", source.version.renderer));
}

std::string DatasetKey(const DatasetSource& source, const RenderRequest& request) {
  std::string text = StrCat("clustervo dataset 1\n", DrawingKey(source, request), "\n",
                            DumpJson(DescriptionOf(source, request.seed.value_or(source.seed))));
  for (const NamedDetector& detector : source.detectors) text += detector.name + "\n";
  return Sha256Hex(text);
}

void RequireReplaceable(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::exists(folder, ignored)) return;
  if (!fs::is_directory(folder, ignored)) ThrowError(folder.string(), "a file", kReplaceable);
  if (fs::is_empty(folder, ignored) || IsSceneOfCache(folder)) return;
  std::optional<Manifest> manifest;
  try {
    manifest = ReadManifest(folder);
  } catch (const Error&) {
    ThrowError(folder.string(), "other files in it", kReplaceable);
  }
  RequireNothingElse(folder, *manifest);
}

void WriteDataset(const DatasetSource& source, const RenderRequest& request,
                  const fs::path& folder) {
  RequireReplaceable(folder);
  FolderBuild build(folder);  // first, so that an unwritable target fails before rendering
  TaskPool pool(request.threads);
  const fs::path cache = CacheFolder();
  const std::string key = DrawingKey(source, request);
  std::optional<CachedRender> found = FindCachedRender(cache, key, pool, request.hooks);
  const CachedRender clean = found ? *found : Draw(source, request, cache, key, pool);

  const std::uint64_t seed = request.seed.value_or(source.seed);
  const bool images_as_drawn = HasNoEffect(source.sensor);
  for (const FileRecord& file : clean.manifest.files) {
    if (images_as_drawn || !IsSensorImage(file.name)) build.Link(clean.folder, file);
  }
  if (!images_as_drawn) WriteImages(source, request, seed, clean, pool, build);
  WriteDetections(source, seed, clean, build);
  build.Write("scene.json", DumpJson(DescriptionOf(source, seed)));
  request.hooks.ThrowIfStopped();
  Manifest manifest = clean.manifest;
  manifest.scene = source.scene;
  manifest.seed = seed;
  build.Commit(manifest, Existing::kReplace);
}

DrawingTools OpenRenderer(const World& world) {
  const auto renderer = std::make_shared<Renderer>(world);
  return {[renderer](const View& view) { return renderer->Draw(view); },
          [renderer](const View& view, cv::Mat& left, cv::Mat& right) {
            renderer->DrawImages(view, left, right);
          }};
}

DatasetSource SourceOf(const SceneDescription& scene, const RenderRequest& request) {
  DatasetSource source;
  source.scene = scene.name();
  source.description = scene.json();
  source.render_key = RenderKeyText(scene);
  source.seed = scene.seed();
  source.sensor = ReadSensor(scene.sensor(), scene.where());
  source.detectors = ReadDetectors(scene.detector(), scene.where(), request.detector_levels);
  source.version = FindRendererVersion();
  source.build_world = [scene, threads = request.threads] { return BuildWorld(scene, threads); };
  source.open_tools = OpenRenderer;
  return source;
}

void WriteDataset(const SceneDescription& scene, const RenderRequest& request,
                  const std::filesystem::path& folder) {
  WriteDataset(SourceOf(scene, request), request, folder);
}

}  // namespace cvo::synth
