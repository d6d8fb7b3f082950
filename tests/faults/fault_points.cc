// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// fault_points POINTS PART PARTS [drawn]: counts the system calls (core/files/disk.h) that a small
// suite makes with an empty cache, or, with `drawn`, with a cache of rendered images. Then injects
// POINTS faults, spread evenly over all calls and the three kinds of fault: the call fails, is cut
// short, or the process is killed. Afterwards the same command must give the same bytes, and
// nothing of the fault may be left. Every PARTS-th point is tried, starting with number PART (1 to
// PARTS), so that several processes or machines can share the work.
#include <cstdlib>
#include <iostream>
#include <map>

#include "core/base/error.h"
#include "core/files/sha256.h"
#include "core/files/temporary.h"
#include "core/files/text_file.h"
#include "tests/experiments/cli/process.h"
#include "tests/support/temp_folder.h"

namespace cvo::test {
namespace {

namespace fs = std::filesystem;
using Files = std::map<std::string, std::string>;  // content by path

// Small images and few things: every fault renders it twice.
constexpr const char* kScene = R"({
  "name": "dot", "about": "A rolling ball in a bare room: two frames", "seed": 1, "look_seed": 5,
  "rig": {"width_px": 240, "height_px": 180, "focal_px": 170, "baseline_m": 0.12},
  "frames": 2, "rate_hz": 30,
  "room": {"size_m": [4.4, 4.4, 2.5], "shelves": 0, "tables": 0, "crates": 1, "posters": 1},
  "light": {"shadow_range_m": 5.0},
  "camera": {"route": {"points": [[-1.2, -0.1], [-1.1, 0.0], [-1.05, 0.2]], "speed_mps": 0.35},
             "height_m": 1.1, "look_at": {"points": [[1.0, 0.0, 0.5], [1.0, 0.05, 0.5]]}},
  "objects": [{"name": "ball_1", "model": "ball", "size_m": 0.5,
               "path": {"route": {"points": [[0.55, -0.9], [0.6, 0.0], [0.5, 0.9]],
                                  "speed_mps": 0.7}}}]
})";
constexpr const char* kSuite = R"({
  "name": "faults", "sequences": [{"scene": "dot.json", "detections": "good"}],
  "variants": ["full", "static"], "seeds": 1, "landmarks": true,
  "table": {"rows": ["variant"], "metrics": ["camera_ate"]}
})";
constexpr const char* kKinds[] = {"fail", "kill", "short"};
constexpr int kKilled = 128 + 9;
constexpr std::uint64_t kPointsOfALine = 100;

struct Fault {
  std::string kind;
  std::uint64_t call = 0;
};

struct Share {
  std::uint64_t points = 0;
  std::uint64_t part = 0;
  std::uint64_t parts = 0;
};

class FaultTest {
 public:
  FaultTest() {
    folder_.Write("dot.json", kScene);
    folder_.Write("suite.json", kSuite);
  }

  void Run(const Share& share, bool drawn) {
    Undisturbed();
    if (drawn) KeepDrawing();
    Restore();
    Undisturbed();
    const std::uint64_t calls = Calls();
    const std::uint64_t faults = calls * std::size(kKinds);
    expected_ = Left();
    std::cout << expected_.size() << " files, " << calls << " calls\n";
    const std::uint64_t points = std::min(share.points, faults);
    std::map<std::string, int> outcomes;
    for (std::uint64_t i = share.part - 1, tried = 1; i < points; i += share.parts, ++tried) {
      const std::uint64_t fault = i * faults / points;
      ++outcomes[Try({kKinds[fault / calls], 1 + fault % calls})];
      if (tried % kPointsOfALine == 0) std::cout << i + 1 << " of " << points << std::endl;
    }
    for (const auto& [outcome, count] : outcomes) std::cout << count << " x " << outcome << '\n';
  }

