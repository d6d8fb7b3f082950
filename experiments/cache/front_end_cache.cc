// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cache/front_end_cache.h"

#include <exception>
#include <system_error>
#include <utility>

#include "core/base/error.h"
#include "core/files/json/options_json.h"
#include "core/files/sha256.h"

namespace cvo {
namespace fs = std::filesystem;
namespace {

std::string FileName(const std::string& key) { return key + ".features"; }

}  // namespace

std::string FrontEndKey(const FrontEndSettings& settings, const std::vector<ImageHashes>& images) {
  Json image_files = Json::array();
  for (const ImageHashes& pair : images) {
    if (pair.left.empty() || pair.right.empty()) return "";
    image_files.push_back(Json::array({pair.left, pair.right}));
  }
  Json boxes = Json::array();
  for (const std::vector<cv::Rect2d>& of_frame : settings.boxes) {
    boxes.push_back(Json::array());
    for (const cv::Rect2d& box : of_frame) {
      boxes.back().push_back(Json::array({box.x, box.y, box.width, box.height}));
    }
  }
  OrbOptions orb = settings.orb;
  StereoMatchOptions stereo = settings.stereo;
  Json json = {{"format", kFeatureFileVersion},
               {"build", settings.build},
               {"camera", CameraNumbers(settings.camera)},
               {"orb", OptionsToJson(OptionLeaves(orb))},
               {"stereo", OptionsToJson(OptionLeaves(stereo))},
               {"boxes", boxes},
               {"images", image_files}};
  if (settings.rectification) json["rectified"] = settings.rectification->identity();
  const Json perturbation = PerturbationToJson(settings.perturbation);
  if (!perturbation.empty()) {
    json["perturbation"] = perturbation;
    json["first_frame"] = settings.first_frame;
  }
  return Sha256Hex(DumpJson(json));
}

FrontEndRecording::FrontEndRecording(fs::path folder, std::uint64_t limit_bytes, Notice notice)
    : folder_(std::move(folder)), limit_bytes_(limit_bytes), notice_(std::move(notice)) {
  if (limit_bytes_ == 0) return;
  try {
    writer_ = std::make_unique<FeatureFileWriter>(folder_);
  } catch (const std::exception& error) {
    StopRecording(error.what());
  }
}

void FrontEndRecording::Add(const FrontEndFrame& frame) {
  if (!writer_) return;
  try {
    writer_->Add(frame);
  } catch (const std::exception& error) {
    StopRecording(error.what());
  }
}

void FrontEndRecording::AddFrames(const FeatureFile& file, std::size_t count) {
  if (!writer_) return;
  try {
    for (std::size_t i = 0; i < count; ++i) writer_->Add(file.Frame(i));
  } catch (const std::exception& error) {
    StopRecording(error.what());
  }
}

void FrontEndRecording::Finish(const std::string& key) {
  if (!writer_ || key.empty()) return;
  try {
    const std::uint64_t size_bytes = writer_->Complete(key);
    if (size_bytes > limit_bytes_) {
      StopRecording(StrCat(size_bytes, " bytes, and the cache may have ", limit_bytes_));
      return;
    }
    writer_->Publish(FileName(key));
    TrimFolder(folder_, limit_bytes_);
  } catch (const std::exception& error) {
    StopRecording(error.what());
  }
}

void FrontEndRecording::StopRecording(const std::string& reason) {
  writer_.reset();
  notice_(StrCat("features are not kept for other runs: ", reason));
}

FrontEndCache::FrontEndCache(fs::path folder, std::uint64_t limit_bytes, Notice notice)
    : folder_(std::move(folder)), limit_bytes_(limit_bytes), notice_(std::move(notice)) {}

std::optional<FeatureFile> FrontEndCache::Find(const std::string& key, std::size_t frames) const {
  const fs::path file = folder_ / FileName(key);
  if (key.empty()) return std::nullopt;
  try {
    std::optional<FeatureFile> found = FeatureFile::Open(file, key, frames);
    if (found) MarkUsed(file);
    return found;
  } catch (const std::exception& damage) {
    Remove(key, damage.what());
    return std::nullopt;
  }
}

void FrontEndCache::Remove(const std::string& key, const std::string& reason) const {
  std::error_code error;
  fs::remove(folder_ / FileName(key), error);
  notice_(StrCat("cached features are extracted again: ", reason,
                 error ? StrCat(" (cannot remove it: ", error.message(), ")") : ""));
}

}  // namespace cvo
