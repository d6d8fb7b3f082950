// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "reports/page/page_content.h"

namespace cvo::reports {

// One self-contained page that needs no network: the same bytes for the same content. What it says
// stands in it as HTML; its script sorts, filters, draws and moves.
std::string PageHtml(const PageContent& content);

}  // namespace cvo::reports
