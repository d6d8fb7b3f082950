// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/log/frame_log.h"

#include <utility>

#include "core/base/error.h"
#include "experiments/log/pack_frames.h"
#include "experiments/log/packed.h"

namespace cvo {

FrameLog::FrameLog(const std::vector<FrameRecord>& frames) {
  for (const FrameRecord& frame : frames) Append(frame);
}

void FrameLog::Append(const FrameRecord& frame) {
  begins_.push_back(spool_.size());
  std::string bytes;
  Packer{bytes}(frame);
  spool_.Append(bytes);
}

void FrameLog::Refine(std::vector<RigidTransform> world_from_camera) {
  Require(world_from_camera.size() == size(), "FrameLog: one pose per frame");
  refined_world_from_camera_ = std::move(world_from_camera);
}

FrameRecord FrameLog::operator[](std::size_t index) const {
  const std::uint64_t begin = begins_.at(index);
  const std::uint64_t end = index + 1 < size() ? begins_[index + 1] : spool_.size();
  const std::string bytes = spool_.Read(begin, end - begin);
  FrameRecord frame;
  Unpacker{bytes}(frame);
  if (!refined_world_from_camera_.empty()) {
    frame.refined_world_from_camera = refined_world_from_camera_[index];
  }
  return frame;
}

}  // namespace cvo
