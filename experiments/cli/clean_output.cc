// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/clean_output.h"

#include "core/files/text/utf8.h"

namespace cvo {

CleanOutput::~CleanOutput() {
  Pass(waiting_.size());
  stream_.rdbuf(target_);
}

CleanOutput::int_type CleanOutput::overflow(int_type character) {
  if (traits_type::eq_int_type(character, traits_type::eof()))
    return traits_type::not_eof(character);
  const char byte = traits_type::to_char_type(character);
  return xsputn(&byte, 1) == 1 ? character : traits_type::eof();
}

std::streamsize CleanOutput::xsputn(const char* text, std::streamsize size) {
  const std::lock_guard lock(mutex_);
  waiting_.append(text, static_cast<std::size_t>(size));
  return Pass(waiting_.rfind('\n') + 1) ? size : 0;  // npos + 1 = 0
}

int CleanOutput::sync() {
  const std::lock_guard lock(mutex_);
  const bool passed = Pass(waiting_.size());
  return target_->pubsync() == 0 && passed ? 0 : -1;
}

bool CleanOutput::Pass(std::size_t size) {
  const std::string clean = PrintableLines(waiting_.substr(0, size));
  waiting_.erase(0, size);
  const auto length = static_cast<std::streamsize>(clean.size());
  return target_->sputn(clean.data(), length) == length;
}

}  // namespace cvo
