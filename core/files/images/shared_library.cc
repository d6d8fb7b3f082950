// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/files/images/shared_library.h"

#include <dlfcn.h>

#include <new>

#include "core/base/error.h"

namespace cvo {
namespace {

// How the dynamic loader says that memory is exhausted; it gives no error number, but may add the
// text of one. "cannot allocate memory in static TLS block" is another failure.
bool IsLackOfMemory(const std::string& message) {
  return message.find("failed to map segment") != message.npos ||
         message.find("Cannot allocate memory") != message.npos;
}

[[noreturn]] void Fail(const std::string& library, const std::string& expected) {
  const char* text = ::dlerror();
  const std::string message = text == nullptr ? "no reason" : text;
  if (IsLackOfMemory(message)) throw std::bad_alloc();
  ThrowError(library, message, expected);
}

}  // namespace

void* FindSymbol(const std::string& library, const char* symbol) {
  void* const loaded = ::dlopen(library.c_str(), RTLD_LAZY | RTLD_LOCAL);
  if (loaded == nullptr) Fail(library, "a shared library that can be loaded");
  void* const found = ::dlsym(loaded, symbol);
  if (found == nullptr) Fail(library, StrCat("the function ", symbol));
  return found;
}

}  // namespace cvo
