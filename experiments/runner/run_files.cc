// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/runner/run_files.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <ctime>
#include <fstream>
#include <numeric>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/files/atomic_file.h"
#include "core/files/json/json.h"
#include "core/record/csv_rows.h"
#include "experiments/metrics/trajectory.h"

namespace cvo {

namespace {

// The text after `name` and a colon in a file such as /proc/cpuinfo; empty if there is none.
std::string ProcValue(const char* file, std::string_view name) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    const std::size_t colon = line.find(':');
    if (!line.starts_with(name) || colon == std::string::npos) continue;
    const std::size_t begin = line.find_first_not_of(" \t", colon + 1);
    return begin == std::string::npos ? "" : line.substr(begin);
  }
  return "";
}

double PeakMemoryMb() {
  const std::string text = ProcValue("/proc/self/status", "VmHWM");  // "398204 kB"
  double kibibytes = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), kibibytes);
  return kibibytes * 1024.0 / 1e6;
}

std::string UtcNow() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text.data();
}

// The nearest-rank quantile: the smallest sample that at least a fraction q of the samples do not
// exceed.
double Quantile(std::vector<double> samples, double q) {
  std::sort(samples.begin(), samples.end());
  const double rank = std::ceil(q * static_cast<double>(samples.size()));
  return samples[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
}

// Rounds to whole microseconds, because further digits are noise.
double Milliseconds(double seconds) { return std::round(1e6 * seconds) / 1e3; }

reports::StageSummary Summary(const std::vector<double>& samples_ms) {
  const double total_s = 1e-3 * std::accumulate(samples_ms.begin(), samples_ms.end(), 0.0);
  return {Quantile(samples_ms, 0.5), Milliseconds(total_s / static_cast<double>(samples_ms.size())),
          Quantile(samples_ms, 0.95), Milliseconds(total_s)};
}

// A frame without the stage counts as zero.
std::vector<double> Samples_ms(const std::vector<float>& times_s) {
  std::vector<double> samples_ms;
  for (const float time_s : times_s) {
    samples_ms.push_back(std::isnan(time_s) ? 0.0 : Milliseconds(time_s));
  }
  return samples_ms;
}

}  // namespace

double CpuSeconds(int whose) {
  rusage usage{};
  ::getrusage(whose, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

reports::TimingData ThisProcess() {
  reports::TimingData timing;
  timing.date = UtcNow();
  timing.host = HostName();
  timing.cpu = ProcValue("/proc/cpuinfo", "model name");
  timing.cpus = static_cast<int>(std::thread::hardware_concurrency());
  timing.peak_memory_mb = PeakMemoryMb();
  return timing;
}

std::string TimingFile(const RunResult& run) {
  reports::TimingData timing = run.timing;
  timing.wall_s = run.wall_s;
  timing.cpu_s = run.cpu_s;
  const double count = static_cast<double>(run.frames.size());
  timing.frames_per_second = run.wall_s > 0.0 ? count / run.wall_s : 0.0;
  for (const auto& [stage, times_s] : run.times_s) {
    timing.stages[stage] = Summary(Samples_ms(times_s));
  }
  for (std::size_t i = 0; i < run.frames.size(); ++i) {
    Json row = {{"frame", run.frames[i].frame}};
    for (const auto& [stage, times_s] : run.times_s) {
      if (!std::isnan(times_s[i])) row[stage + "_ms"] = Milliseconds(times_s[i]);
    }
    timing.frames.push_back(std::move(row));
  }
  return FileText(timing);
}

namespace {

namespace fs = std::filesystem;

constexpr const char* kClusters = "clusters";
constexpr const char* kLandmarks = "landmarks.csv";
constexpr const char* kTruth = "truth.json";

// Returns the <number>.tum files in clusters/ that this run does not write.
std::vector<std::string> StaleFiles(const fs::path& folder, const StagedFiles& written) {
  std::vector<std::string> stale;
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder / kClusters, none)) {
    const std::string stem = entry.path().stem().string();
    if (entry.path().extension() != ".tum" ||
        stem.find_first_not_of("0123456789") != std::string::npos) {
      continue;
    }
    stale.push_back(StrCat(kClusters, "/", entry.path().filename().string()));
  }
  std::erase_if(stale, [&](const std::string& name) { return written.Has(name); });
  return stale;
}

std::string CameraTum(const std::vector<FrameRecord>& frames) {
  Trajectory timed;
  for (const FrameRecord& frame : frames) {
    if (frame.report.status == FrameStatus::kSkipped) continue;
    timed.push_back({frame.timestamp_ns, frame.refined_world_from_camera});
  }
  return FormatTumTrajectory(timed);
}

std::string CameraKitti(const std::vector<FrameRecord>& frames) {
  std::vector<RigidTransform> every_frame;
  for (const FrameRecord& frame : frames) every_frame.push_back(frame.refined_world_from_camera);
  return FormatKittiPoses(every_frame);
}

}  // namespace

std::vector<std::string> RunFileNames() {
  return {"camera.tum", "camera.kitti", "objects.csv", "tracks.kitti", kLandmarks,
          "clusters/",  kTruth,         "timing.json", "result.json"};
}

StagedFile BeginLandmarks(const fs::path& folder) {
  StagedFile file(folder / kLandmarks);
  file.Append(CsvHeader<reports::LandmarkRow>() + "\n");
  return file;
}

void WriteRunFiles(const fs::path& folder, const RunResult& run, const ObjectTruth* objects,
                   std::optional<StagedFile> landmarks) {
  StagedFiles files(folder);
  const bool has_landmarks = landmarks.has_value();
  if (landmarks) files.Add(std::move(*landmarks));
  for (const ClusterTrajectory& cluster : run.clusters) {
    files.Add(StrCat(kClusters, "/", cluster.id.value, ".tum"), ClusterTum(cluster));
  }
  files.Add("camera.tum", CameraTum(run.frames));
  files.Add("camera.kitti", CameraKitti(run.frames));
  files.Add("objects.csv", [&](const TextSink& sink) { WriteObjectTable(run, sink); });
  files.Add("tracks.kitti", [&](const TextSink& sink) { WriteKittiTracks(run, sink); });
  files.Add(kTruth, TruthFile(run, objects));
  // The result comes last: if it is complete, so is everything else.
  files.Add("timing.json", TimingFile(run));
  files.Add("result.json", ResultFile(run));
  std::vector<std::string> stale = StaleFiles(folder, files);
  if (!has_landmarks && fs::exists(folder / kLandmarks)) stale.emplace_back(kLandmarks);
  files.Publish(stale);
}

}  // namespace cvo
