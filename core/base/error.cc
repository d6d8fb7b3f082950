// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/error.h"

#include "core/base/message.h"

namespace cvo {

void ThrowError(const std::string& where, const std::string& found, const std::string& expected) {
  throw Error(Shortened(StrCat(where, ": found ", found, ", expected ", expected)));
}

void Require(bool condition, const char* message) {
  if (!condition) throw Error(message);
}

}  // namespace cvo
