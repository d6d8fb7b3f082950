// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/truth/object_table.h"

#include <string_view>

#include "core/base/error.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"

namespace cvo::synth {
namespace {

constexpr std::string_view kHeader =
    "frame,id,name,category,x,y,z,qx,qy,qz,qw,vx,vy,vz,wx,wy,wz,length_m,width_m,height_m,"
    "visible_px,alone_px,visible_fraction,truncation,visible_left,visible_top,visible_right,"
    "visible_bottom,amodal_left,amodal_top,amodal_right,amodal_bottom";
constexpr std::size_t kColumns = 32;

void AddNumber(double value, std::string& row) {
  row += ',';
  row += FormatDouble(value);
}

void AddVector(const Eigen::Vector3d& vector, std::string& row) {
  for (int i = 0; i < 3; ++i) AddNumber(vector[i], row);
}

void AddBox(const std::optional<PixelBox>& box, std::string& row) {
  if (!box) {
    row += ",,,,";
    return;
  }
  for (const double side : {box->left, box->top, box->right, box->bottom}) AddNumber(side, row);
}

std::vector<std::string_view> SplitAtCommas(std::string_view line) {
  std::vector<std::string_view> columns;
  while (true) {
    const std::size_t comma = line.find(',');
    columns.push_back(line.substr(0, comma));
    if (comma == std::string_view::npos) return columns;
    line.remove_prefix(comma + 1);
  }
}

// One line of the table.
class Row {
 public:
  Row(const TextFile& file, std::size_t index)
      : file_(file), index_(index), columns_(SplitAtCommas(file.line(index))) {
    if (columns_.size() != kColumns) {
      ThrowError(file.Where(index), StrCat(columns_.size(), " columns"), StrCat(kColumns));
    }
  }

  std::string Text(std::size_t column) const { return std::string(columns_[column]); }
  double Number(std::size_t column) const {
    const auto number = ParseDouble(columns_[column]);
    if (!number) Fail(column, "a number");
    return *number;
  }
  int Integer(std::size_t column) const {
    const auto number = ParseInteger(columns_[column]);
    if (!number || *number < 0 || *number > 1'000'000'000) Fail(column, "a whole number");
    return static_cast<int>(*number);
  }
  Eigen::Vector3d Vector(std::size_t column) const {
    return {Number(column), Number(column + 1), Number(column + 2)};
  }
  std::optional<PixelBox> Box(std::size_t column) const {
    if (columns_[column].empty()) return std::nullopt;
    return PixelBox{Number(column), Number(column + 1), Number(column + 2), Number(column + 3)};
  }
  [[noreturn]] void Fail(std::size_t column, const std::string& expected) const {
    ThrowError(file_.Where(index_), StrCat(Quoted(columns_[column]), " in column ", column + 1),
               expected);
  }

 private:
  const TextFile& file_;
  std::size_t index_;
  std::vector<std::string_view> columns_;
};

BodyTruth ReadBody(const Row& row) {
  BodyTruth body;
  body.id = row.Integer(1);
  const Eigen::Quaterniond rotation(row.Number(10), row.Number(7), row.Number(8), row.Number(9));
  body.state.world_from_body = RigidTransform(rotation, row.Vector(4));
  body.state.velocity_in_world = row.Vector(11);
  body.state.angular_velocity_in_world = row.Vector(14);
  body.visible_px = row.Integer(20);
  body.alone_px = row.Integer(21);
  body.visible_fraction = row.Number(22);
  body.truncation = row.Number(23);
  body.visible_box = row.Box(24);
  body.amodal_box = row.Box(28);
  return body;
}

}  // namespace

std::string ObjectTableHeader() { return std::string(kHeader) + "\n"; }

std::string FormatObjectRows(const World& world, const FrameTruth& truth, int row_frame,
                             const RigidTransform& first_left_from_world) {
  std::string rows;
  for (const BodyTruth& body : truth.bodies) {
    const Body& described = world.bodies.at(static_cast<std::size_t>(body.id - 1));
    Require((described.name + described.category).find_first_of(", \t\n\"") == std::string::npos,
            "objects.csv: names and categories must have no blank, comma or quote");
    rows += StrCat(row_frame, ",", body.id, ",", described.name, ",", described.category);
    const RigidTransform pose = first_left_from_world * body.state.world_from_body;
    AddVector(pose.translation(), rows);
    for (int i = 0; i < 4; ++i) AddNumber(pose.data()[i], rows);
    AddVector(first_left_from_world.rotation() * body.state.velocity_in_world, rows);
    AddVector(first_left_from_world.rotation() * body.state.angular_velocity_in_world, rows);
    AddVector(described.size_m, rows);
    rows += StrCat(",", body.visible_px, ",", body.alone_px);
    AddNumber(body.visible_fraction, rows);
    AddNumber(body.truncation, rows);
    AddBox(body.visible_box, rows);
    AddBox(body.amodal_box, rows);
    rows += '\n';
  }
  return rows;
}

ObjectTable ReadObjectTable(const std::filesystem::path& path, const std::vector<double>& times_s) {
  const TextFile file(path);
  if (file.size() == 0 || file.line(0) != kHeader) {
    ThrowError(path.string(), "another first line", "the header of objects.csv");
  }
  ObjectTable table;
  table.frames.resize(times_s.size());
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    table.frames[i].frame = static_cast<int>(i);
    table.frames[i].time_s = times_s[i];
  }
  for (std::size_t i = 1; i < file.size(); ++i) {
    const Row row(file, i);
    const auto frame = static_cast<std::size_t>(row.Integer(0));
    if (frame >= table.frames.size()) row.Fail(0, "a frame of the folder");
    std::vector<BodyTruth>& bodies = table.frames[frame].bodies;
    bodies.push_back(ReadBody(row));
    if (bodies.back().id != static_cast<int>(bodies.size())) row.Fail(1, "ids 1, 2, ...");
    if (bodies.size() <= table.names.size()) continue;
    table.names.push_back(row.Text(2));
    table.categories.push_back(row.Text(3));
    table.sizes_m.push_back(row.Vector(17));
  }
  return table;
}

}  // namespace cvo::synth
