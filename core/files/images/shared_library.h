// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace cvo {

// Finds a function in a shared library, which is loaded at the first call and stays loaded. The
// libraries for image files, video and OpenGL bring two hundred others with them: a program that is
// linked with them starts in half a second, and without them in a tenth of that. Throws Error if
// the library cannot be loaded or has no such symbol, std::bad_alloc if it does not fit into
// memory.
void* FindSymbol(const std::string& library, const char* symbol);

template <typename Function>
Function* FindFunction(const std::string& library, const char* symbol) {
  return reinterpret_cast<Function*>(FindSymbol(library, symbol));
}

}  // namespace cvo
