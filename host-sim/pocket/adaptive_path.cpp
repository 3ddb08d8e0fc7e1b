#include "host-sim/pocket/adaptive_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "host-sim/pocket/area_clearer.hpp"
#include "host-sim/pocket/fitting_approach.hpp"
#include "host-sim/pocket/open_pocket.hpp"
#include "host-sim/pocket/round_return.hpp"
#include "planner/pocket/loop_measures.hpp"
#include "planner/pocket/moving_disc.hpp"

namespace sim::pocket {
namespace {

using cnc::WideVec2;
using cnc::pocket::MovingDisc;
using cnc::pocket::ToolCircle;

/// Slack of the medial axis (AxisOptions::slack_mm), mm. Dropped branches leave stock of at most
/// this thickness to the passes along the walls, also in corners.
constexpr double kAxisMm = 2.0e-4;
/// Greatest deviation of the computed axis from the middle of a cusp, mm. In the cusp of a corner,
/// crescents end at a distance from the tip: this deviation divided by the sine of half the angle.
constexpr double kAsideMm = 2.0e-5;

void check(const AdaptiveOptions& options) {
  const auto require = [](bool is_right, const char* what, double value) {
    if (!is_right) throw std::invalid_argument{fmt::format("{} {:g} is out of range", what, value)};
  };
  const double engagement = options.engagement_deg;
  require(options.tool_radius_mm > 0.0 && std::isfinite(options.tool_radius_mm),
          "radius of the tool in mm",
          options.tool_radius_mm);
  require(engagement >= kMinEngagementDeg && engagement <= kGreatestEngagementDeg,
          "engagement in degrees",
          engagement);
  require(
      options.depth_mm > 0.0 && std::isfinite(options.depth_mm), "depth in mm", options.depth_mm);
  require(options.slope > 0.0 && options.slope <= 1.0, "slope of ramps", options.slope);
  require(options.return_limit_mm >= 0.0, "length of returns in mm", options.return_limit_mm);
}

/// The vertex at which a pass along a wall begins, and the cleared circle from which the tool comes
/// to this vertex.
struct WallStart {
  std::uint32_t vertex = 0;
  ToolCircle circle;
};

/// Returns the vertex of a loop that is nearest to one of the circles, with this circle. The tool
/// must fit on the line between them. Of a long loop, only some vertices are checked.
WallStart wall_start(const cnc::contour::ContourView<double>& locus,
                     std::size_t loop,
                     const std::vector<ToolCircle>& circles,
                     const OwnedArea& area,
                     double tool_radius_mm) {
  constexpr double kRoundingMm = 1.0e-6;
  constexpr std::uint32_t kMaxVertices = 64;
  const std::uint32_t first = locus.loop_begin(loop);
  const std::uint32_t stride = 1 + (locus.loop_ends[loop] - first) / kMaxVertices;
  WallStart best{.vertex = first, .circle = circles.front()};
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = first; i < locus.loop_ends[loop]; i += stride) {
    for (const ToolCircle& circle : circles) {
      const WideVec2 vertex = locus.vertices[i].point();
      const double gap = (vertex - circle.centre).norm() - circle.radius;
      if (gap >= least) continue;
      const MovingDisc tool{circle.centre, vertex, tool_radius_mm, tool_radius_mm};
      if (excess_of(tool, *area) > kRoundingMm) continue;
      least = gap;
      best = {i, circle};
    }
  }
  return best;
}

/// Returns an arc that leads the tool from its line to a vertex of the locus, so that the tool
/// reaches the wall without a corner. Returns none if the vertex is a corner, or if no arc fits.
Approach wall_approach(const cnc::contour::ContourView<double>& locus,
                       std::size_t loop,
                       const WallStart& start,
                       const OwnedArea& area,
                       double tool_radius_mm) {
  constexpr double kCornerSine = 1.0e-3;
  const std::uint32_t first = locus.loop_begin(loop);
  const std::uint32_t last = locus.loop_ends[loop] - 1;
  const std::uint32_t before = start.vertex > first ? start.vertex - 1 : last;
  cnc::contour::Curve<double> coming;
  cnc::contour::Curve<double> going;
  const bool are_curves =
      cnc::pocket::make_curve(cnc::pocket::element_at(locus, loop, before), coming) &&
      cnc::pocket::make_curve(cnc::pocket::element_at(locus, loop, start.vertex), going);
  if (!are_curves) return {};
  const Pose cut{going.start, going.start_tangent};
  if (std::abs(cnc::cross(coming.end_tangent, cut.direction)) > kCornerSine) return {};
  return fitting_approach(start.circle.centre, cut, area, tool_radius_mm);
}

/// Drives around one loop of the locus, coming from a cleared circle.
void pass_wall(const cnc::contour::ContourView<double>& locus,
               std::size_t loop,
               const WallStart& start,
               const Approach& approach,
               DepthWriter& writer) {
  constexpr double kMinLinkMm = 1.0e-6;
  const std::uint32_t first = locus.loop_begin(loop);
  const std::uint32_t count = locus.loop_ends[loop] - first;
  writer.begin_row_in_cleared(start.circle.centre);
  const WideVec2 corner = locus.vertices[start.vertex].point();
  const WideVec2 there = approach.exists ? approach.arc_start : corner;
  const WideVec2 way = there - start.circle.centre;
  const double away = way.norm();
  if (away > start.circle.radius && start.circle.radius > kMinLinkMm) {
    writer.link(start.circle.centre + (start.circle.radius / away) * way);
  }
  writer.pass(there);
  if (approach.exists) writer.pass(corner, approach.bulge());
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::uint32_t from = first + (start.vertex - first + k) % count;
    const std::uint32_t to = first + (start.vertex - first + k + 1) % count;
    writer.pass(locus.vertices[to].point(), locus.vertices[from].bulge);
  }
}

