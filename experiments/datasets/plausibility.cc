// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/plausibility.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>

#include "core/association/box_association.h"
#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/number.h"

namespace cvo {
namespace {

// Adds the first of the findings and the number of the others.
void Tell(const std::vector<std::string>& found, std::vector<std::string>& lines) {
  if (found.empty()) return;
  const std::size_t others = found.size() - 1;
  lines.push_back(found[0] + (others > 0 ? StrCat(", and ", others, " more like it") : ""));
}

// Finds a baseline or a focal length that is most likely in another unit than metres and pixels,
// and a centre far from the middle of the image, or nearer to it with x and y swapped, or pixels
// far from square, as of another order.
void FindCalibration(const StereoCamera& camera, std::vector<std::string>& lines) {
  constexpr double kShortest_m = 0.01, kLongest_m = 3.0, kMostOff = 0.2, kLeastFocal = 0.1;
  const Eigen::Array3d off(camera.cx / camera.width_px - 0.5, camera.cy / camera.height_px - 0.5,
                           camera.fx / camera.fy - 1.0);
  const auto aside = [](double centre, int side_px) { return std::abs(centre - 0.5 * side_px); };
  const bool swapped = aside(camera.cx, camera.height_px) + aside(camera.cy, camera.width_px) <
                       aside(camera.cx, camera.width_px) + aside(camera.cy, camera.height_px);
  if (camera.width_px > 0 &&
      (swapped || off.abs().maxCoeff() > kMostOff || camera.fx < kLeastFocal * camera.width_px)) {
    lines.push_back(StrCat("calibration: fx ", camera.fx, ", fy ", camera.fy, ", cx ", camera.cx,
                           ", cy ", camera.cy, " px of a ", camera.width_px, "x", camera.height_px,
                           " image"));
  }
  if (camera.baseline_m == 0.0 ||
      (camera.baseline_m >= kShortest_m && camera.baseline_m <= kLongest_m))
    return;
  lines.push_back(StrCat("calibration: a baseline of ", camera.baseline_m,
                         " m (in another unit?), where ", kShortest_m, " to ", kLongest_m,
                         " m are usual"));
}

// Finds boxes in pixels of a larger image, such as one of twice the size.
void FindBoxesBeyond(const Sequence& sequence, const char* what,
                     const std::vector<ObjectBox>& boxes, std::vector<std::string>& lines) {
  constexpr double kMargin = 0.25;  // of a box; detectors guess what the image cuts off
  constexpr double kMost = 0.1;     // part of the boxes
  const StereoCamera& camera = sequence.camera;
  const auto beyond = std::ranges::count_if(boxes, [&](const ObjectBox& box) {
    return box.right_px > camera.width_px + kMargin * (box.right_px - box.left_px) ||
           box.bottom_px > camera.height_px + kMargin * (box.bottom_px - box.top_px);
  });
  if (static_cast<double>(beyond) <= kMost * static_cast<double>(boxes.size())) return;
  lines.push_back(StrCat(what, ": ", beyond, " of ", boxes.size(),
                         " boxes end beyond the image of ", camera.width_px, "x", camera.height_px,
                         " px"));
}

// Throws Error for boxes as fractions of the image.
void RefuseFractions(const std::filesystem::path& file, const std::vector<ObjectBox>& boxes) {
  constexpr double kLargest = 2.0;
  constexpr std::size_t kFewest = 3;
  double largest = 0.0;
  for (const ObjectBox& box : boxes) largest = std::max({largest, box.right_px, box.bottom_px});
  if (boxes.size() < kFewest || largest > kLargest || largest <= 0.0) return;
  ThrowError(file.string(), StrCat("boxes that end at ", largest, " or before"),
             "boxes in pixels, not in parts of the image");
}

// Finds boxes in pixels of a smaller image, or in per cent: all lie in a quarter of this one.
void FindHalfSize(const Sequence& sequence, const char* what, const std::vector<ObjectBox>& boxes,
                  std::vector<std::string>& lines) {
  constexpr std::size_t kFewest = 20;
  constexpr double kLargest = 0.525;  // detectors end boxes a little beyond the image
  const StereoCamera& camera = sequence.camera;
  const bool small = std::ranges::all_of(boxes, [&](const ObjectBox& box) {
    return box.right_px < kLargest * camera.width_px && box.bottom_px < kLargest * camera.height_px;
  });
  if (boxes.size() < kFewest || !small) return;
  lines.push_back(StrCat(what, ": all ", boxes.size(), " boxes lie in the upper left quarter of ",
                         "the image (of an image of half the size?)"));
}

// Finds boxes without extent, the name of a class or the shape that it has.
void FindUnusable(const char* what, const std::vector<ObjectBox>& boxes,
                  std::vector<std::string>& lines) {
  constexpr double kThinnest_px = 1.0, kMost = 0.05;
  constexpr double kMostOdd = 0.7;  // truncated and occluded ones have any shape
  std::size_t thin = 0, nameless = 0, shaped = 0, odd = 0;
  for (const ObjectBox& box : boxes) {
    const Eigen::Vector2d size_px(box.right_px - box.left_px, box.bottom_px - box.top_px);
    thin += !box.box3d && size_px.minCoeff() < kThinnest_px;
    const bool car = box.IsInImage() && (box.type == "Car" || box.type == "car");
    const bool person = box.type == "Pedestrian" || box.type == "person";
    shaped += car || person;
    odd += (car && size_px.y() > size_px.x()) || (person && size_px.x() > size_px.y());
    nameless +=
        std::ranges::none_of(box.type, [](unsigned char c) { return std::isalpha(c) != 0; });
  }
  for (const auto& [count, most, of, lack] :
       {std::tuple{thin, kMost, boxes.size(), "extent"},
        {nameless, kMost, boxes.size(), "a class name"},
        {odd, kMostOdd, shaped, "the shape of a car or a person"}}) {
    if (static_cast<double>(count) <= most * static_cast<double>(of)) continue;
    lines.push_back(StrCat(what, ": ", count, " of ", of, " boxes are without ", lack));
  }
}

void FindDoubled(const char* what, const std::vector<ObjectBox>& boxes,
                 std::vector<std::string>& lines) {
  std::set<std::tuple<int, std::string, double, double, double, double>> different;
  for (const ObjectBox& box : boxes) {
    different.insert({box.frame, box.type, box.left_px, box.top_px, box.right_px, box.bottom_px});
  }
  const std::size_t doubled = boxes.size() - different.size();
  constexpr double kMost = 0.05;
  if (static_cast<double>(doubled) <= kMost * static_cast<double>(boxes.size())) return;
  lines.push_back(StrCat(what, ": ", doubled, " of ", boxes.size(), " boxes repeat another one"));
}

// Finds tracks that end where they begin, as of ids that are no ids.
void FindShortTracks(const std::vector<ObjectBox>& labels, std::vector<std::string>& lines) {
  constexpr std::size_t kFewest = 20;
  std::set<int> tracks;
  for (const ObjectBox& box : labels) tracks.insert(box.track);
  if (labels.size() < kFewest || 2 * tracks.size() < labels.size()) return;
  lines.push_back(StrCat("labels: ", labels.size(), " boxes have ", tracks.size(), " track ids"));
}

// Finds boxes of a single frame, as of a file whose frames were lost.
void FindOneFrame(const Sequence& sequence, const char* what, const std::vector<ObjectBox>& boxes,
                  std::vector<std::string>& lines) {
  constexpr std::size_t kFewest = 10;  // boxes and frames
  if (std::min(boxes.size(), sequence.images.size()) < kFewest) return;
  for (const ObjectBox& box : boxes) {
    if (box.frame != boxes[0].frame) return;
  }
  lines.push_back(StrCat(what, ": all ", boxes.size(), " boxes are of frame ", boxes[0].frame));
}

// The part of the image that a box in 3D covers; nothing if it reaches behind the camera or out of
// view.
std::optional<ImageBox> InImage(const StereoCamera& camera, const ObjectBox::Box3d& box,
                                double left_offset_m) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double cosine = std::cos(box.heading_rad), sine = std::sin(box.heading_rad);
  ImageBox picture = {kInfinity, kInfinity, -kInfinity, -kInfinity};
  for (unsigned i = 0; i < 8; ++i) {
    const double along_m = ((i & 1U) != 0 ? 0.5 : -0.5) * box.length_m;
    const double across_m = ((i & 2U) != 0 ? 0.5 : -0.5) * box.width_m;
    const Eigen::Vector3d corner =
        box.bottom_in_camera + Eigen::Vector3d(left_offset_m + cosine * along_m + sine * across_m,
                                               (i & 4U) != 0 ? -box.height_m : 0.0,
                                               cosine * across_m - sine * along_m);
    if (corner.z() <= 0.0) return std::nullopt;
    Include(camera.fx * corner.x() / corner.z() + camera.cx,
            camera.fy * corner.y() / corner.z() + camera.cy, picture);
  }
  return ClipToImage(picture, camera);
}

// Finds values beyond what KITTI defines, and boxes in 3D that are elsewhere than those in the
// image, or of another size.
void FindOddBoxes(const Sequence& sequence, const char* what, const std::vector<ObjectBox>& boxes,
                  std::vector<std::string>& lines) {
  constexpr std::size_t kFewest = 5;
  constexpr double kLeast = 0.65;
  std::vector<std::string> odd;
  std::vector<double> shared;
  for (const ObjectBox& box : boxes) {
    const auto find = [&](const char* name, double value, double least, double most) {
      if (value >= least && value <= most) return;
      odd.push_back(StrCat(what, ", frame ", box.frame, ": ", name, " ", value, ", where ", least,
                           " to ", most, " are defined"));
    };
    find("occlusion", box.occlusion, -1.0, 3.0);
    find("truncation", box.truncation, -1.0, 2.0);
    if (!box.box3d) continue;
    find("heading", box.box3d->heading_rad, -6.3, 6.3);
    find("length", box.box3d->length_m, 0.0, 40.0);
    find("width", box.box3d->width_m, 0.0, 40.0);
    find("height", box.box3d->height_m, 0.0, 40.0);
    if (!box.IsInImage() || box.truncation > 0.0 || box.occlusion > 0) continue;
    const auto picture = InImage(sequence.camera, *box.box3d, sequence.left_offset_m);
    const ImageBox in_image = {box.left_px, box.top_px, box.right_px, box.bottom_px};
    shared.push_back(picture ? IntersectionOverUnion(in_image, *picture) : 0.0);
  }
  Tell(odd, lines);
  if (shared.size() < kFewest) return;
  // Of the best quarter, because others hide parts of many.
  std::ranges::sort(shared);
  const double best = shared[shared.size() * 3 / 4];
  if (best >= kLeast) return;
  lines.push_back(StrCat(what, ": three of four boxes in 3D share less than ",
                         FormatFixed(100.0 * best, 0),
                         " % with their boxes in the image (other places, sizes or headings?)"));
}

// Finds boxes that are cut at 1 and at the size of the image, as if pixels were counted from 1.
// Where no box is cut, one pixel is less than detectors differ by.
void FindOneBased(const Sequence& sequence, const char* what, const std::vector<ObjectBox>& boxes,
                  std::vector<std::string>& lines) {
  constexpr std::ptrdiff_t kFewest = 2;
  const int width_px = sequence.camera.width_px;
  const int height_px = sequence.camera.height_px;
  const auto count = [&](const auto& is) { return std::ranges::count_if(boxes, is); };
  const auto from_one =
      count([](const ObjectBox& box) { return std::min(box.left_px, box.top_px) == 1.0; });
  const auto to_end = count(
      [&](const ObjectBox& box) { return box.right_px == width_px || box.bottom_px == height_px; });
  const auto beyond = count([&](const ObjectBox& box) {
    return std::min(box.left_px, box.top_px) < 1.0 || box.right_px > width_px ||
           box.bottom_px > height_px;
  });
  if (from_one < kFewest || to_end < kFewest || beyond > 0) return;
  lines.push_back(StrCat(what, ": ", from_one, " boxes begin at 1 and ", to_end, " end at ",
                         width_px, " or ", height_px, ", none beyond (pixels counted from 1?)"));
}

// Finds intervals that are much longer than usual, or differ from each other.
void FindGaps(const Sequence& sequence, const std::vector<double>& steps_s,
              std::vector<std::string>& lines) {
  constexpr double kLongest = 5.0, kMostOff = 0.15;  // times the usual interval
  const double usual_s = Median(steps_s);
  std::vector<double> off;  // of the usual interval
  for (const double step_s : steps_s) {
    if (step_s <= kLongest * usual_s) off.push_back(std::abs(step_s / usual_s - 1.0));
  }
  if (MeanOf(off) > kMostOff) {
    lines.push_back(StrCat("times: intervals differ by ", FormatFixed(100.0 * MeanOf(off), 0),
                           " % in the mean from the usual ", usual_s, " s"));
  }
  std::vector<std::string> gaps;
  for (std::size_t i = 0; i < steps_s.size(); ++i) {
    if (steps_s[i] <= kLongest * usual_s) continue;
    gaps.push_back(StrCat("times, frame ", sequence.first_frame + static_cast<int>(i) + 1, ": ",
                          steps_s[i], " s after the one before, where ", usual_s, " s is usual"));
  }
  Tell(gaps, lines);
}

// Finds a camera that is faster, over ten frames, than cars are.
void FindSpeed(const Sequence& sequence, std::vector<std::string>& lines) {
  constexpr double kFastest_m_s = 60.0;
  constexpr std::size_t kApart = 10;
  const auto& truth = sequence.groundtruth_world_from_camera;
  std::vector<double> speeds_m_s;
  for (std::size_t i = 0; i + kApart < truth.size(); ++i) {
    const auto &from = truth[i], &to = truth[i + kApart];
    const auto time_ns = sequence.timestamps_ns[i + kApart] - sequence.timestamps_ns[i];
    if (!from || !to || time_ns <= 0) continue;
    speeds_m_s.push_back((to->translation() - from->translation()).norm() /
                         (1e-9 * static_cast<double>(time_ns)));
  }
  if (speeds_m_s.empty() || Median(speeds_m_s) <= kFastest_m_s) return;
  lines.push_back(StrCat("ground truth of the camera: a median speed of ",
                         FormatFixed(Median(speeds_m_s), 0), " m/s (another unit or rate?)"));
}

// Finds steps of the camera that are too fast, or much faster than the two before and after.
void FindJumps(const Sequence& sequence, const std::vector<double>& steps_s,
               std::vector<std::string>& lines) {
  constexpr double kFastest_m_s = 100.0, kMostFaster = 4.0;
  constexpr double kNoise_m = 1.0, kLeast_m = 0.1;  // of a measured ground truth
  const auto& truth = sequence.groundtruth_world_from_camera;
  std::vector<double> moved_m, speeds_m_s;  // infinite where unknown
  for (std::size_t i = 0; i + 1 < truth.size(); ++i) {
    moved_m.push_back(truth[i] && truth[i + 1]
                          ? (truth[i + 1]->translation() - truth[i]->translation()).norm()
                          : std::numeric_limits<double>::infinity());
    speeds_m_s.push_back(moved_m[i] / steps_s[i]);
  }
  std::vector<std::string> jumps;
  for (std::size_t i = 0; i < moved_m.size(); ++i) {
    if (!std::isfinite(moved_m[i])) continue;
    const bool too_fast = moved_m[i] > kNoise_m + kFastest_m_s * steps_s[i];
    const bool alone =
        moved_m[i] > kLeast_m && speeds_m_s[i] > kMostFaster * LargestAround(speeds_m_s, i);
    if (!too_fast && !alone) continue;
    jumps.push_back(StrCat("ground truth of the camera, frame ",
                           sequence.first_frame + static_cast<int>(i) + 1, ": ", moved_m[i],
                           " m from the one before, ", steps_s[i], " s earlier"));
  }
  Tell(jumps, lines);
}

}  // namespace

