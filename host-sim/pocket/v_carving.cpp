#include "host-sim/pocket/v_carving.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string_view>

#include "host-sim/pocket/carve_walk.hpp"
#include "planner/pocket/loop_measures.hpp"

namespace sim::pocket {
namespace {

using cnc::pocket::Use;
using PathPoint = cnc::pocket::PathPoint<double>;

/// Tolerance of the axis's points, as a share of the tolerance of carving.
constexpr double kAxisShare = 0.2;

void check_range(std::string_view name, double value, double least, double greatest) {
  if (value >= least && value <= greatest) return;
  throw std::invalid_argument{
      fmt::format("{} {:g} is not within {:g} to {:g}", name, value, least, greatest)};
}

void check(const VCarveOptions& options) {
  check_range("angle of the V tool", options.included_angle_deg, kMinVAngleDeg, kGreatestVAngleDeg);
  if (!(options.greatest_depth_mm > 0.0)) {
    throw std::invalid_argument{
        fmt::format("greatest depth {:g} mm is not above 0", options.greatest_depth_mm)};
  }
  check_range("tolerance of carving", options.tolerance_mm, 1.0e-4, 1.0);
  if (!(options.return_limit_mm >= 0.0)) {
    throw std::invalid_argument{
        fmt::format("length of returns {:g} mm is below 0", options.return_limit_mm)};
  }
}

/// Returns the area inside of contours, mm².
double area_of(const cnc::contour::ContourView<double>& contour) {
  double sum = 0.0;
  for (std::size_t loop = 0; loop < contour.loop_ends.size(); ++loop) {
    sum += cnc::pocket::signed_area(contour, loop);
  }
  return sum;
}

/// Writes the rows of a carving.
class CarveWriter {
 public:
  CarveWriter(VCarving& out, double half_angle_tangent) : out_{out}, slope_{half_angle_tangent} {}

  void begin_row(const AxisPoint& point) {
    out_.end_row();
    const double z = -point.radius / slope_;
    if (z < 0.0) out_.points.push_back({point.place.x(), point.place.y(), 0.0, 0.0, Use::kEntry});
  }

  void add(const AxisPoint& point, Use use, double bulge = 0.0) {
    const double z = -point.radius / slope_;
    out_.points.push_back({point.place.x(), point.place.y(), z, bulge, use});
    out_.depth_mm = std::max(out_.depth_mm, -z);
  }

 private:
  VCarving& out_;
  double slope_;
};

void write_pieces(const CarveGraph& graph, double return_limit_mm, CarveWriter& writer) {
  const std::vector<WalkStep> steps = walk_along(graph, return_limit_mm);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const WalkStep& step = steps[i];
    std::vector<AxisPoint> points = graph.pieces[step.piece].points;
    if (step.is_reversed) std::ranges::reverse(points);
    if (step.begins_row) writer.begin_row(points.front());
    const Use use = step.is_return ? Use::kLink : Use::kPass;
    for (std::size_t k = 0; k + 1 < points.size(); ++k) writer.add(points[k], use);
    // The end of a piece is the beginning of the next piece, except at the end of a row.
    if (i + 1 == steps.size() || steps[i + 1].begins_row) writer.add(points.back(), use);
  }
}

/// Writes a row with a plunge at each node without chains.
void write_lone_nodes(const MedialAxis& axis, double greatest_radius_mm, CarveWriter& writer) {
  std::vector<bool> has_chain(axis.nodes.size());
  for (const AxisChain& chain : axis.chains) has_chain[chain.from] = has_chain[chain.to] = true;
  for (std::size_t i = 0; i < axis.nodes.size(); ++i) {
    const AxisPoint& node = axis.nodes[i];
    if (has_chain[i] || node.radius <= 0.0 || node.radius > greatest_radius_mm) continue;
    writer.begin_row(node);
    writer.add(node, Use::kPass);
  }
}

double widest_of(const MedialAxis& axis) {
  double widest_mm = 0.0;
  for (const AxisPoint& node : axis.nodes) widest_mm = std::max(widest_mm, node.radius);
  for (const AxisChain& chain : axis.chains) {
    for (const AxisPoint& point : chain.points) widest_mm = std::max(widest_mm, point.radius);
  }
  return widest_mm;
}

void write_wide_loops(const Contour& wide, double radius_mm, CarveWriter& writer) {
  for (std::size_t loop = 0; loop < wide.loop_ends.size(); ++loop) {
    const std::uint32_t first = wide.view().loop_begin(loop);
    writer.begin_row({wide.vertices[first].point(), radius_mm});
    for (std::uint32_t i = first; i < wide.loop_ends[loop]; ++i) {
      writer.add({wide.vertices[i].point(), radius_mm}, Use::kPass, wide.vertices[i].bulge);
    }
    writer.add({wide.vertices[first].point(), radius_mm}, Use::kPass);
  }
}

}  // namespace

VCarving v_carve(const cnc::contour::ContourView<double>& area, const VCarveOptions& options) {
  check(options);
  const OwnedArea owned{area};
  const double slope = std::tan(0.5 * options.included_angle_deg * std::numbers::pi / 180.0);
  // For a narrow tip, a small error of the radius causes a large error of the depth.
  const double tolerance_mm = options.tolerance_mm * std::min(1.0, slope);
  const double axis_mm = kAxisShare * tolerance_mm;
  const MedialAxis axis = medial_axis(owned, {.tolerance_mm = axis_mm, .slack_mm = axis_mm});
  const double greatest_radius_mm = slope * options.greatest_depth_mm;
  CarveGraph graph = narrow_part(axis, owned, greatest_radius_mm);
  fit_lines(graph, owned, tolerance_mm);

  VCarving carving;
  CarveWriter writer{carving, slope};
  write_pieces(graph, options.return_limit_mm, writer);
  write_lone_nodes(axis, greatest_radius_mm, writer);
  if (widest_of(axis) > greatest_radius_mm) {
    ContourOffset offset;
    carving.wide = copy_of(offset.offset(area, -greatest_radius_mm));
    carving.wide_area_mm2 = area_of(carving.wide.view());
    write_wide_loops(carving.wide, greatest_radius_mm, writer);
  }
  carving.end_row();
  return carving;
}

}  // namespace sim::pocket
