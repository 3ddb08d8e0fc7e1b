#include "host-sim/pocket/zigzag.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "host-sim/cut/stroke.hpp"
#include "host-sim/pocket/mirrored.hpp"
#include "host-sim/pocket/open_pocket.hpp"
#include "host-sim/pocket/pocket_plan.hpp"
#include "host-sim/pocket/wall_ramp.hpp"
#include "host-sim/pocket/zigzag_lines.hpp"

namespace sim::pocket {
namespace {

/// Greatest radius of turns, as a share of the distance between lines.
constexpr double kWidestTurn = 0.25;

void check(const ZigzagOptions& options) {
  const auto require = [](bool is_right, const char* what, double value) {
    if (!is_right) throw std::invalid_argument{fmt::format("{} {:g} is out of range", what, value)};
  };
  const double radius = options.tool_radius_mm;
  require(radius > 0.0 && std::isfinite(radius), "radius of the tool in mm", radius);
  require(options.stepover_mm > 0.0 && options.stepover_mm <= 2.0 * radius,
          "distance between lines in mm",
          options.stepover_mm);
  require(options.turn_radius_mm >= 0.0 && std::isfinite(options.turn_radius_mm),
          "radius of turns in mm",
          options.turn_radius_mm);
  require(
      options.depth_mm > 0.0 && std::isfinite(options.depth_mm), "depth in mm", options.depth_mm);
  require(options.slope > 0.0 && options.slope <= 1.0, "slope", options.slope);
}

/// Returns the radius of turns. It is limited because a line may end up to twice this radius before
/// the wall. The pass along the wall clears the stock on both sides of such an end.
double turn_radius(const ZigzagOptions& options) {
  const double reach = options.tool_radius_mm - 0.5 * options.stepover_mm;
  const double most = std::min(kWidestTurn * options.stepover_mm, 0.5 * reach);
  constexpr double kMin = 1.0e-4;  // Least radius of a turn, mm.
  return most < kMin ? 0.0 : std::min(options.turn_radius_mm, most);
}

WallDrive wall_drive_of(const ZigzagOptions& options) {
  return {.depth_mm = options.depth_mm, .slope = options.slope, .plunges = options.plunges};
}

/// The areas of TurnSpace, with their storage.
struct TurnAreas {
  Contour rounded;
  Contour centres;
  double radius_mm = 0.0;
};

TurnAreas turn_areas(const Contour& locus, double radius_mm) {
  ContourOffset offsetter;
  TurnAreas areas{{}, copy_of(offsetter.offset(locus.view(), -radius_mm)), radius_mm};
  // Where parts of the area merge, there are corners between them. The last offset fills these
  // corners.
  const Contour wide = copy_of(offsetter.offset(areas.centres.view(), 2.0 * radius_mm));
  areas.rounded = copy_of(offsetter.offset(wide.view(), -radius_mm));
  return areas;
}

Zigzag lines_of(const TurnAreas& areas, const ZigzagOptions& options) {
  Zigzag path;
  if (areas.rounded.loop_ends.empty()) return path;
  const OwnedArea rounded{areas.rounded.view()};
  const OwnedArea centres{areas.centres.view()};
  drive_lines({rounded, centres, areas.radius_mm}, options, path);
  return path;
}

double length_of(const PathRows& rows) {
  double length = 0.0;
  const auto path = rows.path();
  for (std::size_t row = 0; row < path.row_ends.size(); ++row) {
    for (std::uint32_t i = path.row_begin(row); i + 1 < path.row_ends[row]; ++i) {
      const auto& from = path.points[i];
      length += cut::length_of(
          cut::Stroke{.from = from.point(), .to = path.points[i + 1].point(), .bulge = from.bulge});
    }
  }
  return length;
}

/// Drives lines both from the lowest upwards and from the highest downwards. Returns the shorter
/// path, because its entries into the stock are shorter.
Zigzag open_lines_of(const TurnAreas& areas, const ZigzagOptions& options) {
  Zigzag upwards = lines_of(areas, options);
  ZigzagOptions other = options;
  const StockBox& stock = *options.stock;
  other.stock = {stock.x0, -stock.y1, stock.x1, -stock.y0};
  Zigzag downwards =
      lines_of({mirrored(areas.rounded), mirrored(areas.centres), areas.radius_mm}, other);
  if (length_of(upwards) <= length_of(downwards)) return upwards;
  mirror(downwards);
  return downwards;
}

}  // namespace

Zigzag zigzag_path(const cnc::contour::ContourView<double>& area, const ZigzagOptions& options) {
  check(options);
  ContourOffset offsetter;
  const Contour locus = copy_of(offsetter.offset(area, -options.tool_radius_mm));
  if (locus.loop_ends.empty()) {
    throw NoPocketPath{"the tool fits nowhere into the pocket; choose a smaller one with --tool"};
  }
  const TurnAreas areas = turn_areas(locus, turn_radius(options));
  if (options.stock) {
    Zigzag path = open_lines_of(areas, options);
    path.append(
        open_path(area,
                  *options.stock,
                  {locus},
                  {.tool_radius_mm = options.tool_radius_mm, .drive = wall_drive_of(options)}));
    return path;
  }
  Zigzag path = lines_of(areas, options);
  for (std::size_t loop = 0; loop < locus.loop_ends.size(); ++loop) {
    ramp_along_wall(locus.view(), loop, wall_drive_of(options), path);
  }
  return path;
}

}  // namespace sim::pocket