double LargestAround(const std::vector<double>& values, std::size_t i) {
  if (i < 2 || i + 2 >= values.size()) return std::numeric_limits<double>::infinity();
  return std::max({values[i - 2], values[i - 1], values[i + 1], values[i + 2]});
}

std::vector<double> TimeSteps(const Sequence& sequence) {
  std::vector<double> steps_s;
  for (std::size_t i = 1; i < sequence.timestamps_ns.size(); ++i) {
    steps_s.push_back(
        1e-9 * static_cast<double>(sequence.timestamps_ns[i] - sequence.timestamps_ns[i - 1]));
  }
  return steps_s;
}

void RefuseImpossible(const Sequence& sequence) {
  constexpr double kShortest_s = 0.001;
  const std::vector<double> steps_s = TimeSteps(sequence);
  if (!steps_s.empty() && Median(steps_s) < kShortest_s) {
    ThrowError(sequence.folder.string() + ", times",
               StrCat("a median of ", Median(steps_s), " s per frame"),
               "at most 1000 frames per second (is their unit another one?)");
  }
  RefuseFractions(sequence.box_sources.detections, sequence.detections);
  RefuseFractions(sequence.box_sources.labels, sequence.labels);
}

std::vector<std::string> FindImplausible(const Sequence& sequence, std::size_t repeated,
                                         int threads) {
  constexpr double kMostRepeated = 0.05, kSlowest_s = 1.0;
  std::vector<std::string> lines = sequence.notes;
  FindCalibration(sequence.camera, lines);
  const BoxSources& sources = sequence.box_sources;
  for (const auto& [what, boxes, file] :
       {std::tuple{"detections", &sequence.detections, &sources.detections},
        {"labels", &sequence.labels, &sources.labels}}) {
    if (std::filesystem::is_regular_file(*file) && std::filesystem::is_empty(*file)) {
      lines.push_back(StrCat(what, ": ", file->string(), " is empty"));
    }
    FindBoxesBeyond(sequence, what, *boxes, lines);
    FindHalfSize(sequence, what, *boxes, lines);
    FindUnusable(what, *boxes, lines);
    FindDoubled(what, *boxes, lines);
    FindOneFrame(sequence, what, *boxes, lines);
    FindOddBoxes(sequence, what, *boxes, lines);
    FindOneBased(sequence, what, *boxes, lines);
  }
  FindShortTracks(sequence.labels, lines);
  const std::size_t frames = sequence.images.size();
  if (static_cast<double>(repeated) > kMostRepeated * static_cast<double>(frames)) {
    lines.push_back(StrCat("images: ", repeated, " of ", frames, " frames repeat the one before"));
  }
  const std::vector<double> steps_s = TimeSteps(sequence);
  if (steps_s.empty()) return lines;
  const double step_s = Median(steps_s);
  if (step_s >= kSlowest_s) lines.push_back(StrCat("times: a median of ", step_s, " s per frame"));
  FindGaps(sequence, steps_s, lines);
  FindJumps(sequence, steps_s, lines);
  FindSpeed(sequence, lines);
  const bool rendered = std::filesystem::exists(sequence.folder / "manifest.json");
  if (!rendered && PerturbationToJson(sequence.perturbation).empty()) {
    FindInImages(sequence, step_s, threads, lines);
  }
  return lines;
}

}  // namespace cvo
