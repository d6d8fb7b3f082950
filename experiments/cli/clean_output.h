// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mutex>
#include <ostream>
#include <streambuf>
#include <string>

namespace cvo {

// Makes everything that is printed to a stream plain text for as long as this object exists.
// Characters that a terminal would interpret (escape sequences, line erasure, changes of writing
// direction), which names of files, keys and suites may contain, become U+FFFD. Text is passed on
// in whole lines; an incomplete line is passed on when the stream is flushed.
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
  // Cleans and passes on the first `size` waiting bytes. Returns whether all of them could be
  // written.
  bool Pass(std::size_t size);

  std::ostream& stream_;
  std::streambuf* target_;
  std::mutex mutex_;     // several threads print notices
  std::string waiting_;  // the incomplete last line
};

}  // namespace cvo
