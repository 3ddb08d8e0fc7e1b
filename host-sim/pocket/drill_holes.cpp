#include "host-sim/pocket/drill_holes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "host-sim/pocket/areas.hpp"

namespace sim::pocket {
namespace {

using cnc::pocket::Use;
using Point = cnc::pocket::PathPoint<double>;
/// For each point, the depth of its hole below the top of the stock, mm, above 0.
using Holes = std::map<std::pair<double, double>, double>;

void find_holes(cnc::contour::Slice<const Point> row, Holes& holes) {
  for (std::size_t i = 0; i + 1 < row.size(); ++i) {
    const Point& from = row[i];
    const Point& to = row[i + 1];
    if (from.use != Use::kEntry || from.point() != to.point() || to.z >= from.z) continue;
    double& depth_mm = holes[{from.x, from.y}];
    depth_mm = std::max(depth_mm, -to.z);
  }
}

PathRows pecks_of(const std::pair<double, double>& place, double depth_mm, double peck_mm) {
  const auto& [x, y] = place;
  const double pecks = std::ceil(depth_mm / peck_mm);
  PathRows rows;
  for (double peck = 0.0; peck < pecks; peck += 1.0) {
    rows.points.push_back({x, y, -depth_mm * peck / pecks, 0.0, Use::kEntry});
    rows.points.push_back({x, y, -depth_mm * (peck + 1.0) / pecks, 0.0, Use::kEntry});
    rows.end_row();
  }
  return rows;
}

}  // namespace

PathRows drill_holes(const cnc::pocket::ToolPathView<double>& path, double peck_mm) {
  Holes holes;
  for (std::size_t row = 0; row < path.row_ends.size(); ++row) {
    const std::uint32_t begin = path.row_begin(row);
    find_holes({path.points.begin() + begin, path.row_ends[row] - begin}, holes);
  }
  std::vector<PathRows> drilled;
  for (const auto& [place, depth_mm] : holes) drilled.push_back(pecks_of(place, depth_mm, peck_mm));
  PathRows all;
  for (const std::size_t index : short_order(drilled)) all.append(drilled[index]);
  return all;
}

}  // namespace sim::pocket
