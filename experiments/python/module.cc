// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// The compiled half of the package clustervo: cvo::StereoOdometry with its inputs and outputs.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <opencv2/core/mat.hpp>

#include "core/base/error.h"
#include "core/interface/frame.h"
#include "variants/registry.h"
#include "variants/stereo_odometry.h"

namespace cvo {
namespace {

namespace py = pybind11;
using namespace py::literals;  // NOLINT

using GreyArray = py::array_t<std::uint8_t, py::array::c_style>;

// A row per landmark with the columns of landmarks.csv that are known in a frame; cluster 0 is the
// static scene, -1 none.
struct LandmarkRow {
  std::int64_t id, cluster;
  double u_px, v_px, u_right_px, x, y, z;
};

// A row per frame.
struct PoseRow {
  std::int64_t frame, timestamp_ns;
  bool tracked;
  double x, y, z, qx, qy, qz, qw, vx, vy, vz;
};

void CopyMatrix(const RigidTransform& pose, double* to) {
  const Eigen::Matrix4d transposed = pose.Matrix().transpose();
  std::copy(transposed.data(), transposed.data() + transposed.size(), to);
}

// Returns the array row by row, without copying where it is. Throws Error unless it is of uint8.
GreyArray GreyArrayOf(const char* name, const py::array& array) {
  if (py::isinstance<py::array_t<std::uint8_t>>(array)) return array;
  ThrowError(StrCat(name, " image"), std::string(py::str(array.dtype())), "uint8");
}

// Wraps the pixels of the array without copying them. Throws Error unless it has two dimensions.
cv::Mat GreyImage(const char* name, const GreyArray& array) {
  if (array.ndim() != 2) {
    ThrowError(StrCat(name, " image"), StrCat(array.ndim(), " dimensions"),
               "2, the rows and columns of a grey image");
  }
  return cv::Mat(static_cast<int>(array.shape(0)), static_cast<int>(array.shape(1)), CV_8UC1,
                 const_cast<std::uint8_t*>(array.data()));
}

py::array_t<double> ToArray(const Eigen::Vector3d& vector) {
  return py::array_t<double>(3, vector.data());
}

py::array_t<double> ToArray(const RigidTransform& pose) {
  py::array_t<double> array({4, 4});
  CopyMatrix(pose, array.mutable_data());
  return array;
}

py::array_t<double> ToArray(const std::vector<RigidTransform>& poses) {
  py::array_t<double> array(
      {static_cast<py::ssize_t>(poses.size()), py::ssize_t{4}, py::ssize_t{4}});
  for (std::size_t i = 0; i < poses.size(); ++i)
    CopyMatrix(poses[i], array.mutable_data() + 16 * i);
  return array;
}

py::array LandmarkRowsOf(const std::vector<LandmarkReport>& landmarks,
                         const std::vector<StereoFeature>& features) {
  py::array_t<LandmarkRow> rows(static_cast<py::ssize_t>(landmarks.size()));
  std::transform(
      landmarks.begin(), landmarks.end(), rows.mutable_data(), [&](const LandmarkReport& landmark) {
        const Eigen::Vector3d& z = features.at(landmark.feature).z_px;
        const Eigen::Vector3d& p = landmark.p_in_world;
        return LandmarkRow{
            landmark.id.value, landmark.cluster.value, z[0], z[1], z[2], p.x(), p.y(), p.z()};
      });
  return rows;
}

py::array PoseRowsOf(const std::vector<ClusterPose>& poses) {
  py::array_t<PoseRow> rows(static_cast<py::ssize_t>(poses.size()));
  std::transform(poses.begin(), poses.end(), rows.mutable_data(), [](const ClusterPose& pose) {
    const auto t = pose.world_from_object.translation();
    const auto q = pose.world_from_object.rotation();
    const Eigen::Vector3d& v = pose.velocity_m_s;
    const bool tracked = pose.status == ClusterStatus::kTracked;
    return PoseRow{pose.frame, pose.timestamp_ns,
                   tracked,    t.x(),
                   t.y(),      t.z(),
                   q.x(),      q.y(),
                   q.z(),      q.w(),
                   v.x(),      v.y(),
                   v.z()};
  });
  return rows;
}

// A frame as reported by the estimator, with its landmarks already converted to an array.
struct Frame {
  FrameReport report;
  py::array landmarks;
};

Frame MakeFrame(FrameReport report, const std::vector<StereoFeature>& features) {
  py::array landmarks = LandmarkRowsOf(report.landmarks, features);
  report.landmarks.clear();
  return {std::move(report), std::move(landmarks)};
}

py::dict OptionDefaults(const std::string& variant) {
  py::dict defaults;
  const Options options = StereoOdometry::DefaultsOf(variant);
  VisitLeaves(options, [&](const std::string& path, const auto& value, const FieldInfo&) {
    defaults[py::str(path)] = value;
  });
  return defaults;
}

void SetOption(const std::string& name, const py::handle& value, Options& options) {
  bool known = false;
  VisitLeaves(options, [&]<typename T>(const std::string& path, T& field, const FieldInfo&) {
    if (path != name) return;
    known = true;
    try {
      field = value.cast<T>();
    } catch (const py::cast_error&) {
      ThrowError(StrCat("option ", name), py::repr(value),
                 StrCat("a value as ", std::string(py::repr(py::cast(field)))));
    }
  });
  if (!known) ThrowError("options", StrCat("\"", name, "\""), "a key of clustervo.options()");
}

py::dict VariantNames() {
  py::dict names;
  for (const VariantInfo& variant : Variants()) names[py::str(variant.name)] = variant.changes;
  return names;
}

std::unique_ptr<StereoOdometry> MakeOdometry(const StereoCamera& camera, const std::string& variant,
                                             const std::map<std::string, py::object>& options,
                                             std::uint64_t seed, int threads) {
  StereoOdometrySetup setup{.camera = camera, .variant = variant, .seed = seed, .threads = threads};
  setup.options = StereoOdometry::DefaultsOf(variant);
  for (const auto& [name, value] : options) SetOption(name, value, *setup.options);
  return std::make_unique<StereoOdometry>(setup);
}

Frame Process(StereoOdometry& odometry, const py::array& left, const py::array& right,
              std::int64_t timestamp_ns, const std::vector<Detection>& boxes) {
  const GreyArray of_left = GreyArrayOf("left", left);
  const GreyArray of_right = GreyArrayOf("right", right);
  const cv::Mat left_image = GreyImage("left", of_left);
  const cv::Mat right_image = GreyImage("right", of_right);
  FrameReport report;
  {
    const py::gil_scoped_release release;
    report = odometry.Process(left_image, right_image, timestamp_ns, boxes);
  }
  return MakeFrame(std::move(report), odometry.features());
}

void AddInput(py::module_& m) {
  py::class_<StereoCamera>(m, "Camera", "A rectified stereo pair; intrinsics in px.")
      .def(py::init([](double fx, double fy, double cx, double cy, double baseline_m, int width_px,
                       int height_px, double right_shift_px) {
             return StereoCamera{fx, fy, cx, cy, baseline_m, width_px, height_px, right_shift_px};
           }),
           py::kw_only(), "fx"_a, "fy"_a, "cx"_a, "cy"_a, "baseline_m"_a, "width_px"_a,
           "height_px"_a, "right_shift_px"_a = 0.0);
  py::class_<Detection>(m, "Box", "A rigid body that a detector found in the left image.")
      .def(py::init([](double left, double top, double right, double bottom, std::string category,
                       double score) {
             return Detection{{left, top, right, bottom}, std::move(category), score};
           }),
           "left_px"_a, "top_px"_a, "right_px"_a, "bottom_px"_a, "category"_a, "score"_a = 1.0);
}

void AddOutput(py::module_& m) {
  using Report = ClusterReport;
  py::class_<Report>(m, "Cluster", "A rigid body in one frame.")
      .def_property_readonly("id", [](const Report& c) { return c.id.value; })
      .def_readonly("category", &Report::category)
      .def_property_readonly("status", [](const Report& c) { return ToString(c.status); })
      .def_property_readonly("world_from_object",
                             [](const Report& c) { return ToArray(c.world_from_object); })
      .def_property_readonly("velocity_m_s",
                             [](const Report& c) { return ToArray(c.velocity_m_s); })
      .def_property_readonly("center_in_object",
                             [](const Report& c) { return ToArray(c.center_in_object); })
      .def_property_readonly("half_size_m", [](const Report& c) { return ToArray(c.half_size_m); })
      .def_property_readonly(
          "object_from_box", [](const Report& c) { return ToArray(c.box.object_from_box); },
          "The upright box: its axes are along length, height (down) and width.")
      .def_property_readonly(
          "box_size_m", [](const Report& c) { return ToArray(c.box.size_m); },
          "Length, height and width of the upright box.")
      .def_readonly("observed_landmarks", &Report::observed_landmarks)
      .def_readonly("detection", &Report::detection, "Index of its box; -1: none.")
      .def_readonly("score", &Report::score);
  py::class_<Frame>(m, "Frame", "What the estimator says of one frame.")
      .def_property_readonly("status", [](const Frame& f) { return ToString(f.report.status); })
      .def_property_readonly("world_from_camera",
                             [](const Frame& f) { return ToArray(f.report.world_from_camera); })
      .def_property_readonly("features", [](const Frame& f) { return f.report.features; })
      .def_property_readonly("inliers", [](const Frame& f) { return f.report.inliers; })
      .def_property_readonly("clusters", [](const Frame& f) { return f.report.clusters; })
      .def_readonly("landmarks", &Frame::landmarks);
  py::class_<ClusterTrajectory>(m, "ClusterTrajectory", "A rigid body over all of its frames.")
      .def_property_readonly("id", [](const ClusterTrajectory& c) { return c.id.value; })
      .def_readonly("category", &ClusterTrajectory::category)
      .def_property_readonly("poses",
                             [](const ClusterTrajectory& c) { return PoseRowsOf(c.poses); });
}

}  // namespace

PYBIND11_MODULE(_clustervo, m) {
  m.attr("__version__") = CVO_VERSION;
  PYBIND11_NUMPY_DTYPE(LandmarkRow, id, cluster, u_px, v_px, u_right_px, x, y, z);
  PYBIND11_NUMPY_DTYPE(PoseRow, frame, timestamp_ns, tracked, x, y, z, qx, qy, qz, qw, vx, vy, vz);
  py::register_exception<Error>(m, "Error", PyExc_ValueError);
  m.def("variants", &VariantNames, "What each variant changes, by its name.");
  m.def("options", &OptionDefaults, "The options that a variant starts from, by name.",
        "variant"_a = "full");
  AddInput(m);
  AddOutput(m);
  py::class_<StereoOdometry>(m, "StereoOdometry",
                             "Stereo visual odometry that finds moving rigid bodies.")
      .def(py::init(&MakeOdometry), "camera"_a, "variant"_a = "full",
           "options"_a = std::map<std::string, py::object>(), "seed"_a = 0, "threads"_a = 1)
      .def("process", &Process, "left"_a, "right"_a, "timestamp_ns"_a,
           "boxes"_a = std::vector<Detection>(), "One rectified grey pair; returns a Frame.")
      .def(
          "skip",
          [](StereoOdometry& odometry, std::int64_t timestamp_ns) {
            return MakeFrame(odometry.Skip(timestamp_ns), odometry.features());
          },
          "timestamp_ns"_a, "A frame without images; returns a Frame.")
      .def(
          "trajectory",
          [](const StereoOdometry& odometry) { return ToArray(odometry.Trajectory()); },
          "world_from_camera of all frames so far, refined: N x 4 x 4.")
      .def("clusters", &StereoOdometry::ClusterTrajectories,
           "All bodies so far with a refined pose per frame.");
}

}  // namespace cvo
