// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Runs frame by frame: the images of a run, and its paths seen from above. The paths are complete
// in the HTML; the script shows them up to the frame of its slider.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/number.h"
#include "core/files/text/utf8.h"
#include "reports/overlays/overlay_run.h"
#include "reports/page/page.h"

namespace cvo::reports {
namespace {

// Where something is in a frame, seen from above.
struct PathPoint {
  int frame = 0;
  double x_m = 0.0;  // to the right in the first image
  double z_m = 0.0;  // forward
  std::optional<double> error_m = {};
  bool is_marked = false;  // see Path::mark
};

struct Path {
  std::string kind;  // "truth", "camera" or "cluster"
  std::string name;
  std::string mark;    // what a marked point is, in words
  std::string colour;  // of a cluster
  std::vector<PathPoint> points = {};

  void Add(const PathPoint& point) {
    if (std::isfinite(point.x_m) && std::isfinite(point.z_m)) points.push_back(point);
  }
};

double Distance(const Pose& a, const Pose& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

std::string Hex(const Rgb& colour) {
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", colour.red, colour.green, colour.blue);
  return text.data();
}

// The camera, true and estimated.
std::vector<Path> CameraPaths(const RunDetail& detail) {
  Path truth{"truth", "true camera", "", ""};
  Path camera{"camera", "camera", "lost", ""};
  for (const CameraFrame& frame : detail.camera) {
    const Pose& pose = frame.world_from_camera;
    PathPoint point{frame.frame, pose[0], pose[2]};
    if (frame.truth) {
      truth.Add({frame.frame, (*frame.truth)[0], (*frame.truth)[2]});
      point.error_m = Distance(pose, *frame.truth);
    }
    point.is_marked = frame.status == "lost" || frame.status == "skipped";
    camera.Add(point);
  }
  return {truth, camera};
}

std::vector<Path> BodyPaths(const RunDetail& detail) {
  std::vector<Path> paths;
  for (const BodyDetail& body : detail.bodies) {
    Path path{"truth", "true " + body.name, "", ""};
    for (const auto& [frame, pose] : body.truth) path.Add({frame, pose[0], pose[2]});
    paths.push_back(std::move(path));
  }
  return paths;
}

// The errors of the body that each cluster is compared with, by cluster and frame.
using BodyErrors = std::map<std::pair<std::int64_t, int>, double>;

BodyErrors ErrorsOf(const RunDetail& detail) {
  BodyErrors errors;
  for (const BodyDetail& body : detail.bodies) {
    for (const auto* positions : {&body.estimated, &body.predicted}) {
      for (const BodyPosition& at : *positions) errors[{body.cluster, at.frame}] = at.error_m;
    }
  }
  return errors;
}

// The centres of the boxes of clusters, in the colours of the images.
std::vector<Path> ClusterPaths(const RunDetail& detail) {
  const BodyErrors errors = ErrorsOf(detail);
  std::map<std::int64_t, Path> paths;
  for (const ClusterRow& row : detail.clusters) {
    const std::string category = row.category.empty() ? "" : " (" + row.category + ")";
    Path& path = paths
                     .try_emplace(row.id, Path{"cluster", StrCat("cluster ", row.id, category),
                                               "hidden, predicted", Hex(ClusterColor(row.id))})
                     .first->second;
    const Eigen::Vector3d center =
        TransformOf(row.world_from_object) * TransformOf(row.object_from_box).translation();
    const auto error = errors.find({row.id, row.frame});
    path.Add({row.frame, center[0], center[2],
              error == errors.end() ? std::nullopt : std::optional(error->second), row.predicted});
  }
  std::vector<Path> list;
  for (auto& [id, path] : paths) list.push_back(std::move(path));
  return list;
}

std::vector<Path> PathsOf(const RunDetail& detail) {
  std::vector<Path> paths = BodyPaths(detail);
  for (Path& path : CameraPaths(detail)) paths.push_back(std::move(path));
  for (Path& path : ClusterPaths(detail)) paths.push_back(std::move(path));
  std::erase_if(paths, [](const Path& path) { return path.points.empty(); });
  return paths;
}

// The part of the ground that is shown. Predictions may be far off, so they do not count.
struct Extent {
  double left_m = 0.0, right_m = 0.0, near_m = 0.0, far_m = 0.0;

  double width_m() const { return right_m - left_m; }
  double height_m() const { return far_m - near_m; }
};

Extent ExtentOf(const std::vector<Path>& paths) {
  constexpr double kFar = 1e9;
  Extent extent{kFar, -kFar, kFar, -kFar};
  for (const Path& path : paths) {
    for (const PathPoint& point : path.points) {
      if (point.is_marked) continue;
      extent.left_m = std::min(extent.left_m, point.x_m);
      extent.right_m = std::max(extent.right_m, point.x_m);
      extent.near_m = std::min(extent.near_m, point.z_m);
      extent.far_m = std::max(extent.far_m, point.z_m);
    }
  }
  if (extent.left_m > extent.right_m) return {-1.0, 1.0, -1.0, 1.0};
  // A margin, and at least half as wide as high and the reverse.
  const double largest = std::max({extent.width_m(), extent.height_m(), 0.1});
  const double x_m = std::max(0.08 * largest, 0.25 * largest - 0.5 * extent.width_m());
  const double z_m = std::max(0.08 * largest, 0.25 * largest - 0.5 * extent.height_m());
  return {extent.left_m - x_m, extent.right_m + x_m, extent.near_m - z_m, extent.far_m + z_m};
}

std::int64_t Millimetres(double metres) { return std::llround(1e3 * metres); }

// Forward is up, and SVG counts down.
std::string PointText(double x_m, double z_m) {
  return StrCat(Millimetres(x_m), ",", Millimetres(-z_m));
}

std::string PathSvg(const Path& path) {
  const auto text = [&path](const auto& part) { return Joined(path.points, " ", part); };
  std::string marked;
  for (const PathPoint& point : path.points) {
    if (point.is_marked) marked += StrCat(marked.empty() ? "" : " ", point.frame);
  }
  std::string html = StrCat("<polyline class=\"", path.kind, "\" data-name=\"", Escaped(path.name),
                            "\" data-frames=\"", text(&PathPoint::frame), "\"");
  if (!path.colour.empty()) html += StrCat(" stroke=\"", path.colour, "\"");
  if (!marked.empty())
    html += StrCat(" data-mark=\"", path.mark, "\" data-marked=\"", marked, "\"");
  if (path.kind != "truth") {
    html += StrCat(" data-errors-mm=\"", text([](const PathPoint& point) {
                     const bool known = point.error_m && std::isfinite(*point.error_m);
                     return known ? FormatDouble(RoundedTo(1e3 * *point.error_m, 3)) : "-";
                   }),
                   "\"");
  }
  return StrCat(html, " points=\"",
                text([](const PathPoint& point) { return PointText(point.x_m, point.z_m); }),
                "\"><title>", Escaped(path.name), "</title></polyline>\n");
}

// A line of a round length, with that length.
std::string ScaleSvg(const Extent& extent) {
  double length_m = std::pow(10.0, std::floor(std::log10(extent.width_m() / 3.0)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * length_m > extent.width_m() / 3.0) continue;
    length_m *= factor;
    break;
  }
  const double margin_m = 0.03 * std::max(extent.width_m(), extent.height_m());
  const double x_m = extent.left_m + margin_m;
  const double z_m = extent.near_m + margin_m;
  return StrCat("<polyline class=\"scale\" points=\"", PointText(x_m, z_m), " ",
                PointText(x_m + length_m, z_m), "\"/>\n<text class=\"scale\" x=\"",
                Millimetres(x_m), "\" y=\"", Millimetres(-z_m - 0.4 * margin_m), "\">",
                FormatGeneral(length_m, 6), " m</text>\n");
}

std::string MapSvg(const RunDetail& detail, const std::string& name) {
  const std::vector<Path> paths = PathsOf(detail);
  const Extent extent = ExtentOf(paths);
  const double font_m = 0.035 * std::max(extent.width_m(), extent.height_m());
  std::string svg =
      StrCat("<svg class=\"map\" role=\"img\" aria-label=\"Paths of ", Escaped(name),
             " seen from above\" viewBox=\"", Millimetres(extent.left_m), " ",
             Millimetres(-extent.far_m), " ", Millimetres(extent.width_m()), " ",
             Millimetres(extent.height_m()), "\" font-size=\"", Millimetres(font_m), "\">\n");
  for (const Path& path : paths) svg += PathSvg(path);
  return svg + ScaleSvg(extent) + "</svg>\n";
}

// Without the script the image in the middle of the run is seen.
std::string ImagesHtml(const PageScene& scene) {
  if (scene.images.empty()) {
    return Element("p", scene.no_images.empty()
                            ? "Images are in the page for one estimator per sequence only."
                            : "No images: " + scene.no_images) +
           "\n";
  }
  std::string html = "<figure class=\"images\">\n";
  for (std::size_t i = 0; i < scene.images.size(); ++i) {
    const PageImage& image = scene.images[i];
    html += StrCat("<img data-frame=\"", image.frame, "\" alt=\"", Escaped(image.alt), "\"",
                   i == scene.images.size() / 2 ? "" : " hidden", " src=\"data:image/jpeg;base64,",
                   Base64(image.jpeg), "\">\n");
  }
  html += Element("figcaption", "Left image with what was estimated") + "\n";
  return html + "</figure>\n";
}

// The keys of a run other than its sequence, and its seed.
std::string RunName(const PlannedRun& run) {
  std::string name = KeyOf(run, "variant");
  for (const auto& [key, value] : run.keys) {
    if (key == "sequence" || key == "variant" || key == "detections" || value == "none") continue;
    name += StrCat(", ", key, " ", value);
  }
  return StrCat(name, ", seed ", run.seed);
}

// The runs on one sequence side by side, with one slider for all of them.
std::string SequenceHtml(const PageContent& content, const std::string& sequence,
                         const std::vector<const PageScene*>& scenes, std::size_t index) {
  std::map<int, std::int64_t> times;  // by frame
  for (const PageScene* scene : scenes) {
    for (const CameraFrame& frame : scene->detail.camera) {
      times.emplace(frame.frame, frame.timestamp_ns);
    }
  }
  const std::int64_t start_ns = times.empty() ? 0 : times.begin()->second;
  std::string runs;
  for (const PageScene* scene : scenes) {
    const std::string name = RunName(content.runs[scene->run].run.planned);
    runs += StrCat("<div class=\"run\">\n", Element("h3", name), "\n", ImagesHtml(*scene),
                   MapSvg(scene->detail, StrCat(sequence, ", ", name)),
                   "<ul class=\"words\"></ul>\n</div>\n");
  }
  return StrCat(
      "<details class=\"frames\" id=\"frames-", index + 1, "\"", index == 0 ? " open" : "",
      " data-frames=\"", Joined(times, " ", [](const auto& entry) { return entry.first; }),
      "\" data-times-ms=\"",
      Joined(times, " ", [&](const auto& entry) { return (entry.second - start_ns) / 1'000'000; }),
      "\">\n", Element("summary", StrCat(sequence, ": ", Counted(scenes.size(), "run"))),
      "\n<div class=\"player\" hidden><button type=\"button\">Play</button><input type=\"range\" "
      "min=\"0\" step=\"1\" aria-label=\"Frame\"><output></output></div>\n<div class=\"runs\">\n",
      runs, "</div>\n</details>\n");
}

}  // namespace

std::string FramesSection(const PageContent& content) {
  std::string html = "<section id=\"frames\">\n<h2>Frame by frame</h2>\n";
  if (content.scenes.empty()) {
    return html +
           "<p class=\"problem\">No run can be shown: none has trajectories.</p>\n</section>\n";
  }
  html +=
      "<p>Images and paths seen from above. Grey: the truth; black or white: the camera; colours: "
      "clusters, as on the images; dashed ring: hidden, predicted by the motion model.";
  if (content.scenes_left_out > 0) {
    html += StrCat(" The page holds ", Counted(content.scenes.size(), "run"), "; ",
                   content.scenes_left_out, " more would make it too large.");
  }
  html += "</p>\n";
  std::vector<std::pair<std::string, std::vector<const PageScene*>>> sequences;
  for (const PageScene& scene : content.scenes) {
    const std::string sequence = KeyOf(content.runs[scene.run].run.planned, "sequence");
    FindOrAdd(sequences, &decltype(sequences)::value_type::first, {sequence, {}})
        .second.push_back(&scene);
  }
  for (std::size_t i = 0; i < sequences.size(); ++i) {
    html += SequenceHtml(content, sequences[i].first, sequences[i].second, i);
  }
  return html + "</section>\n";
}

}  // namespace cvo::reports
