// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/files/json.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <vector>

#include "core/base/error.h"
#include "core/files/text_file.h"

namespace cvo {
namespace {

// "line 3, column 7" of a byte of the text.
std::string Position(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte, text.size()));
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 = 0
  return StrCat("line ", line, ", column ", std::max<std::size_t>(1, before.size() - line_start));
}

// What walks through a value calls itself for each level.
constexpr int kMostDepth = 200;

// Refuses keys that an object has twice, which the parser itself would silently overwrite, and
// values that are too deep.
class ParseCheck {
 public:
  explicit ParseCheck(const std::string& where) : where_(where) {}

  bool operator()(int depth, Json::parse_event_t event, Json& parsed) {
    if (depth > kMostDepth) {
      ThrowError(where_, StrCat("more than ", kMostDepth, " brackets in each other"), "fewer");
    }
    if (event == Json::parse_event_t::object_start) {
      open_.emplace_back();
    } else if (event == Json::parse_event_t::object_end) {
      open_.pop_back();
    } else if (event == Json::parse_event_t::key) {
      const std::string key = parsed.get<std::string>();
      if (!open_.back().insert(key).second) {
        ThrowError(where_, StrCat("key \"", key, "\" twice in one object"), "every key once");
      }
    }
    return true;
  }

 private:
  const std::string& where_;
  std::vector<std::set<std::string>> open_;
};

bool IsScalar(const Json& value) { return !value.is_structured(); }

// Bytes that are not UTF-8 (a folder's name can hold any) become U+FFFD.
std::string DumpScalar(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// A container whose elements are scalars or arrays of scalars.
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
    char buffer[32];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, number).ptr;
    text_.append(buffer, end);
    // Stays a floating-point number for readers that tell 1 from 1.0.
    if (std::find_if(buffer, end, [](char c) { return c == '.' || c == 'e'; }) == end) {
      text_ += ".0";
    }
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

}  // namespace

Json ParseJson(std::string_view text, const std::string& where) {
  ParseCheck check(where);
  try {
    return Json::parse(text, [&check](int depth, Json::parse_event_t event, Json& parsed) {
      return check(depth, event, parsed);
    });
  } catch (const Json::parse_error& error) {
    const std::string what = error.what();
    const std::size_t detail = what.find(": ");
    ThrowError(StrCat(where, ", ", Position(text, error.byte)),
               detail == std::string::npos ? what : what.substr(detail + 2), "JSON");
  } catch (const Json::exception& error) {
    ThrowError(where, error.what(), "JSON");
  }
}

Json ReadJson(const std::filesystem::path& file) {
  return ParseJson(ReadFileBytes(file), file.string());
}

std::string DumpJson(const Json& value) {
  Writer writer;
  writer.Write(value, "", 0, false);
  return writer.Take() + "\n";
}

}  // namespace cvo
