// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/files/json/json.h"
#include "reports/page/page_content.h"

namespace cvo::reports {

// The sections of the page as HTML. Each is always present, even if it only says that there is
// nothing to show.

// What was compared, on which sequences, what is missing, and which differences are significant.
std::string SummarySection(const PageContent& content);
// The same for the comparison of two folders. Empty if there is no other folder.
std::string ComparisonSection(const PageContent& content);
std::string TableSection(const PageContent& content);
std::string FigureSection(const PageContent& content);
std::string SceneSection(const PageContent& content);
std::string MissingSection(const PageContent& content);
std::string GlossarySection(const PageContent& content);
// Builds, machines and options of the runs.
std::string OriginSection(const PageContent& content);
std::string LicenceSection();

// A table that the script of the page makes sortable, with cells that open. `name` is "table" or
// "comparison"; the page's data holds its cells under that name.
std::string TableFrame(const Table& table, const std::string& name);

// The data about tables and runs that the script of the page needs, as JSON without '<'.
std::string PageDataJson(const PageContent& content);

// What the 3D view draws of a run. Positions are in whole millimetres, three consecutive numbers
// each. The frames of clusters and bodies are indices into "frames". Images are data URLs.
Json SceneJson(const PageScene& scene);

// The list of findings for each row with respect to its reference.
std::string FindingsHtml(const Table& table, const std::string& reference);

}  // namespace cvo::reports
