// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/files/json/json.h"
#include "reports/page/page_content.h"

namespace cvo::reports {

// Sections of the page as HTML; each is there, also where it has nothing but that to say.

// What was compared, on what, what is missing, and which differences are real.
std::string SummarySection(const PageContent& content);
// The same of two folders; empty where there is no other.
std::string ComparisonSection(const PageContent& content);
std::string TableSection(const PageContent& content);
std::string FigureSection(const PageContent& content);
std::string SceneSection(const PageContent& content);
std::string MissingSection(const PageContent& content);
std::string GlossarySection(const PageContent& content);
// Builds, machines, options and seeds of all runs.
std::string OriginSection(const PageContent& content);
std::string LicenceSection();

// A table that the page's script sorts, filters and opens cells of: `name` is "table" or
// "comparison", whose cells are in the page's data under that name.
std::string TableFrame(const Table& table, const std::string& name);

// What the page's script needs of tables and runs, as JSON without '<'.
std::string PageDataJson(const PageContent& content);

// What the 3D view draws of a run. Positions are whole millimetres, three numbers after each other;
// frames of clusters and bodies are indices into "frames"; images are data URLs.
Json SceneJson(const PageScene& scene);

// The list of what can be told of each row against its reference.
std::string FindingsHtml(const Table& table, const std::string& reference);

}  // namespace cvo::reports
