// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/files/spool.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/base/error.h"
#include "tests/support/temp_folder.h"

namespace cvo::spool_test {
namespace {

// Returns parts of various sizes, in total more than fit in memory.
std::vector<std::string> Parts() {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < 300; ++i) {
    parts.emplace_back((i * 37) % 500, static_cast<char>('a' + i % 26));
  }
  return parts;
}

void ExpectPartsComeBack(Spool& spool) {
  std::vector<std::uint64_t> begins;
  std::string all;
  for (const std::string& part : Parts()) {
    begins.push_back(spool.size());
    spool.Append(part);
    all += part;
  }
  ASSERT_GT(spool.size(), 2 * Spool::kInMemory);
  for (std::size_t i = 0; i < begins.size(); ++i) {
    EXPECT_EQ(spool.Read(begins[i], Parts()[i].size()), Parts()[i]) << i;
  }
  EXPECT_EQ(spool.Read(0, all.size()), all);
  EXPECT_EQ(spool.Read(all.size(), 0), "");
  EXPECT_THROW(spool.Read(1, all.size()), Error);
}

TEST(Spool, ReadsBackFromMemory) {
  Spool spool;
  ExpectPartsComeBack(spool);
}

TEST(Spool, ReadsBackFromAnUnlinkedFile) {
  const test::TempFolder folder;
  Spool spool(folder.path());
  ExpectPartsComeBack(spool);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  Spool moved = std::move(spool);
  EXPECT_EQ(moved.Read(0, 0), "");
}

TEST(Spool, RequiresAnExistingFolder) {
  const test::TempFolder folder;
  Spool spool(folder.path() / "gone");
  EXPECT_NO_THROW(spool.Append("few"));
  EXPECT_THROW(spool.Append(std::string(Spool::kInMemory, 'x')), Error);
}

}  // namespace
}  // namespace cvo::spool_test
