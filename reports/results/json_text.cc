// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/results/json_text.h"

#include <array>
#include <fstream>

#include "core/base/error.h"

namespace cvo::reports {
namespace {

// Characters that end a run of uninteresting ones.
constexpr std::array<bool, 256> MakeStops() {
  std::array<bool, 256> stops{};
  for (const char c : {'{', '}', '[', ']', '"'}) stops[static_cast<unsigned char>(c)] = true;
  return stops;
}

class Scanner {
 public:
  Scanner(std::string_view text, const std::string& where) : text_(text), where_(where) {}

  // The next character that is not blank.
  char Peek() {
    while (at_ < text_.size() && IsBlank(text_[at_])) ++at_;
    if (at_ >= text_.size()) CutOff();
    return text_[at_];
  }
  void Expect(char c) {
    if (Peek() != c) BreaksOff();
    ++at_;
  }
  // Steps over a comma, or over the end: then false.
  bool Next(char end) {
    const char c = Peek();
    if (c != ',' && c != end) BreaksOff();
    ++at_;
    return c == ',';
  }
  std::string_view Value() {
    const char first = Peek();
    const std::size_t begin = at_;
    if (first == '{' || first == '[') {
      SkipNested();
    } else if (first == '"') {
      SkipString();
    } else {
      while (at_ < text_.size() && text_[at_] != ',' && text_[at_] != '}' && text_[at_] != ']' &&
             !IsBlank(text_[at_])) {
        ++at_;
      }
      if (at_ == begin) BreaksOff();
    }
    return text_.substr(begin, at_ - begin);
  }
  void ExpectEnd() {
    while (at_ < text_.size() && IsBlank(text_[at_])) ++at_;
    if (at_ < text_.size()) BreaksOff();
  }

 private:
  static bool IsBlank(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

  void SkipString() {
    for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_) {
      if (text_[at_] == '\\') ++at_;
    }
    if (at_ >= text_.size()) CutOff();
    ++at_;
  }
  void SkipNested() {
    static constexpr std::array<bool, 256> kStops = MakeStops();
    std::size_t depth = 0;
    do {
      while (at_ < text_.size() && !kStops[static_cast<unsigned char>(text_[at_])]) ++at_;
      if (at_ >= text_.size()) CutOff();
      const char c = text_[at_];
      if (c == '"') {
        SkipString();
        continue;
      }
      if (c == '{' || c == '[') {
        ++depth;
      } else {
        --depth;
      }
      ++at_;
    } while (depth > 0);
  }
  [[noreturn]] void CutOff() const {
    ThrowError(where_, StrCat("text that ends after ", text_.size(), " bytes"),
               "one complete JSON value");
  }
  [[noreturn]] void BreaksOff() const {
    ThrowError(where_, StrCat("text that breaks off at byte ", at_ + 1), "one complete JSON value");
  }

  std::string_view text_;
  const std::string& where_;
  std::size_t at_ = 0;
};

}  // namespace

std::vector<JsonMember> JsonMembers(std::string_view object, const std::string& where) {
  Scanner scanner(object, where);
  std::vector<JsonMember> members;
  scanner.Expect('{');
  if (scanner.Peek() == '}') return members;
  do {
    if (scanner.Peek() != '"') scanner.Expect('"');
    const std::string_view key = scanner.Value();
    scanner.Expect(':');
    members.emplace_back(key.substr(1, key.size() - 2), scanner.Value());
  } while (scanner.Next('}'));
  scanner.ExpectEnd();
  return members;
}

std::vector<std::string_view> JsonElements(std::string_view array, const std::string& where) {
  Scanner scanner(array, where);
  std::vector<std::string_view> elements;
  scanner.Expect('[');
  if (scanner.Peek() == ']') return elements;
  do {
    elements.push_back(scanner.Value());
  } while (scanner.Next(']'));
  scanner.ExpectEnd();
  return elements;
}

std::string_view FindMember(const std::vector<JsonMember>& members, std::string_view key) {
  for (const auto& [name, value] : members) {
    if (name == key) return value;
  }
  return {};
}

std::string ReadText(const std::filesystem::path& file) {
  std::error_code ignored;
  const bool regular = std::filesystem::is_regular_file(file, ignored);  // a pipe would block
  std::ifstream in;
  if (regular) in.open(file, std::ios::binary);
  if (!in.is_open()) {
    ThrowError(file.string(), "no file that can be read", "a JSON file");
  }
  in.seekg(0, std::ios::end);
  std::string text(static_cast<std::size_t>(in.tellg()), '\0');
  in.seekg(0);
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!in) ThrowError(file.string(), "a file that breaks off while it is read", "a JSON file");
  if (text.empty()) ThrowError(file.string(), "an empty file", "JSON");
  return text;
}

}  // namespace cvo::reports
