// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/experiments/cli/process.h"
#include "tests/experiments/runner/tiny_sequence.h"
#include "tests/support/temp_folder.h"

namespace cvo::import_test {
namespace {

namespace fs = std::filesystem;
using test::Arguments;
using test::ExpectError;
using test::ProcessResult;
using test::With;
using testing::HasSubstr;
using testing::Not;

// A user's own stereo images: `clustervo info -o`, and `run --left --right --calib`.

class OwnStereo : public test::TinyTest {
 protected:
  ProcessResult Own(const Arguments& arguments) const { return Run(With(arguments, flags_)); }

  Arguments flags_ = {"--left",  Path("tiny/image_0"),  "--right", Path("tiny/image_1"),
                      "--calib", Path("tiny/calib.txt")};
};

// The images and the calibration of a sequence, given separately, yield the same trajectory as the
// sequence.
TEST_F(OwnStereo, GivesTheSameTrajectoryAsTheSequence) {
  ASSERT_EQ(Run({"run", tiny(), "-o", Path("a")}).exit_code, 0);
  const ProcessResult result = Own({"run", "-o", Path("b")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(test::ReadFile(Path("a/camera.kitti")), test::ReadFile(Path("b/camera.kitti")));
  EXPECT_THAT(Own({"info", "-q", "-o", Path("c")}).out, HasSubstr("3 (0 to 2 of 3)"));
  EXPECT_EQ(Own({"run", "-q", "--rate", "25", "-o", Path("e")}).err, "");
  EXPECT_THAT(Run({"info", Path("c")}).out, HasSubstr("10 Hz (assumed: no timestamps were given)"));
  EXPECT_TRUE(fs::exists(Path("c/import.json")));
}

// Regression: results used to be written among the images, as only the folders of sequences were
// protected.
TEST_F(OwnStereo, NothingIsWrittenIntoTheImageFolders) {
  const auto copy = fs::copy_options::recursive;
  fs::create_directories(Path("own/cam"));
  fs::copy(Path("tiny/image_0"), Path("own/left"), copy);
  fs::copy(Path("tiny/image_1"), Path("own/right"), copy);
  const std::string cam = Path("own/cam/cam.txt");
  fs::copy_file(Path("tiny/calib.txt"), cam);
  flags_ = {"--left", Path("own/left"), "--right", Path("own/right"), "--calib", cam};
  for (const char* place : {"own/left", "own/left/", "own/right/new"}) {
    for (const char* command : {"run", "info"}) {
      ExpectError(Own({command, "-q", "-o", Path(place)}), ": found an input folder, expected ", 2);
    }
  }
  EXPECT_EQ(std::distance(fs::recursive_directory_iterator(Path("own")), {}), 10);
  EXPECT_EQ(Own({"run", "-q", "-o", Path("own/result")}).exit_code, 0);
  EXPECT_EQ(Own({"info", "-q", "-o", Path("own/sequence")}).exit_code, 0);
}

TEST_F(OwnStereo, HasNoDetectorLevels) {
  const ProcessResult run = Own({"run", "-q", "--detections", "good", "-o", Path("x")});
  ExpectError(run, "found \"good\", expected a file, or for this sequence one of labels, none", 2);
}

TEST_F(OwnStereo, RefusesWrongUsage) {
  EXPECT_EQ(Own({"run", tiny(), "-o", Path("x")}).exit_code, 2);
  EXPECT_EQ(Run({"run", "--left", Path("tiny/image_0"), "-o", Path("x")}).exit_code, 2);
  EXPECT_EQ(Own({"info", "-o", Path("tiny/image_0/x")}).exit_code, 2);
  const std::string times = folder_.Write("times.txt", "0\n1\n").string();
  EXPECT_THAT(Own({"info", "-o", Path("x"), "--times", times}).err,
              testing::AllOf(HasSubstr("found 2 times, expected 3"), Not(HasSubstr("%"))));
  fs::remove(Path("tiny/image_1/000002.png"));
  const ProcessResult fewer = Own({"run", "-o", Path("x")});
  EXPECT_EQ(fewer.exit_code, 1);
  EXPECT_THAT(fewer.err, HasSubstr("image_0/000002.png: found no image 2 in "));
  EXPECT_FALSE(fs::exists(Path("x")));
}

// `clustervo detect` as a process, with a tiny network that the test writes.

class Detect : public test::TinyTest {
 protected:
  std::string boxes() const { return Path("boxes.txt"); }
  ProcessResult Find(const Arguments& more) const {
    return Run(With({"detect", tiny(), "--model", model_, "--names", names_, "-o", boxes()}, more));
  }

  std::string model_ = test::WriteTinyNetwork(folder_);
  std::string names_ = folder_.Write("two.names", "person\ncar\n").string();
};

// A run accepts the boxes, and a second call writes the same bytes.
TEST_F(Detect, WritesBoxesThatARunReads) {
  const ProcessResult result = Find({"--frames", "1:"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("2 boxes in 2 frames"));
  const std::string rows = test::ReadFile(boxes());
  EXPECT_THAT(rows, testing::StartsWith("1 -1 Car -1 -1 -10 "));
  EXPECT_EQ(Find({"--frames", "1:", "-t", "2"}).exit_code, 0);
  EXPECT_EQ(test::ReadFile(boxes()), rows);
  const ProcessResult run = Run({"run", tiny(), "-o", out(), "--detections", boxes()});
  EXPECT_EQ(run.exit_code, 0) << run.err;
}

TEST_F(Detect, BadInputLeavesNothing) {
  EXPECT_EQ(Find({"--input", "33x64"}).exit_code, 2);
  EXPECT_EQ(Find({"--min-score", "nan"}).exit_code, 2);
  const ProcessResult result = Find({"--weights", folder_.Write("w.weights", "").string()});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("w.weights: found"));
  EXPECT_FALSE(std::filesystem::exists(boxes()));
}

}  // namespace
}  // namespace cvo::import_test
