// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/web/assets.h"

// Files that the assembler embeds (assets.s.in): their first byte, and one past their last.
extern "C" {
extern const char cvo_plotly_begin[], cvo_plotly_end[];
extern const char cvo_plotly_licence_begin[], cvo_plotly_licence_end[];
extern const char cvo_app_begin[], cvo_app_end[];
extern const char cvo_style_begin[], cvo_style_end[];
extern const char cvo_policy_begin[], cvo_policy_end[];
}

namespace cvo::reports {
namespace {

std::string_view Between(const char* begin, const char* end) {
  return {begin, static_cast<std::size_t>(end - begin)};
}

}  // namespace

std::string_view PlotlyScript() { return Between(cvo_plotly_begin, cvo_plotly_end); }

std::string_view PlotlyLicence() {
  return Between(cvo_plotly_licence_begin, cvo_plotly_licence_end);
}

std::string_view AppScript() { return Between(cvo_app_begin, cvo_app_end); }

std::string_view AppStyle() { return Between(cvo_style_begin, cvo_style_end); }

std::string_view ContentPolicy() { return Between(cvo_policy_begin, cvo_policy_end); }

}  // namespace cvo::reports
