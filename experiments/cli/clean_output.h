// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mutex>
#include <ostream>
#include <streambuf>
#include <string>

namespace cvo {

// While it lives, what a stream prints is text and nothing else: characters that a terminal would
// obey (escape sequences, line erasure, changes of direction), which names of files, keys and
// suites may hold, become U+FFFD. It passes on whole lines, and what there is when flushed.
class CleanOutput : public std::streambuf {
 public:
  explicit CleanOutput(std::ostream& stream) : stream_(stream), target_(stream.rdbuf(this)) {}
  ~CleanOutput() override;
  CleanOutput(const CleanOutput&) = delete;
  CleanOutput& operator=(const CleanOutput&) = delete;

 protected:
  int_type overflow(int_type character) override;
  std::streamsize xsputn(const char* text, std::streamsize size) override;
  int sync() override;

 private:
  // Whether all of the first `size` bytes could be written.
  bool Pass(std::size_t size);

  std::ostream& stream_;
  std::streambuf* target_;
  std::mutex mutex_;     // notices come from several threads
  std::string waiting_;  // no whole line yet
};

}  // namespace cvo