/// Drives around all loops of a locus. Each loop begins at the nearest cleared circle.
void pass_walls(const cnc::contour::ContourView<double>& locus,
                const OwnedArea& area,
                const AdaptiveOptions& options,
                CrescentDriver& driver) {
  const double radius = options.tool_radius_mm;
  for (std::size_t loop = 0; loop < locus.loop_ends.size(); ++loop) {
    const WallStart start = wall_start(locus, loop, driver.circles(), area, radius);
    const Approach approach = wall_approach(locus, loop, start, area, radius);
    pass_wall(locus, loop, start, approach, driver.writer());
  }
  driver.writer().end_row();
}

PartOptions part_options_of(const AdaptiveOptions& options) {
  return {.tool_radius_mm = options.tool_radius_mm,
          .drive = {.depth_mm = options.depth_mm,
                    .slope = options.slope,
                    .plunges = options.entry == cnc::pocket::EntryKind::kPlunge}};
}

}  // namespace

double thin_chip_factor(double engagement_deg) {
  constexpr double kHalf = 90.0;
  if (engagement_deg >= kHalf) return 1.0;
  return 1.0 / std::sin(engagement_deg * std::numbers::pi / 180.0);
}

AdaptivePath adaptive_path(const cnc::contour::ContourView<double>& area,
                           const AdaptiveOptions& options) {
  check(options);
  const OwnedArea owned{area};
  const MedialAxis axis = medial_axis(owned, {.tolerance_mm = kAsideMm, .slack_mm = kAxisMm});
  CarveGraph graph = wide_part(axis, owned, options.tool_radius_mm);
  split_at_widest(graph);
  AdaptivePath path;
  CrescentDriver driver{owned, options, path};
  AreaClearer{owned, graph, options, driver}.clear();
  if (driver.circles().empty()) {
    throw std::invalid_argument{
        fmt::format("a tool of {:g} mm fits nowhere into the pocket; choose a smaller tool",
                    2.0 * options.tool_radius_mm)};
  }
  ContourOffset offset;
  const Contour locus = copy_of(offset.offset(area, -options.tool_radius_mm));
  if (options.stock) {
    const LoopsInStock loops = loops_in_stock(locus, *options.stock, options.tool_radius_mm);
    pass_walls(loops.whole.view(), owned, options, driver);
    if (!loops.partly.loop_ends.empty()) {
      path.append(open_path(area, *options.stock, {loops.partly}, part_options_of(options)));
    }
  } else {
    pass_walls(locus.view(), owned, options, driver);
  }
  return path;
}

}  // namespace sim::pocket
