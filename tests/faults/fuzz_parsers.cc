// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// fuzz_parsers MUTATIONS [SEED] [PARSER]: gives each parser this many corrupted files. A crash, a
// long run time or any exception but cvo::Error is a finding; its input remains as
// spoilt/<parser>. Independent of libFuzzer (fuzz_target.cc), so that every `make test` can run it.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>

#include "core/base/error.h"
#include "core/base/rng.h"
#include "core/files/text_file.h"
#include "tests/faults/parsers.h"

namespace cvo::test {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

class Mutator {
 public:
  Mutator(const std::vector<std::string>& seeds, Rng& rng) : seeds_(seeds), rng_(rng) {}

  std::string Next() {
    std::string text = Pick(seeds_);
    const std::uint64_t changes = 1 + rng_.UniformInt(4);
    for (std::uint64_t i = 0; i < changes; ++i) Change(text);
    return text;
  }

 private:
  template <typename T>
  const T& Pick(const std::vector<T>& values) {
    return values[rng_.UniformInt(values.size())];
  }
  std::size_t Place(const std::string& text) { return rng_.UniformInt(text.size() + 1); }

  void Change(std::string& text) {
    const std::size_t at = Place(text);
    const std::size_t length = rng_.UniformInt(40);
    switch (rng_.UniformInt(7)) {
      case 0:
        if (at < text.size()) text[at] = static_cast<char>(text[at] ^ (1 << rng_.UniformInt(8)));
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(at, Pick(HostilePieces()));
        break;
      case 3:
        ReplaceWord(text, at);
        break;
      case 4:
        text.insert(Place(text), text.substr(at, length));
        break;
      case 5:
        text.resize(at);
        break;
      default:
        text.replace(at, std::string::npos, Pick(seeds_).substr(0, Place(text)));
    }
  }

  // Replaces a whole number, key or value.
  void ReplaceWord(std::string& text, std::size_t at) {
    const std::string_view word = WordFrom(text, at);
    if (word.empty()) return;
    text.replace(static_cast<std::size_t>(word.data() - text.data()), word.size(),
                 Pick(HostilePieces()));
  }

  const std::vector<std::string>& seeds_;
  Rng& rng_;
};

bool Attack(const Parser& parser, int mutations, std::uint64_t seed) {
  const fs::path file = fs::absolute("spoilt") / parser.name;
  fs::create_directories(file.parent_path());
  for (const std::string& text : parser.seeds) {
    WriteFileBytes(file, text);
    if (const std::string why = Finding(parser, file); !why.empty()) {
      std::cerr << parser.name << ": " << why << ", a seed\n";
      return false;
    }
  }
  Rng rng(seed, parser.name);
  Mutator mutator(parser.seeds, rng);
  const auto start = Clock::now();
  for (int i = 0; i < mutations; ++i) {
    WriteFileBytes(file, mutator.Next());
    if (const std::string why = Finding(parser, file); !why.empty()) {
      std::cerr << parser.name << ": " << why << ", seed " << seed << ", mutation " << i << ": "
                << file.string() << '\n';
      return false;
    }
  }
  fs::remove(file);
  const std::chrono::duration<double> took = Clock::now() - start;
  std::cout << parser.name << ": " << mutations << " inputs in " << took.count() << " s\n";
  return true;
}

int Main(int argc, char** argv) {
  const int mutations = argc > 1 ? std::atoi(argv[1]) : 0;
  if (mutations <= 0) {
    std::cerr << "fuzz_parsers MUTATIONS [SEED] [PARSER]\n";
    return 2;
  }
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  bool good = true;
  for (const Parser& parser : AllParsers()) {
    if (argc > 3 && parser.name != argv[3]) continue;
    good = Attack(parser, mutations, seed) && good;
  }
  return good ? 0 : 1;
}

}  // namespace
}  // namespace cvo::test

int main(int argc, char** argv) { return cvo::test::Main(argc, argv); }
