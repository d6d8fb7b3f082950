// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/experiments/cli/process.h"
#include "tests/experiments/runner/tiny_sequence.h"
#include "tests/experiments/datasets/tiny_network.h"
#include "tests/support/temp_folder.h"

namespace cvo::import_test {
namespace {

namespace fs = std::filesystem;
using test::ProcessResult;
using testing::HasSubstr;
using testing::Not;

// A user's own stereo images: `clustervo import`, and `run --left --right --calib`.

class OwnStereo : public testing::Test {
 protected:
  OwnStereo() {
    test::WriteTinySequence(tiny(), 3);
    flags_ = {"--left",  tiny() + "/image_0",  "--right", tiny() + "/image_1",
              "--calib", tiny() + "/calib.txt"};
    ::setenv("CLUSTERVO_CACHE", (folder_.path() / "cache").c_str(), 1);
  }
  ~OwnStereo() override { ::unsetenv("CLUSTERVO_CACHE"); }

  std::string tiny() const { return (folder_.path() / "tiny").string(); }
  std::string out(const std::string& name) const { return (folder_.path() / name).string(); }
  ProcessResult Run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), flags_.begin(), flags_.end());
    return test::RunProgram(arguments);
  }

  test::TempFolder folder_;
  std::vector<std::string> flags_;
};

// The images and the calibration of a sequence, given separately, yield the same trajectory as the
// sequence.
TEST_F(OwnStereo, GivesTheSameTrajectoryAsTheSequence) {
  ASSERT_EQ(test::RunProgram({"run", tiny(), "-o", out("a")}).exit_code, 0);
  const ProcessResult result = Run({"run", "-o", out("b")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(test::ReadFile(out("a") + "/camera.kitti"), test::ReadFile(out("b") + "/camera.kitti"));
  const ProcessResult imported = Run({"import", "-o", out("c")});
  EXPECT_THAT(imported.out, HasSubstr("3 pairs of"));
  EXPECT_EQ(Run({"import", "-q", "-o", out("d")}).err, "");
  EXPECT_EQ(Run({"run", "-q", "--rate", "25", "-o", out("e")}).err, "");
  EXPECT_THAT(test::RunProgram({"info", out("c")}).out,
              HasSubstr("10 Hz (assumed: no timestamps were given)"));
  EXPECT_TRUE(fs::exists(out("c") + "/import.json"));
}

// Regression: results used to be written among the images, as only the folders of sequences were
// protected.
TEST_F(OwnStereo, NothingIsWrittenIntoTheImageFolders) {
  const auto copy = fs::copy_options::recursive;
  fs::create_directories(out("own/cam"));
  fs::copy(tiny() + "/image_0", out("own/left"), copy);
  fs::copy(tiny() + "/image_1", out("own/right"), copy);
  const std::string cam = out("own/cam/cam.txt");
  fs::copy_file(tiny() + "/calib.txt", cam);
  flags_ = {"--left", out("own/left"), "--right", out("own/right"), "--calib", cam};
  for (const char* place : {"own", "own/left", "own/left/", "own/right/new", "own/cam"}) {
    for (const char* command : {"run", "import"}) {
      test::ExpectError(Run({command, "-q", "-o", out(place)}), "expected a folder of its own", 2);
    }
  }
  EXPECT_EQ(std::distance(fs::recursive_directory_iterator(out("own")), {}), 10);
  EXPECT_EQ(Run({"run", "-q", "-o", out("own/result")}).exit_code, 0);
  EXPECT_EQ(Run({"import", "-q", "-o", out("own/sequence")}).exit_code, 0);
  const std::string boxes = folder_.Write("boxes/boxes.txt", "").string();
  test::ExpectError(Run({"run", "-q", "--detections", boxes, "-o", out("boxes")}),
                    "boxes: found the folder of the input ", 2);
}

TEST_F(OwnStereo, HasNoDetectorLevels) {
  const ProcessResult run = Run({"run", "-q", "--detections", "good", "-o", out("x")});
  test::ExpectError(run,
                    "found \"good\", expected a file, or for this sequence one of labels, none", 2);
  EXPECT_THAT(run.err, HasSubstr("(this sequence has no detector levels such as good)"));
}

TEST_F(OwnStereo, RefusesWrongUsage) {
  const ProcessResult none = test::RunProgram({"run", "-o", out("x")});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_THAT(none.err, HasSubstr("no sequence: give a folder, or --left, --right and --calib"));
  EXPECT_EQ(Run({"run", tiny(), "-o", out("x")}).exit_code, 2);
  EXPECT_EQ(test::RunProgram({"run", "--left", tiny() + "/image_0", "-o", out("x")}).exit_code, 2);
  EXPECT_EQ(Run({"import", "-o", tiny() + "/image_0/x"}).exit_code, 2);
  const std::string times = folder_.Write("times.txt", "0\n1\n").string();
  EXPECT_THAT(Run({"import", "-o", out("x"), "--times", times}).err,
              testing::AllOf(HasSubstr("found 2 times, expected 3"), Not(HasSubstr("%"))));
  fs::remove(tiny() + "/image_1/000002.png");
  const ProcessResult fewer = Run({"run", "-o", out("x")});
  EXPECT_EQ(fewer.exit_code, 1);
  EXPECT_THAT(fewer.err, HasSubstr("image_0/000002.png: found no image 2 in "));
  EXPECT_FALSE(fs::exists(out("x")));
}

// `clustervo detect` as a process, with a tiny network that the test writes.

class Detect : public testing::Test {
 protected:
  Detect() {
    test::WriteTinySequence((folder_.path() / "tiny").string(), 3);
    arguments_ = {"detect",  (folder_.path() / "tiny").string(),
                  "--model", test::WriteTinyNetwork(folder_),
                  "--names", folder_.Write("two.names", "person\ncar\n").string(),
                  "-o",      boxes()};
  }

  std::string boxes() const { return (folder_.path() / "boxes.txt").string(); }
  ProcessResult Run(const std::vector<std::string>& more) const {
    std::vector<std::string> all = arguments_;
    all.insert(all.end(), more.begin(), more.end());
    return test::RunProgram(all);
  }

  test::TempFolder folder_;
  std::vector<std::string> arguments_;
};

// A run accepts the boxes, and a second call writes the same bytes.
TEST_F(Detect, WritesBoxesThatARunReads) {
  const ProcessResult result = Run({"--frames", "1:"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("2 boxes in 2 frames"));
  const std::string rows = test::ReadFile(boxes());
  EXPECT_THAT(rows, testing::StartsWith("1 -1 Car -1 -1 -10 "));
  EXPECT_EQ(Run({"--frames", "1:", "-t", "2"}).exit_code, 0);
  EXPECT_EQ(test::ReadFile(boxes()), rows);
  const ProcessResult run =
      test::RunProgram({"run", (folder_.path() / "tiny").string(), "-o",
                        (folder_.path() / "out").string(), "--detections", boxes()});
  EXPECT_EQ(run.exit_code, 0) << run.err;
}

TEST_F(Detect, BadInputLeavesNothing) {
  EXPECT_EQ(Run({"--input", "33x64"}).exit_code, 2);
  EXPECT_EQ(Run({"--min-score", "nan"}).exit_code, 2);
  const ProcessResult result = Run({"--weights", folder_.Write("w.weights", "").string()});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("w.weights: found"));
  EXPECT_FALSE(std::filesystem::exists(boxes()));
}

}  // namespace
}  // namespace cvo::import_test
