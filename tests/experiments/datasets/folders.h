// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Writers of small data set folders in the KITTI layouts.

#include <cstdio>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/files/images/image_file.h"
#include "tests/support/temp_folder.h"

namespace cvo {

constexpr int kTestWidth_px = 12;
constexpr int kTestHeight_px = 8;

inline std::string Digits(int number, int width) {
  std::string digits = std::to_string(number);
  return std::string(static_cast<std::size_t>(width) - digits.size(), '0') + digits;
}

inline std::string EncodePng(const cv::Mat& image) { return EncodeImage(".png", image); }

inline std::string GreyPng(int width_px = kTestWidth_px, int height_px = kTestHeight_px) {
  cv::Mat image(height_px, width_px, CV_8UC1);
  for (int i = 0; i < width_px * height_px; ++i) {
    image.at<unsigned char>(i / width_px, i % width_px) = static_cast<unsigned char>(i * 7);
  }
  return EncodePng(image);
}

inline void WriteImages(const test::TempFolder& root, const std::string& folder, int count,
                        int digits) {
  for (int i = 0; i < count; ++i) root.Write(folder + "/" + Digits(i, digits) + ".png", GreyPng());
}

// fx = fy = 10, so that P(0,3) = 10 times the offset in metres.
inline std::string ProjectionRow(double offset_m) {
  return StrCat("10 0 6 ", 10.0 * offset_m, " 0 10 4 0 0 0 1 0");
}

constexpr const char* kIdentityRows = "1 0 0 0 1 0 0 0 1";

// An OxTS packet of 30 numbers at 49 degrees north, displaced to the east by `east_m`.
inline std::string OxtsPacketText(double east_m, const std::string& last = "0") {
  char longitude[32];
  std::snprintf(longitude, sizeof longitude, "%.15g", 8.0 + east_m / 73034.4);
  std::string text = StrCat("49 ", longitude, " 100 0 0 0");
  for (int i = 6; i < 29; ++i) text += " 0";
  return text + " " + last + "\n";
}

inline std::string DateTimeRow(int frame, int offset_us = 0) {
  return "2011-09-26 13:02:" + Digits(10 + frame / 10, 2) + "." + Digits(frame % 10, 1) +
         Digits(10'000 + offset_us, 5) + "000\n";
}

// Writes <root>/2011_09_26/2011_09_26_drive_0001_sync with its calibration. Vehicle x (forward) is
// camera z, as on the KITTI vehicle. Moves 1 m forward per frame.
inline std::filesystem::path WriteRawDrive(const test::TempFolder& root, int frames = 3) {
  const std::string date = "2011_09_26/";
  const std::string drive = date + "2011_09_26_drive_0001_sync/";
  std::string calibration = "calib_time: 09-Jan-2012 13:57:47\ncorner_dist: 9.950000e-02\n";
  const double offsets_m[] = {0.0, -0.5, 0.06, -0.44};
  for (int camera = 0; camera < 4; ++camera) {
    calibration += StrCat("S_rect_0", camera, ": ", kTestWidth_px, " ", kTestHeight_px, "\n");
    calibration += StrCat("R_rect_0", camera, ": ", kIdentityRows, "\n");
    calibration += StrCat("P_rect_0", camera, ": ", ProjectionRow(offsets_m[camera]), "\n");
  }
  root.Write(date + "calib_cam_to_cam.txt", calibration);
  root.Write(date + "calib_velo_to_cam.txt", "R: 0 -1 0 0 0 -1 1 0 0\nT: 0 0 0\n");
  root.Write(date + "calib_imu_to_velo.txt", StrCat("R: ", kIdentityRows, "\nT: 0 0 0\n"));
  std::string times;
  for (int i = 0; i < frames; ++i) {
    times += DateTimeRow(i);
    root.Write(drive + "oxts/data/" + Digits(i, 10) + ".txt", OxtsPacketText(i));
  }
  for (const char* image : {"image_00", "image_01"}) {
    WriteImages(root, drive + image + "/data", frames, 10);
    root.Write(drive + image + "/timestamps.txt", times);
  }
  return root.path() / date / "2011_09_26_drive_0001_sync";
}

// Writes <root>/sequences/06 and <root>/poses/06.txt, with a motion of 1 m forward per frame.
inline std::filesystem::path WriteOdometrySequence(const test::TempFolder& root, int frames = 3) {
  const std::string folder = "sequences/06/";
  std::string times, poses;
  for (int i = 0; i < frames; ++i) {
    times += StrCat(i, ".000000e-01\n");
    poses += StrCat("1 0 0 0 0 1 0 0 0 0 1 ", i, i + 1 < frames ? "\n" : "");
  }
  root.Write(folder + "times.txt", times);
  root.Write("poses/06.txt", poses);
  root.Write(folder + "calib.txt",
             StrCat("P0: ", ProjectionRow(0.0), "\nP1: ", ProjectionRow(-0.5), "\n"));
  WriteImages(root, folder + "image_0", frames, 6);
  WriteImages(root, folder + "image_1", frames, 6);
  return root.path() / "sequences/06";
}

inline std::string TrackingCalibration(bool with_colons) {
  const double offsets_m[] = {0.0, -0.5, 0.06, -0.44};
  std::string text;
  for (int camera = 0; camera < 4; ++camera) {
    text += StrCat("P", camera, ": ", ProjectionRow(offsets_m[camera]), "  \n");
  }
  const std::string rotation = kIdentityRows;
  const std::string velo = "0 -1 0 0 0 0 -1 0 1 0 0 0";
  const std::string imu = "1 0 0 0 0 1 0 0 0 0 1 0";
  return text + (with_colons ? "R0_rect: " : "R_rect ") + rotation + "  \n" +
         (with_colons ? "Tr_velo_to_cam: " : "Tr_velo_cam ") + velo + "  \n" +
         (with_colons ? "Tr_imu_to_velo: " : "Tr_imu_velo ") + imu + "  \n\n";
}

constexpr const char* kCarLabel =
    "0 7 Car 0 1 -1.5 4.5 1 9.5 6 1.5 1.6 3.7 1 1.5 4 0.25\n"
    "1 -1 DontCare -1 -1 -10 1 1 2 2 -1000 -1000 -1000 -10 -1 -1 -1\n";

// Writes <root>/training with sequence 0005, in colour folders only.
inline std::filesystem::path WriteTrackingSequence(const test::TempFolder& root, int frames = 3) {
  std::string oxts;
  for (int i = 0; i < frames; ++i) oxts += OxtsPacketText(i);
  root.Write("training/oxts/0005.txt", oxts);
  root.Write("training/calib/0005.txt", TrackingCalibration(true));
  root.Write("training/label_02/0005.txt", kCarLabel);
  WriteImages(root, "training/image_02/0005", frames, 6);
  WriteImages(root, "training/image_03/0005", frames, 6);
  return root.path() / "training/0005";
}

}  // namespace cvo
