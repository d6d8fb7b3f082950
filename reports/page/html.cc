// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/page/html.h"

#include "core/files/text/escape.h"
#include "core/files/text/utf8.h"

namespace cvo::reports {
std::string Escaped(std::string_view text) { return HtmlEscaped(Printable(text)); }

std::string Element(const std::string& tag, std::string_view text) {
  return "<" + tag + ">" + Escaped(text) + "</" + tag + ">";
}

std::string DataBlock(const std::string& id, const std::string& script_json) {
  return "<script type=\"application/json\" id=\"" + Escaped(id) + "\">" + script_json +
         "</script>\n";
}

}  // namespace cvo::reports
