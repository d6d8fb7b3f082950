// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// One libFuzzer program for all parsers:
//   fuzz_target seeds FOLDER         writes seeds and a dictionary for each parser, prints its name
//   fuzz_target PARSER [ARGUMENTS]   fuzzes this parser, or reads the given files once; the
//                                    arguments are those of libFuzzer
// A finding aborts the program; libFuzzer keeps the input.
#include <stdlib.h>
#include <unistd.h>

#include <iostream>
#include <optional>
#include <set>

#include "core/base/error.h"
#include "core/files/text_file.h"
#include "tests/faults/parsers.h"

namespace cvo::test {
namespace {

namespace fs = std::filesystem;

// A parser and its input file, in a temporary folder (which TMPDIR may place in memory).
class Target {
 public:
  explicit Target(Parser parser) : parser_(std::move(parser)) {
    std::string folder = fs::temp_directory_path() / "fuzz_XXXXXX";
    if (::mkdtemp(folder.data()) == nullptr) ThrowError(folder, "no folder", "one for its file");
    folder_ = folder;
  }
  ~Target() { fs::remove_all(folder_); }
  Target(const Target&) = delete;
  Target& operator=(const Target&) = delete;

  void Read(std::string_view bytes) const {
    const fs::path file = folder_ / parser_.name;
    WriteFileBytes(file, bytes);
    if (const std::string why = Finding(parser_, file); !why.empty()) {
      std::cerr << parser_.name << ": " << why << std::endl;
      std::abort();
    }
  }

 private:
  Parser parser_;
  fs::path folder_;
};

// Global, since the entry points of libFuzzer cannot pass it on.
std::optional<Target>& TheTarget() {
  static std::optional<Target> target;
  return target;
}

std::string DictionaryEntry(std::string_view word) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string entry = "\"";
  for (const unsigned char byte : word) {
    entry += {'\\', 'x', kDigits[byte / 16], kDigits[byte % 16]};
  }
  return entry + "\"\n";
}

// Returns a dictionary of the keys, values and numbers of the seeds and of HostilePieces().
std::string Dictionary(const Parser& parser) {
  constexpr std::size_t kLongest = 60;  // libFuzzer accepts up to 64
  std::set<std::string> words;
  for (const std::string& text : parser.seeds) {
    std::size_t at = 0;
    for (auto word = WordFrom(text, at); !word.empty(); word = WordFrom(text, at)) {
      words.emplace(word);
      at = static_cast<std::size_t>(word.data() - text.data()) + word.size();
    }
  }
  words.insert(HostilePieces().begin(), HostilePieces().end());
  std::string all;
  for (const std::string& word : words) {
    if (word.size() <= kLongest) all += DictionaryEntry(word);
  }
  return all;
}

void WriteSeeds(const fs::path& folder) {
  for (const Parser& parser : AllParsers()) {
    const fs::path seeds = folder / parser.name / "seeds";
    fs::create_directories(seeds);
    for (std::size_t i = 0; i < parser.seeds.size(); ++i) {
      WriteFileBytes(seeds / std::to_string(i), parser.seeds[i]);
    }
    WriteFileBytes(folder / parser.name / "dictionary", Dictionary(parser));
    std::cout << parser.name << '\n';
  }
}

void Start(const std::vector<std::string>& arguments) {
  if (arguments.size() == 2 && arguments[0] == "seeds") {
    WriteSeeds(arguments[1]);
    std::exit(0);
  }
  for (const Parser& parser : AllParsers()) {
    if (!arguments.empty() && parser.name == arguments[0]) TheTarget().emplace(parser);
  }
  if (!TheTarget()) {
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
  cvo::test::TheTarget()->Read({reinterpret_cast<const char*>(data), size});
  return 0;
}
