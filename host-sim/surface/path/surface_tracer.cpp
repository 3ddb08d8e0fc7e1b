#include "host-sim/surface/path/surface_tracer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "host-sim/surface/path/chord_fit.hpp"

namespace sim::surface {
namespace {

/// Returns the permitted error of the sampled heights and of the curve through them, relative to
/// the band. It limits two distances: the distance by which the surface may reach into the tool
/// between samples, and the curve's deviation from the samples. A cone gets a larger error, because
/// the distance between its samples is about the error.
double error_share_of(const cnc::surface::Profile& profile) {
  return profile.rise > 0.0 ? 0.15 : 0.05;
}

/// Greatest displacement of an arc, in last digits of the program, because its end and its centre
/// are rounded.
constexpr double kRoundingDigits = 1.0;

double lowest_of(const Mesh& mesh) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& point : mesh.points) lowest = std::min(lowest, point.z());
  return lowest;
}

double band_within(const cnc::surface::GrownTool& tool, const RowOptions& options) {
  const double rounding = kRoundingDigits * options.digit_mm;
  const double share = 1.0 - 2.0 * error_share_of(tool.profile);
  const double band = share * tool.band_mm - rounding;
  if (band > 0.25 * tool.band_mm) return band;
  throw std::invalid_argument{
      fmt::format("a tolerance of {:g} mm is too small for steps of {:g} mm in the program; "
                  "increase --decimals or --tolerance",
                  options.tolerance_mm,
                  options.digit_mm)};
}

/// Returns whether a slice is along X or Y, so that its arcs are in a plane of G18 or G19.
bool lies_along_axis(const Slice& slice) {
  return slice.direction.x() == 0.0 || slice.direction.y() == 0.0;
}

}  // namespace

cnc::surface::GrownTool traced_tool(const RowOptions& options) {
  cnc::surface::Profile tool = options.tool;
  double lift_mm = 0.0;
  if (options.allowance_mm > 0.0) {
    const cnc::surface::GrownTool larger = cnc::surface::grown(tool, options.allowance_mm);
    // A cone that is grown by the allowance leaves less stock than the allowance. So it is grown by
    // more.
    const double share = options.allowance_mm / larger.band_mm;
    const cnc::surface::GrownTool whole = cnc::surface::grown(tool, share * options.allowance_mm);
    tool = whole.profile;
    lift_mm = whole.lift_mm;
  }
  cnc::surface::GrownTool grown = cnc::surface::grown(tool, options.tolerance_mm);
  grown.lift_mm += lift_mm;
  return grown;
}

SurfaceTracer::SurfaceTracer(const Mesh& mesh, const RowOptions& options)
    : tool_{traced_tool(options)},
      lift_mm_{tool_.lift_mm},
      heights_{mesh, tool_.profile, options.smooth},
      has_floor_{options.floor_mm.has_value()},
      lowest_mm_{options.floor_mm.value_or(lowest_of(mesh))},
      layer_bottom_mm_{lowest_mm_},
      density_{density_for(tool_.profile, error_share_of(tool_.profile) * tool_.band_mm)},
      band_mm_{band_within(tool_, options)},
      lines_only_{options.lines_only} {}

void SurfaceTracer::set_layer(double top_mm, double bottom_mm) {
  layer_top_mm_ = top_mm;
  layer_bottom_mm_ = std::max(lowest_mm_, bottom_mm);
}

bool SurfaceTracer::is_over(const Eigen::Vector2d& place, PathHeights::Hint& hint) const {
  if (!layer_top_mm_) return has_floor_ || heights_.has_contact(place, hint);
  const double touched = heights_(place, hint);
  if (!has_floor_ && touched == cnc::surface::kNoContact) return false;
  return std::max(lowest_mm_, touched) + lift_mm_ < *layer_top_mm_;
}

double SurfaceTracer::height(const Eigen::Vector2d& place) const {
  return lift_mm_ + std::max(lowest_mm_, heights_(place));
}

double SurfaceTracer::touched(const Eigen::Vector2d& place, PathHeights::Hint& hint) const {
  const double height = heights_(place, hint);
  if (!has_floor_ && height == cnc::surface::kNoContact) return height;
  return std::max(lowest_mm_, height);
}

/// Returns the last point of a slice with contact, between `over`, which has contact, and `beside`,
/// which has none.
double SurfaceTracer::border(const Slice& slice, double over, double beside) const {
  constexpr double kNear = 1.0e-6;
  PathHeights::Hint hint;
  while (std::abs(beside - over) > kNear) {
    const double middle = 0.5 * (over + beside);
    (is_over(slice.at(middle), hint) ? over : beside) = middle;
  }
  return over;
}

std::vector<std::pair<double, double>> SurfaceTracer::parts_over(const Slice& slice) const {
  if (has_floor_ && !layer_top_mm_) return {{0.0, slice.length}};
  constexpr double kMinPart = 1.0e-3;
  constexpr double kLooksPerRadius = 32.0;
  const auto looks =
      static_cast<int>(std::ceil(slice.length / tool_.profile.radius_mm * kLooksPerRadius)) + 1;
  std::vector<std::pair<double, double>> parts;
  double before = 0.0;
  bool was_over = false;
  double begin = 0.0;
  PathHeights::Hint hint;
  const auto end_at = [&](double end) {
    if (end - begin >= kMinPart) parts.emplace_back(begin, end);
  };
  for (int i = 0; i <= looks; ++i) {
    const double along = slice.length * i / looks;
    const bool over = is_over(slice.at(along), hint);
    if (over && !was_over) begin = i == 0 ? along : border(slice, along, before);
    if (!over && was_over) end_at(border(slice, before, along));
    was_over = over;
    before = along;
  }
  if (was_over) end_at(slice.length);
  return parts;
}

SurfaceStretch SurfaceTracer::trace(
    const Slice& slice, double begin, double end, StretchUse use, TraceRoom& room) const {
  SurfaceStretch stretch{.plane = slice, .use = use, .vertices = {}};
  SliceHeights heights{heights_, slice, layer_bottom_mm_};
  const SliceCurve curve{heights, begin, end, density_};
  room.lines.clear();
  fit_chords(curve, curve.all(), band_mm_, room.lines);
  if (!lines_only_ && lies_along_axis(slice)) {
    room.without_arcs += room.fitter.fit(curve, band_mm_, SliceElements::kArcs, stretch.vertices);
  }
  if (stretch.vertices.empty() || room.lines.size() < stretch.vertices.size()) {
    stretch.vertices = room.lines;
  }
  for (ContourVertex& vertex : stretch.vertices) vertex.y += lift_mm_;
  return stretch;
}

}  // namespace sim::surface
