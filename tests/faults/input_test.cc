// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Regression tests for faults of input files, paths and numbers.
#include <sys/stat.h>

#include "tests/faults/fault_folder.h"

namespace cvo::input_test {
namespace {

namespace fs = std::filesystem;
using test::ProcessResult;
using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;

class InputFaults : public test::FaultFolder {};

std::string Repeated(int times, const std::string& line) {
  std::string text;
  for (int i = 0; i < times; ++i) text += line;
  return text;
}

// The program used to wait for a pipe in place of a file.
TEST_F(InputFaults, Pipes) {
  const fs::path pipe = folder_.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const std::string found = "a pipe or a device";
  ExpectOneLine(RunWall({"--config", pipe}), 1, found);
  ExpectOneLine(RunWall({"--detections", pipe}), 1, found);
  ExpectOneLine(RunWall({"--labels", pipe}), 1, found);
  ExpectOneLine({"eval", "trajectory", "--groundtruth", pipe, "--estimate", pipe}, 1, found);
  // Pipes in place of result files are reported or ignored, but never waited for.
  ExpectDone(Suite("run"));
  const fs::path run = FirstResult().parent_path();
  for (const fs::path& file :
       {fs::path(At("out/plan.json")), run / "result.json", run / "timing.json",
        run / "objects.csv", run / "truth.json", run / "camera.tum"}) {
    fs::rename(file, At("kept"));
    fs::rename(pipe, file);
    for (const Arguments& arguments : {Arguments{"experiment", "table", out()},
                                       {"overlay", run, "-o", At("pictures")},
                                       {"plot", run, "-o", At("plot.svg")}}) {
      EXPECT_THAT(Run(arguments).exit_code, AnyOf(0, 1)) << arguments[0] << file;
    }
    fs::rename(file, pipe);
    fs::rename(At("kept"), file);
  }
  ExpectOneLine({"check", out(), "--baseline", pipe}, 1, found);
  for (const char* name : {"times.txt", "calib.txt", "poses.txt", "image_0/000000.png",
                           "image_1/000002.png", "objects.csv", "labels.txt", "manifest.json"}) {
    const fs::path file = wall() / name;
    const bool existed = fs::exists(file);
    if (existed) fs::rename(file, folder_.path() / "kept");
    ASSERT_EQ(::mkfifo(file.c_str(), 0600), 0);
    ExpectOneLine({"run", wall().string(), "-o", At("new"), "-q"}, 1, found);
    fs::remove(file);
    if (existed) fs::rename(folder_.path() / "kept", file);
  }
}

// 100,000 nested values used to cause a crash.
TEST_F(InputFaults, DeepJson) {
  for (const char* bracket : {"[", "{\"a\":"}) {
    const std::string text = Repeated(100'000, bracket);
    const std::string file = folder_.Write("deep.json", text);
    ExpectOneLine(RunWall({"--config", file}), 1, "more than 100 values");
    ExpectOneLine({"experiment", "run", file, "-o", out()}, 1, "more than 100 values");
    ExpectOneLine({"synth", "render", file, "-o", out()}, 1, "more than 100 values");
    ExpectOneLine(
        {"synth", "render", "tiny", "-o", out(), "--set", "objects.0=" + text.substr(0, 20'000)}, 2,
        "found");
    ExpectOneLine({"check", folder_.path(), "--baseline", file}, 1, file);
  }
}

// Circular links, overlong paths and files in place of folders used to be internal errors.
TEST_F(InputFaults, InternalErrors) {
  const std::string circle = folder_.path() / "circle";
  fs::create_symlink(circle, circle);
  const std::string much = (folder_.path() / std::string(300, 'x')).string();
  for (const std::string& path : {circle, much}) {
    for (const Arguments& reads : {Arguments{"run", path, "-o", out()},
                                   {"experiment", "run", path, "-o", out()},
                                   {"experiment", "table", path},
                                   {"overlay", path, "-o", out()},
                                   {"check", path, "--baseline", path},
                                   RunWall({"--detections", path}),
                                   RunWall({"--config", path})}) {
      ExpectOneLine(reads, AnyOf(1, 2), "");
    }
    for (const Arguments& writes : {Arguments{"run", wall(), "-o", path + "/below", "-q"},
                                    {"experiment", "run", "ci", "-o", path},
                                    {"synth", "render", "tiny", "-o", path, "-q"}}) {
      ExpectOneLine(writes, 2, "");
    }
  }
}

// More threads than fit into memory used to cause a crash.
TEST_F(InputFaults, Threads) {
  const ProcessResult few = Run(RunWall({"--threads", "2"}), 3'000'000'000);
  if (few.exit_code != 0) GTEST_SKIP() << "this build needs more address space: " << few.err;
  const ProcessResult many = Run(RunWall({"--threads", "1000"}), 3'000'000'000);
  EXPECT_EQ(many.exit_code, 1);
  EXPECT_THAT(many.err, HasSubstr("threads: found 1000, expected at most "));
  EXPECT_EQ(test::LineCount(many.err), 1U) << many.err;
}

// Running out of memory under a limit used to be an internal error.
TEST_F(InputFaults, Memory) {
  constexpr std::size_t kLimit_bytes = 700'000'000;
  const auto eval = [&](int poses) {
    std::string text;
    for (int i = 0; i < poses; ++i) text += StrCat(i, " 0 0 0 0 0 0 1\n");
    const std::string file = folder_.Write("long.tum", text);
    return Run({"eval", "trajectory", "--groundtruth", file, "--estimate", file}, kLimit_bytes);
  };
  const ProcessResult few = eval(3);
  if (few.exit_code != 0) GTEST_SKIP() << "this build needs more address space: " << few.err;
  const ProcessResult many = eval(1'000'000);
  EXPECT_EQ(many.exit_code, 1);
  EXPECT_THAT(many.err, HasSubstr("out of memory: memory limit of 700 MB"));
  EXPECT_EQ(test::LineCount(many.err), 1U) << many.err;
}

// Non-finite numbers, implausible numbers and invalid names.
TEST_F(InputFaults, OddValues) {
  for (const char* shift : {"nan", "1e308", "-101"}) {
    ExpectOneLine(RunWall({"--right-shift", shift}), 2, "--right-shift");
  }
  for (const char* classes : {"<b>", "a,,b", "\x1b[31m", "a b"}) {
    ExpectOneLine(RunWall({"--classes", classes}), 2, "option --classes");
  }
  ExpectOneLine(RunWall({"--min-score", "1e308"}), 2, "--min-score");
  ExpectOneLine(Suite("run", {"--memory-limit", "1e308"}), 2, "--memory-limit");
  ExpectOneLine(Suite("run", {"--time-limit", "nan"}), 2, "--time-limit");
}

// Messages used to repeat the contents of a file at any length.
TEST_F(InputFaults, LongMessages) {
  const std::string much(400'000, 'x');
  const std::string file = folder_.Write("long.json", "{\"name\": \"" + much + "\"}");
  const std::string table = folder_.Write("long.txt", much + "\n" + much);
  for (const Arguments& arguments :
       {Arguments{"experiment", "run", file, "-o", out()},
        {"synth", "render", file, "-o", out()},
        RunWall({"--config", file}),
        RunWall({"--detections", table}),
        {"eval", "trajectory", "--groundtruth", table, "--estimate", table},
        RunWall({"--set", much.substr(0, 100'000) + "=1"})}) {
    const ProcessResult result = Run(arguments);
    EXPECT_THAT(result.exit_code, AnyOf(1, 2)) << result.err;
    EXPECT_LE(result.err.size(), 350U);  // 300 for the message itself
    EXPECT_EQ(test::LineCount(result.err), 1U);
  }
}

// Names of files and keys used to be printed with terminal control sequences.
TEST_F(InputFaults, Terminal) {
  const std::string odd =
      "a\x1b[31mb\xc2\x9b"
      "c\xe2\x80\xae"
      "d";
  const fs::path folder = folder_.path() / odd;
  fs::copy(wall(), folder, fs::copy_options::recursive);
  const std::string suite = folder_.Write(
      "odd.json", Json({{"name", "x"}, {odd, 1}, {"sequences", {{{"folder", odd}}}}}).dump());
  for (const Arguments& arguments : {Arguments{"info", folder.string()},
                                     {"run", folder.string(), "-o", out()},
                                     {"run", wall().string(), "-o", out() + odd, "-q"},
                                     {"nosuch" + odd},
                                     RunWall({"--variant", odd}),
                                     RunWall({"--set", odd + "=1"}),
                                     RunWall({"--config", At(odd + ".json")}),
                                     {"experiment", "run", suite, "-o", out()},
                                     {"experiment", "table", folder.string()}}) {
    const ProcessResult result = Run(arguments);
    for (const std::string& printed : {result.out, result.err}) {
      for (const char* bad : {"\x1b", "\xc2\x9b", "\xe2\x80\xae"}) {
        EXPECT_THAT(printed, Not(HasSubstr(bad))) << arguments[0];
      }
    }
  }
}

// A file whose header is not that of an expected image is refused before the first frame. Damage
// after a good header costs the frame, which the result states.
TEST_F(InputFaults, Images) {
  const fs::path image = wall() / "image_1" / "000001.png";
  const std::string whole = ReadFileBytes(image);
  std::string wide = whole;
  wide[18] = 2;
  for (const std::string& bytes : {std::string(), wide, std::string("no image")}) {
    WriteFileBytes(image, bytes);
    ExpectOneLine(RunWall(), 1, image.string());
    ExpectOneLine({"info", wall().string()}, 1, image.string());
  }
  std::string damaged = whole;
  damaged[whole.size() / 2] ^= 1;
  for (const std::string& bytes : {whole.substr(0, whole.size() / 2), damaged}) {
    WriteFileBytes(image, bytes);
    const ProcessResult run = Run(RunWall({"--force"}));
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("frame 1 skipped: image_1/000001.png: "));
    EXPECT_EQ(ReadJson(At("out/result.json"))["undecodable"].size(), 1U);
  }
}

// Gaps in the times and jumps in the truth are warned of, and a duplicate label is refused.
TEST_F(InputFaults, ImplausibleTruth) {
  const fs::path drive = folder_.path() / "drive";
  test::WriteTinySequence(drive, 5);
  const Arguments arguments = {"run", drive.string(), "-o", out(), "-q", "--force"};
  ExpectDone(arguments);
  EXPECT_FALSE(ReadJson(At("out/result.json"))["sequence"].contains("warnings"));
  WriteFileBytes(drive / "times.txt", "0\n0.1\n0.2\n3.0\n3.1\n");
  const std::string poses = ReadFileBytes(drive / "poses.txt");
  WriteFileBytes(drive / "poses.txt", Replaced(poses, "\n1 0 0 ", "\n1 0 0 50000"));
  const ProcessResult run = Run(arguments);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("warning: times, frame 3: 2.8 s after the one before"));
  EXPECT_THAT(run.out, HasSubstr("warning: ground truth of the camera, frame 1: 5"));
  EXPECT_EQ(ReadJson(At("out/result.json"))["sequence"]["warnings"].size(), 3U);
  EXPECT_THAT(Run({"info", drive.string()}).out, HasSubstr("note  "));
  const std::string label = "1 3 Car 0 0 0 10 10 40 40 1.5 1.6 4 0 1 8 0\n";
  const std::string labels = folder_.Write("labels.txt", label + label);
  ExpectOneLine(RunWall({"--labels", labels}), 1, "track 3 of frame 1 a second time");
}

}  // namespace
}  // namespace cvo::input_test
