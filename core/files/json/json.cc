// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/files/json/json.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "core/base/error.h"
#include "core/files/text/number.h"
#include "core/files/text/utf8.h"
#include "core/files/text_file.h"

namespace cvo {
namespace {

// Returns the position of a byte of the text as "line 3, column 7".
std::string Position(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte, text.size()));
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 = 0
  return StrCat("line ", line, ", column ", std::max<std::size_t>(1, before.size() - line_start));
}

constexpr int kMaxNesting = 100;  // deeper nesting could exhaust the stack

// Rejects what the parser itself would accept: duplicate keys in an object, of which it keeps the
// last; keys that would garble the messages that name them; and nesting of any depth.
class StrictEvents {
 public:
  StrictEvents(const std::string& where, const std::vector<std::string>& skipped)
      : where_(where), skipped_(skipped) {}

  // Returns false if the value is not to be kept.
  bool operator()(int depth, Json::parse_event_t event, Json& parsed) {
    const auto level = static_cast<std::size_t>(depth);
    if (event == Json::parse_event_t::object_start || event == Json::parse_event_t::array_start) {
      if (depth >= kMaxNesting) {
        ThrowError(where_, StrCat("more than ", kMaxNesting, " values within each other"),
                   StrCat("at most ", kMaxNesting));
      }
      if (keys_.size() <= level) keys_.resize(level + 1);
      keys_[level].clear();
    } else if (event == Json::parse_event_t::key) {
      const std::string key = parsed.get<std::string>();
      CheckKey(key, keys_[level - 1]);
      return depth != 1 || std::find(skipped_.begin(), skipped_.end(), key) == skipped_.end();
    }
    return true;
  }

 private:
  void CheckKey(const std::string& key, std::set<std::string>& keys) const {
    if (HasControl(key))
      ThrowError(where_, "key " + Quoted(key), "keys without control characters");
    if (!keys.insert(key).second) {
      ThrowError(where_, StrCat("key \"", key, "\" twice in one object"), "every key once");
    }
  }

  const std::string& where_;
  const std::vector<std::string>& skipped_;
  std::vector<std::set<std::string>> keys_;  // of the open object, by depth
};

[[noreturn]] void FailParse(std::string_view text, const std::string& where,
                            const Json::parse_error& error) {
  constexpr char kExpected[] = "one complete JSON value";
  if (error.byte > text.size()) {
    ThrowError(
        where,
        StrCat("text that ends after ", text.size(), " bytes, at ", Position(text, text.size())),
        kExpected);
  }
  const std::string what = error.what();
  const std::size_t detail = what.find(": ");
  ThrowError(StrCat(where, ", ", Position(text, error.byte)),
             Printable(detail == std::string::npos ? what : what.substr(detail + 2)), kExpected);
}

bool IsScalar(const Json& value) { return !value.is_structured(); }

// Replaces bytes that are not UTF-8, which the name of a folder may contain, by U+FFFD.
std::string DumpScalar(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// Whether all elements of a container are scalars or arrays of scalars.
bool FitsOneRow(const Json& value) {
  return std::all_of(value.begin(), value.end(), [](const Json& element) {
    return IsScalar(element) ||
           (element.is_array() && std::all_of(element.begin(), element.end(), IsScalar));
  });
}

class Writer {
 public:
  std::string Take() { return std::move(text_); }

  void Write(const Json& value, const std::string& path, int indent, bool is_row) {
    if (value.is_number_float()) {
      WriteNumber(value.get<double>(), path);
    } else if (value.is_structured()) {
      const bool scalars = std::all_of(value.begin(), value.end(), IsScalar);
      const bool one_line =
          value.empty() || (value.is_array() && scalars) || (is_row && FitsOneRow(value));
      WriteContainer(value, path, indent, one_line);
    } else {
      text_ += DumpScalar(value);
    }
  }

 private:
  void WriteNumber(double number, const std::string& path) {
    if (!std::isfinite(number)) ThrowError(path, StrCat(number), "a finite number");
    const std::string digits = FormatDouble(number);
    text_ += digits;
    // Keeps it a floating-point number for readers that distinguish 1 from 1.0.
    if (digits.find_first_of(".e") == std::string::npos) text_ += ".0";
  }

  void WriteContainer(const Json& value, const std::string& path, int indent, bool one_line) {
    text_ += value.is_array() ? '[' : '{';
    std::size_t index = 0;
    for (auto it = value.begin(); it != value.end(); ++it, ++index) {
      if (index > 0) text_ += one_line ? ", " : ",";
      if (!one_line) NewLine(indent + 2);
      std::string element_path;
      if (value.is_object()) {
        text_ += DumpScalar(it.key()) + ": ";
        element_path = path.empty() ? it.key() : path + "." + it.key();
      } else {
        element_path = StrCat(path, "[", index, "]");
      }
      Write(*it, element_path, indent + 2, one_line || value.is_array());
    }
    if (!one_line) NewLine(indent);
    text_ += value.is_array() ? ']' : '}';
  }

  void NewLine(int indent) {
    text_ += '\n';
    text_.append(static_cast<std::size_t>(indent), ' ');
  }

  std::string text_;
};

void Flatten(const Json& value, const std::string& path, std::map<std::string, std::string>& flat) {
  if (!value.is_object()) {
    flat[path] = DumpScalar(value);
    return;
  }
  for (const auto& [key, inner] : value.items()) {
    Flatten(inner, path.empty() ? key : path + "." + key, flat);
  }
}

}  // namespace

Json ParseJson(std::string_view text, const std::string& where,
               const std::vector<std::string>& skipped) {
  if (text.empty()) ThrowError(where, "an empty file", "JSON");
  StrictEvents check(where, skipped);
  try {
    return Json::parse(text, [&check](int depth, Json::parse_event_t event, Json& parsed) {
      return check(depth, event, parsed);
    });
  } catch (const Json::parse_error& error) {
    FailParse(text, where, error);
  } catch (const Json::exception& error) {
    ThrowError(where, Printable(error.what()), "JSON");
  }
}

Json ReadJson(const std::filesystem::path& file, const std::vector<std::string>& skipped) {
  return ParseJson(ReadFileBytes(file), file.string(), skipped);
}

std::map<std::string, std::string> FlatJson(const Json& value) {
  std::map<std::string, std::string> flat;
  Flatten(value, "", flat);
  return flat;
}

std::string DumpJson(const Json& value) {
  Writer writer;
  writer.Write(value, "", 0, false);
  return writer.Take() + "\n";
}

}  // namespace cvo
