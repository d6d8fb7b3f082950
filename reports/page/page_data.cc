// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <map>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "reports/figures/numbers.h"
#include "reports/figures/plot.h"
#include "reports/page/html.h"
#include "reports/page/page_parts.h"
#include "reports/page/quantity.h"
#include "reports/tables/comparisons.h"

namespace cvo::reports {
namespace {

// A list of values that many runs share. Each value is written once.
class SharedList {
 public:
  std::size_t IndexOf(const Json& value) {
    const std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
    const auto [entry, added] = indices_.try_emplace(text, values_.size());
    if (added) values_.push_back(value);
    return entry->second;
  }
  const Json& values() const { return values_; }

 private:
  std::map<std::string, std::size_t> indices_;
  Json values_ = Json::array();
};

Json FactsJson(const std::vector<Fact>& facts) {
  Json json = Json::array();
  for (const auto& [name, value] : facts) json.push_back({name, value});
  return json;
}

Json OptionsJson(const std::vector<ChangedOption>& options) {
  Json json = Json::array();
  for (const ChangedOption& option : options) {
    json.push_back({option.path, option.values.front(), option.default_value});
  }
  return json;
}

struct SharedLists {
  SharedList builds, machines, options;
};

Json RunJson(const PageRun& run, SharedLists& shared) {
  Json keys = Json::object();
  for (const auto& [key, value] : run.run.planned.keys) {
    if (value != "none") keys[key] = value;
  }
  return {{"keys", keys},
          {"seed", run.run.planned.seed},
          {"state", run.run.state},
          {"message", run.run.message},
          {"log", run.run.log},
          {"job", run.run.planned.job},
          {"result", run.result},
          {"time", FactsJson(run.origin.time)},
          {"build", shared.builds.IndexOf(FactsJson(run.origin.build))},
          {"machine", shared.machines.IndexOf(FactsJson(run.origin.machine))},
          {"options", shared.options.IndexOf(OptionsJson(run.options))}};
}

std::string CountsText(const Counts& n) {
  const std::string text = StrCat(Counted(n.runs, "run"), ", ", Counted(n.scenes, "scene"), ", ",
                                  Counted(n.seeds, "seed"));
  return n.bodies > 0 ? StrCat(text, ", ", Counted(n.bodies, "body", "bodies")) : text;
}

Json DifferenceJson(const Difference& difference, const Column& column) {
  Json json = Json::array();
  const auto add = [&json](const char* name, const std::string& value) {
    json.push_back({name, value});
  };
  add("against", difference.reference);
  add("difference", ChangeText(difference.difference, column));
  if (difference.interval) {
    add("interval of the difference", RangeText(*difference.interval, column));
    add("interval of", difference.interval->meaning);
  }
  add("value and reference value", StrCat(QuantityText(difference.value, column), " and ",
                                          QuantityText(difference.reference_value, column)));
  if (difference.percent) add("in percent", StrCat(NumberText(*difference.percent), " %"));
  add("pairs", StrCat(difference.pairs, ": ", difference.pairing));
  add("verdict", VerdictText(difference, column.metric));
  return json;
}

Json CellJson(const Cell& cell, const Column& column) {
  Json facts = Json::array();
  const auto add = [&facts](const char* name, const std::string& value) {
    if (!value.empty()) facts.push_back({name, value});
  };
  add("value", cell.present ? QuantityText(cell.value, column) : "");
  add("why there is no value", cell.message);
  if (cell.interval) {
    add("interval", RangeText(*cell.interval, column));
    add("interval of", cell.interval->meaning);
  }
  add("mean of", cell.present ? CountsText(cell.n) : "");
  add("left out", cell.left_out);
  add("not comparable", cell.not_comparable);
  Json json = {{"facts", facts}, {"runs", cell.runs}};
  if (cell.difference) json["difference"] = DifferenceJson(*cell.difference, column);
  return json;
}

Json TableDataJson(const Table& table) {
  Json columns = Json::array();
  for (const Column& column : table.columns) {
    columns.push_back({{"metric", column.metric}, {"label", column.label}, {"unit", column.unit}});
  }
  Json rows = Json::array();
  for (const Row& row : table.rows) {
    Json cells = Json::array();
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      cells.push_back(CellJson(row.cells[i], table.columns[i]));
    }
    Json results = Json::array();
    for (const RunLink& run : row.runs) results.push_back(run.result);
    rows.push_back({{"label", RowLabel(row)},
                    {"keys", row.keys},
                    {"results", results},
                    {"cells", std::move(cells)}});
  }
  return {{"keys", table.keys}, {"columns", columns}, {"rows", rows}};
}

Json ScenesJson(const PageContent& content) {
  Json scenes = Json::array();
  for (const PageScene& scene : content.scenes) {
    scenes.push_back({{"run", scene.run},
                      {"images", scene.images.size()},
                      {"no_images", scene.no_images},
                      {"images_folder", scene.images_folder},
                      {"missing", scene.detail.missing}});
  }
  return scenes;
}

}  // namespace

std::string PageDataJson(const PageContent& content) {
  SharedLists shared;
  Json runs = Json::array();
  for (const PageRun& run : content.runs) runs.push_back(RunJson(run, shared));
  Json json = {{"title", content.title}};
  if (content.table) json["table"] = TableDataJson(*content.table);
  if (content.comparison) json["comparison"] = TableDataJson(*content.comparison);
  json["runs"] = std::move(runs);
  json["builds"] = shared.builds.values();
  json["machines"] = shared.machines.values();
  json["options"] = shared.options.values();
  json["scenes"] = ScenesJson(content);
  return ScriptJson(json);
}

}  // namespace cvo::reports
