// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <opencv2/core.hpp>

#include "core/base/rng.h"
#include "core/files/host_name.h"
#include "core/files/images/image_codec.h"
#include "synth/write/folder_build.h"
#include "synth/write/image_encoding.h"
#include "synth/write/manifest.h"
#include "tests/support/damaged_tiff.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"

namespace cvo::synth {
namespace {

namespace fs = std::filesystem;
using cvo::test::ExpectDamageIsReadOrRefused;
using cvo::test::ReadFile;
using cvo::test::TempFolder;
using testing::HasSubstr;

cv::Mat Decode(const std::string& bytes) { return DecodeImage(bytes, cv::IMREAD_UNCHANGED); }

std::vector<std::string> NamesIn(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename());
  return names;
}

// Returns the id of a process that has ended.
pid_t DeadProcess() {
  const pid_t pid = ::fork();
  if (pid == 0) ::_exit(0);
  ::waitpid(pid, nullptr, 0);
  return pid;
}

TEST(EncodeDepthTiff, IsLosslessAndSmall) {
  cv::Mat depth(480, 640, CV_32FC1);
  for (int v = 0; v < depth.rows; ++v) {
    for (int u = 0; u < depth.cols; ++u) {
      depth.at<float>(v, u) = v < 20 ? 0.0F : 3.0F / (1.0F + 0.001F * static_cast<float>(u));
    }
  }
  const std::string bytes = EncodeDepthTiff(depth);
  const cv::Mat read = Decode(bytes);
  ASSERT_EQ(read.type(), CV_32FC1);
  EXPECT_EQ(cv::norm(read, depth, cv::NORM_INF), 0.0);
  EXPECT_LT(bytes.size(), depth.total() * sizeof(float) / 4);
  EXPECT_EQ(bytes, EncodeDepthTiff(depth));
}

TEST(EncodeDepthTiff, DamagedFilesAreReadOrRefused) {
  ExpectDamageIsReadOrRefused(EncodeDepthTiff(cv::Mat(32, 48, CV_32FC1, cv::Scalar(1.5))));
}

TEST(EncodePng, MasksAndImagesAreLossless) {
  cv::Mat mask(30, 40, CV_16UC1, cv::Scalar(0));
  mask(cv::Rect(5, 5, 10, 10)).setTo(300);
  EXPECT_EQ(cv::norm(Decode(EncodeMaskPng(mask)), mask, cv::NORM_INF), 0.0);
  cv::Mat grey(30, 40, CV_8UC1);
  Rng rng(1, "pixels");
  for (int i = 0; i < 1200; ++i) grey.data[i] = static_cast<unsigned char>(rng.UniformInt(256));
  const cv::Mat read = Decode(EncodePng(grey));
  ASSERT_EQ(read.type(), CV_8UC1);
  EXPECT_EQ(cv::norm(read, grey, cv::NORM_INF), 0.0);
}

TEST(FolderBuild, AppearsWithItsManifestOnlyWhenCommitted) {
  const TempFolder temp;
  {
    FolderBuild build(temp.path() / "set");
    build.Write("image_0/000000.png", "abc");
    EXPECT_FALSE(fs::exists(temp.path() / "set"));
    build.Commit({}, Existing::kReplace);
  }
  EXPECT_THAT(NamesIn(temp.path()), testing::ElementsAre("set"));
  const Manifest manifest = ReadManifest(temp.path() / "set");
  ASSERT_EQ(manifest.files.size(), 1U);
  EXPECT_EQ(manifest.files[0].name, "image_0/000000.png");
  EXPECT_EQ(manifest.files[0].size_bytes, 3);
  EXPECT_EQ(manifest.files[0].sha256,
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(FolderBuild, WithoutCommitNothingRemains) {
  const TempFolder temp;
  FolderBuild(temp.path() / "set").Write("a", "abc");
  EXPECT_THAT(NamesIn(temp.path()), testing::IsEmpty());
}

TEST(FolderBuild, ReplacesOrKeepsAnExistingFolder) {
  const TempFolder temp;
  const auto commit = [&](const std::string& content, Existing existing) {
    FolderBuild build(temp.path() / "set");
    build.Write("a", content);
    build.Commit({}, existing);
  };
  commit("old", Existing::kReplace);
  commit("new", Existing::kKeep);
  EXPECT_EQ(ReadFile(temp.path() / "set" / "a"), "old");
  commit("new", Existing::kReplace);
  EXPECT_EQ(ReadFile(temp.path() / "set" / "a"), "new");
  EXPECT_THAT(NamesIn(temp.path()), testing::ElementsAre("set"));
}

TEST(FolderBuild, RemovesFilesOfADeadProcess) {
  const TempFolder temp;
  const fs::path left =
      temp.path() / StrCat(".set.tmp-", HostName(), ".", DeadProcess(), "-0") / "a";
  temp.Write(left.lexically_relative(temp.path()), "abc");
  const FolderBuild build(temp.path() / "set");
  EXPECT_FALSE(fs::exists(left));
}

TEST(FolderBuild, UnwritableFolderIsReported) {
  const TempFolder temp;
  temp.Write("file", "abc");
  const std::string message = ErrorMessage([&] { FolderBuild(temp.path() / "file" / "set"); });
  EXPECT_THAT(message, HasSubstr((temp.path() / "file").string()));
  EXPECT_THAT(message, HasSubstr("cannot create the folder"));
}

// A file size limit simulates a full disk: writing fails midway.
TEST(WriteNewFile, FailedWriteIsReportedAndLeavesNothing) {
  const TempFolder temp;
  rlimit before;
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  rlimit small = before;
  small.rlim_cur = 1000;
  auto* handler = ::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string message =
      ErrorMessage([&] { WriteNewFile(temp.path() / "big", std::string(5000, 'x')); });
  ::setrlimit(RLIMIT_FSIZE, &before);
  ::signal(SIGXFSZ, handler);
  EXPECT_THAT(message, HasSubstr((temp.path() / "big").string()));
  EXPECT_THAT(message, HasSubstr("File too large"));
  EXPECT_THAT(NamesIn(temp.path()), testing::IsEmpty());
}

class Damage : public testing::Test {
 protected:
  Damage() {
    FolderBuild build(folder_);
    build.Write("a", "abc");
    build.Write("b/c", "defg");
    build.Commit({}, Existing::kReplace);
  }
  std::string Found() {
    TaskPool pool(2);
    return FindDamage(folder_, ReadManifest(folder_), pool).value_or("");
  }

  TempFolder temp_;
  fs::path folder_ = temp_.path() / "set";
};

TEST_F(Damage, NoneAtFirst) { EXPECT_EQ(Found(), ""); }

TEST_F(Damage, MissingFile) {
  fs::remove(folder_ / "b" / "c");
  EXPECT_THAT(Found(), HasSubstr("b/c is missing"));
}

TEST_F(Damage, OtherSize) {
  temp_.Write("set/a", "abcd");
  EXPECT_THAT(Found(), HasSubstr("a has 4 bytes instead of 3"));
}

TEST_F(Damage, OtherContent) {
  temp_.Write("set/a", "abd");
  EXPECT_THAT(Found(), HasSubstr("a has changed since it was written"));
}

TEST(ReadManifest, RefusesOtherJson) {
  const TempFolder temp;
  temp.Write("manifest.json", "{\"kind\": \"other\"}");
  EXPECT_THAT(ErrorMessage([&] { ReadManifest(temp.path()); }), HasSubstr("manifest.json"));
  temp.Write("manifest.json",
             "{\"kind\": \"clustervo synthetic sequence\", \"schema_version\": 1}");
  EXPECT_THAT(ErrorMessage([&] { ReadManifest(temp.path()); }), HasSubstr("damaged"));
  temp.Write("manifest.json", "{\"kind\": 5, \"schema_version\": [1]}");
  EXPECT_THAT(ErrorMessage([&] { ReadManifest(temp.path()); }),
              HasSubstr("found another JSON file"));
  temp.Write(
      "manifest.json",
      "{\"kind\": \"clustervo synthetic sequence\", \"schema_version\": 1, \"scene\": \"a\", "
      "\"seed\": null, \"frames\": {\"first\": 1e300, \"count\": 3}}");
  EXPECT_THAT(ErrorMessage([&] { ReadManifest(temp.path()); }),
              HasSubstr("manifest.json, first: found 1e+300, expected an integer"));
}

}  // namespace
}  // namespace cvo::synth
