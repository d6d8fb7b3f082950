// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "reports/page/page_content.h"

namespace cvo::reports {

// What the page's script needs of tables and runs, as JSON without '<'.
std::string PageDataJson(const PageContent& content);

}  // namespace cvo::reports
