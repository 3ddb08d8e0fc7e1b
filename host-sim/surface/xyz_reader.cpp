#include "host-sim/surface/xyz_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "host-sim/surface/grid_check.hpp"
#include "host-sim/surface/lattice.hpp"
#include "host-sim/surface/refusal.hpp"
#include "host-sim/surface/scan_rows.hpp"
#include "host-sim/surface/xyz_table.hpp"

namespace sim::surface {
namespace {

/// Scales the points to mm. Refuses a point whose X or Y is not finite or whose height is infinite.
void take_unit(XyzTable& table, const std::string& name, double unit_mm) {
  for (std::size_t i = 0; i < table.points.size(); ++i) {
    Eigen::Vector3d& point = table.points[i];
    if (!point.head<2>().allFinite() || std::isinf(point.z())) {
      refuse(name,
             table.lines[i],
             "a coordinate is not a finite number",
             "leave the point out, or write nan for a height that was not measured");
    }
    point *= unit_mm;
  }
}

/// Joins the rows to a grid. Each row gets the direction of the first row.
GridDraft joined_rows(XyzTable& table, const std::vector<ScanRow>& rows, const std::string& name) {
  GridDraft grid{.name = name, .rows = rows.size(), .columns = rows.front().size()};
  grid.points.reserve(table.points.size());
  grid.lines.reserve(table.points.size());
  for (const ScanRow& row : rows) {
    for (std::size_t column = 0; column < row.size(); ++column) {
      grid.points.push_back(table.points[row.index(column)]);
      grid.lines.push_back(table.lines[row.index(column)]);
    }
  }
  return grid;
}

/// Refuses rows of unequal length and names the first such row.
[[noreturn]] void refuse_rows(const XyzTable& table,
                              const std::vector<ScanRow>& rows,
                              const std::string& name) {
  const auto other = std::ranges::find_if(
      rows, [&](const ScanRow& row) { return row.size() != rows.front().size(); });
  refuse(name,
         table.lines[other->begin],
         fmt::format("row {} has {} points, but row 1 has {}",
                     other - rows.begin() + 1,
                     other->size(),
                     rows.front().size()),
         "give each row the same number of points, with blank lines between rows");
}

}  // namespace

GridDraft read_xyz(std::string_view text, const std::string& name, const ReadOptions& options) {
  XyzTable table = read_xyz_table(text, name);
  take_unit(table, name, options.unit_mm);
  const std::vector<ScanRow> rows = rows_of(table);
  const bool equal = std::ranges::all_of(
      rows, [&](const ScanRow& row) { return row.size() == rows.front().size(); });
  if (!equal) {
    auto lattice = lattice_of(table, rows, name);
    if (!lattice) refuse_rows(table, rows, name);
    lattice->notes = std::move(table.notes);
    return *std::move(lattice);
  }
  GridDraft grid = joined_rows(table, rows, name);
  if (options.repair && gaps_of(grid).count() > 0) {
    // If the points match a regular grid, points of absent rows become missing points, too.
    if (auto lattice = lattice_of(table, rows, name)) grid = *std::move(lattice);
  }
  grid.notes = std::move(table.notes);
  return grid;
}

}  // namespace sim::surface
