#include "tests/support/carve_judge.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace proof {
namespace {

/// A cut, with its radii at the top surface: along a line from radius r0 to r1, or along an arc
/// with one radius.
struct Cut {
  double x0, y0, r0;
  double x1, y1, r1;
  ExactContour::Element arc{};  ///< The arc; a radius of 0 means that the cut is a line.

  [[nodiscard]] double length() const { return std::hypot(x1 - x0, y1 - y0); }
};

ExactContour::Element arc_between(const cnc::pocket::PathPoint<double>& from,
                                  const cnc::pocket::PathPoint<double>& to) {
  const std::vector<sim::ContourVertex> ends{{from.x, from.y, from.bulge}, {to.x, to.y, 0.0}};
  const std::vector<std::uint32_t> loop_ends{2};
  return ExactContour{{{ends.data(), 2}, {loop_ends.data(), 1}}}.elements().front();
}

std::vector<Cut> cuts_of(const sim::pocket::VCarving& carving, double slope) {
  std::vector<Cut> cuts;
  const auto path = carving.path();
  for (std::size_t row = 0; row < path.row_ends.size(); ++row) {
    for (std::uint32_t i = path.row_begin(row); i + 1 < path.row_ends[row]; ++i) {
      const auto& from = path.points[i];
      const auto& to = path.points[i + 1];
      cuts.push_back({from.x, from.y, -from.z * slope, to.x, to.y, -to.z * slope});
      if (from.bulge != 0.0) cuts.back().arc = arc_between(from, to);
    }
  }
  return cuts;
}

double clearance_at(const Cut& cut, double share, double x, double y) {
  const double dx = cut.x0 + share * (cut.x1 - cut.x0) - x;
  const double dy = cut.y0 + share * (cut.y1 - cut.y0) - y;
  return std::hypot(dx, dy) - (cut.r0 + share * (cut.r1 - cut.r0));
}

/// Returns the distance of a point from the edge of a cut, negative inside of the cut. Along a
/// line, the distance is convex in the position of the tool, which permits a ternary search.
double clearance(const Cut& cut, double x, double y) {
  if (cut.arc.radius > 0.0) return cut.arc.distance(x, y) - cut.r0;
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double a = low + (high - low) / 3.0;
    const double b = high - (high - low) / 3.0;
    (clearance_at(cut, a, x, y) < clearance_at(cut, b, x, y) ? high : low) =
        clearance_at(cut, a, x, y) < clearance_at(cut, b, x, y) ? b : a;
  }
  return std::min({clearance_at(cut, 0.5 * (low + high), x, y),
                   clearance_at(cut, 0.0, x, y),
                   clearance_at(cut, 1.0, x, y)});
}

/// Finds the distance to the nearest of all cuts. It tries the previous nearest cut first, since
/// successive points are close together.
class NearestCut {
 public:
  explicit NearestCut(const std::vector<Cut>& cuts) : cuts_{cuts} {}

  double clearance_at_place(double x, double y) {
    double least = cuts_.empty() ? INFINITY : clearance(cuts_[nearest_], x, y);
    for (std::size_t i = 0; i < cuts_.size(); ++i) {
      const Cut& cut = cuts_[i];
      // No part of the cut is farther than this from the middle of its chord.
      const double reach = cut.arc.length() + cut.length() + std::abs(cut.r1 - cut.r0);
      if (clearance_at(cut, 0.5, x, y) - reach > least) continue;
      const double here = clearance(cut, x, y);
      if (here >= least) continue;
      least = here;
      nearest_ = i;
    }
    return least;
  }

 private:
  const std::vector<Cut>& cuts_;
  std::size_t nearest_ = 0;
};

/// Judges the depth at the tip at sampled points of each cut.
void judge_depths(const ExactContour& exact,
                  const std::vector<Cut>& cuts,
                  const sim::pocket::VCarveOptions& options,
                  double slope,
                  CarveVerdict& verdict) {
  const double widest = slope * options.greatest_depth_mm;
  for (const Cut& cut : cuts) {
    const double length = cut.length();
    verdict.lowest_mm = std::min({verdict.lowest_mm, -cut.r0 / slope, -cut.r1 / slope});
    if (length == 0.0) continue;  // The tool only moves up or down.
    const int places = std::clamp(static_cast<int>(length / 0.05), 4, 64);
    for (int i = 0; i <= places; ++i) {
      const double share = static_cast<double>(i) / places;
      double x = cut.x0 + share * (cut.x1 - cut.x0);
      double y = cut.y0 + share * (cut.y1 - cut.y0);
      double right_x = 0, right_y = 0;
      if (cut.arc.radius > 0.0) cut.arc.at(share, x, y, right_x, right_y);
      const double radius = cut.r0 + share * (cut.r1 - cut.r0);
      const double distance = exact.distance(x, y);
      const double depth = distance > 1.0e-9 && exact.winding(x, y) != 1 ? -distance : distance;
      verdict.gouge_mm = std::max(verdict.gouge_mm, radius - depth);
      const double missing = (std::min(depth, widest) - radius) / slope;
      verdict.too_shallow_mm = std::max(verdict.too_shallow_mm, missing);
    }
  }
}

}  // namespace

CarveVerdict judge_carving(const cnc::contour::ContourView<double>& area,
                           const sim::pocket::VCarving& carving,
                           const sim::pocket::VCarveOptions& options) {
  const ExactContour exact{area};
  const double slope = std::tan(options.included_angle_deg * std::numbers::pi / 360.0);
  const std::vector<Cut> cuts = cuts_of(carving, slope);
  CarveVerdict verdict;
  judge_depths(exact, cuts, options, slope, verdict);
  NearestCut nearest{cuts};
  constexpr int kPlaces = 16;
  for (const ExactContour::Element& element : exact.elements()) {
    for (int i = 0; i <= kPlaces; ++i) {
      double x = 0, y = 0, right_x = 0, right_y = 0;
      element.at(static_cast<double>(i) / kPlaces, x, y, right_x, right_y);
      const double edge = nearest.clearance_at_place(x, y);
      verdict.gouge_mm = std::max(verdict.gouge_mm, -edge);
      verdict.unreached_mm = std::max(verdict.unreached_mm, edge);
    }
  }
  return verdict;
}

}  // namespace proof
