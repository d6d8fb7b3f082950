// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "reports/page/page_content.h"

namespace cvo::reports {

// One self-contained page, which needs no network. The same content gives the same bytes. All
// statements are in its HTML; its script sorts, filters, draws and animates.
std::string PageHtml(const PageContent& content);

}  // namespace cvo::reports