 private:
  // Returns how the run with the fault ended. Throws Error if the next run does not repair it.
  std::string Try(const Fault& fault) const {
    const std::string name = StrCat(fault.kind, " at call ", fault.call);
    Restore();
    const ProcessResult disturbed = RunSuite(fault);
    const int code = disturbed.exit_code;
    const bool internal = disturbed.err.find("internal") != std::string::npos;
    if (internal || (code != 0 && code != 1 && (code != kKilled || fault.kind != "kill"))) {
      throw Error(StrCat(name, ": exit code ", code, ": ", disturbed.err));
    }
    const ProcessResult again = RunSuite({"fail", 0});
    if (again.exit_code != 0) throw Error(StrCat(name, ", afterwards: ", again.err));
    Compare(Left(), name);
    return StrCat(fault.kind, ", exit code ", code);
  }

  void Undisturbed() const {
    const ProcessResult run = RunSuite({"fail", 0});
    if (run.exit_code != 0) throw Error(run.err);
  }
  // Saves the cache entries of rendered images, whose names are hashes.
  void KeepDrawing() const {
    for (const auto& entry : fs::directory_iterator(folder_.path() / "cache")) {
      if (entry.path().filename().string().size() != kHashBytes) continue;
      fs::create_directories(drawing());
      fs::copy(entry.path(), drawing() / entry.path().filename(), fs::copy_options::recursive);
    }
  }
  void Restore() const {
    for (const char* made : {"out", "cache"}) fs::remove_all(folder_.path() / made);
    if (fs::exists(drawing())) {
      fs::copy(drawing(), folder_.path() / "cache", fs::copy_options::recursive);
    }
  }

  ProcessResult RunSuite(const Fault& fault) const {
    WriteFileBytes(counter(), std::string(sizeof(std::uint64_t), '\0'));
    return RunProgram(
        {"experiment", "run", (folder_.path() / "suite.json").string(), "-o",
         (folder_.path() / "out").string(), "-j", "1", "-q"},
        {.environment = {
             StrCat("CLUSTERVO_CACHE=", (folder_.path() / "cache").string()),
             StrCat("CLUSTERVO_FAULT=", fault.kind, ",", fault.call, ",", counter().string())}});
  }
  fs::path drawing() const { return folder_.path() / "drawing"; }
  fs::path counter() const { return folder_.path() / "counter"; }
  std::uint64_t Calls() const {
    std::uint64_t calls = 0;
    ReadFileBytes(counter()).copy(reinterpret_cast<char*>(&calls), sizeof(calls));
    return calls;
  }

  // Returns all reproducible files of results and cached scenes. Throws Error if a temporary file
  // is left over.
  Files Left() const {
    Files files;
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path())) {
      const std::string name = entry.path().lexically_relative(folder_.path()).string();
      if (IsTemporary(entry.path())) throw Error(name + " is left over");
      const bool differs = name.ends_with("timing.json") || name.starts_with("cache/hashes") ||
                           name.starts_with("out/lo");  // times; log files and the lock
      if (entry.is_regular_file() && !differs && entry.path() != counter()) {
        files[name] = ReadFileBytes(entry.path());
      }
    }
    return files;
  }

  void Compare(const Files& found, const std::string& fault) const {
    for (const auto& [name, content] : expected_) {
      const auto at = found.find(name);
      if (at == found.end()) throw Error(StrCat(fault, ": no ", name));
      if (at->second != content) throw Error(StrCat(fault, ": ", name, " differs"));
    }
    for (const auto& [name, content] : found) {
      if (!expected_.contains(name)) throw Error(StrCat(fault, ": ", name, " is too much"));
    }
  }

  TempFolder folder_;
  Files expected_;
};

int Main(int argc, char** argv) {
  const auto number = [&](int i) -> std::uint64_t {
    return argc > i ? std::strtoull(argv[i], nullptr, 10) : 0;
  };
  const Share share{.points = number(1), .part = number(2), .parts = number(3)};
  if (share.points == 0 || share.part == 0 || share.part > share.parts) {
    std::cerr << "fault_points POINTS PART PARTS [drawn]\n";
    return 2;
  }
  try {
    FaultTest().Run(share, argc > 4);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "fault_points: " << error.what() << '\n';
    return 1;
  }
}

}  // namespace
}  // namespace cvo::test

int main(int argc, char** argv) { return cvo::test::Main(argc, argv); }
