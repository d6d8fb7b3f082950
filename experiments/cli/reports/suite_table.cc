// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/reports/suite_table.h"

#include <iostream>

#include "core/files/atomic_file.h"
#include "core/files/json/options_json.h"
#include "core/interface/options.h"
#include "experiments/cli/output_place.h"
#include "reports/formats/table_text.h"
#include "reports/tables/make_table.h"
#include "reports/tables/table_json.h"

namespace cvo {

std::string DefaultOptions() {
  Options options;
  return DumpJson(OptionsToJson(OptionLeaves(options)));
}

int OutputSuiteTable(const std::filesystem::path& folder, const TableFormat& format,
                     const std::string& compared_with) {
  CheckNoCollection(folder);
  const reports::Table table =
      reports::MakeTable(folder, reports::ShippedReference(), DefaultOptions(), compared_with);
  const bool is_kept = format.Terminal() && compared_with.empty();
  if (is_kept) {
    WriteFilesAtomically(folder, {{"table.md", reports::TableMarkdown(table)},
                                  {"table.json", reports::TableJson(table)}});
  }
  OutputTable(table, format, {folder / "plan.json"});
  if (is_kept) {
    std::cout << (format.output.empty() ? "\n" : "")
              << "written: " << (folder / "table.json").string()
              << " and table.md, with the definitions of the columns\n";
  }
  return reports::IsComplete(table) ? 0 : kIncomplete;
}

}  // namespace cvo
