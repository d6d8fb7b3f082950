// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// One libFuzzer program for all parsers:
//   fuzz_target seeds FOLDER         writes the seeds of each parser and prints its name
//   fuzz_target PARSER [ARGUMENTS]   fuzzes this parser, or reads the given files once; the
//                                    arguments are those of libFuzzer
// A finding aborts the program; libFuzzer keeps the input.
#include <unistd.h>

#include <cstdlib>
#include <iostream>

#include "core/base/error.h"
#include "core/files/text_file.h"
#include "tests/faults/parsers.h"

namespace cvo::test {
namespace {

namespace fs = std::filesystem;

// Global, since the entry points of libFuzzer cannot pass it on.
Parser& TheParser() {
  static Parser parser;
  return parser;
}

void WriteSeeds(const fs::path& folder) {
  for (const Parser& parser : AllParsers()) {
    fs::create_directories(folder / parser.name / "corpus");
    fs::create_directories(folder / parser.name / "seeds");
    for (std::size_t i = 0; i < parser.seeds.size(); ++i) {
      WriteFileBytes(folder / parser.name / "seeds" / std::to_string(i), parser.seeds[i]);
    }
    std::cout << parser.name << '\n';
  }
}

void Start(const std::vector<std::string>& arguments) {
  if (arguments.size() == 2 && arguments[0] == "seeds") {
    WriteSeeds(arguments[1]);
    std::exit(0);
  }
  for (const Parser& parser : AllParsers()) {
    if (!arguments.empty() && parser.name == arguments[0]) TheParser() = parser;
  }
  if (!TheParser().read) {
    std::cerr << "fuzz_target seeds FOLDER | PARSER [flags of libFuzzer] [FILE ...]\n";
    std::exit(2);
  }
}

}  // namespace
}  // namespace cvo::test

// The first argument is for Start(), the others are for libFuzzer.
extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  cvo::test::Start({*argv + 1, *argv + *argc});
  (*argv)[1] = (*argv)[0];
  ++*argv;
  --*argc;
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace cvo;
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / StrCat("fuzz_", ::getpid());
  const std::filesystem::path file = folder / test::TheParser().name;
  std::filesystem::create_directories(folder);
  WriteFileBytes(file, {reinterpret_cast<const char*>(data), size});
  const std::string why = test::Finding(test::TheParser(), file);
  if (why.empty()) return 0;
  std::cerr << test::TheParser().name << ": " << why << std::endl;
  std::abort();
}
