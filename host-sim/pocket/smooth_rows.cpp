#include "host-sim/pocket/smooth_rows.hpp"

#include <algorithm>
#include <cmath>

namespace sim::pocket {
namespace {

/// Greatest angle of a smooth joint, radians. A corner of this angle leaves 1e-4 mm next to a disc
/// with a radius of 1 m.
constexpr double kSmoothCorner = 1.0e-3;
/// Greatest difference between the curvatures of two arcs of one circle, as a share of the
/// curvature. The difference comes from rounding.
constexpr double kSameCurvature = 1.0e-6;

bool joins_smoothly(const cnc::contour::Curve<double>& from,
                    const cnc::contour::Curve<double>& to) {
  return std::abs(cnc::cross(from.end_tangent, to.start_tangent)) <= kSmoothCorner &&
         from.end_tangent.dot(to.start_tangent) > 0.0;
}

/// Returns whether a row continues from one element to the next.
/// @param sign 1 for rows of growing curvature, −1 for rows of falling curvature
bool goes_on(const cnc::contour::Curve<double>& from,
             const cnc::contour::Curve<double>& to,
             double sign) {
  const double slack = kSameCurvature * std::max(std::abs(from.curvature), std::abs(to.curvature));
  return joins_smoothly(from, to) && sign * (to.curvature - from.curvature) >= -slack;
}

}  // namespace

SmoothRows::SmoothRows(const cnc::pocket::AreaDistance& area)
    : growing_{numbered(area, 1.0)}, falling_{numbered(area, -1.0)} {
  for (std::uint32_t i = 0; i < area.element_count(); ++i) {
    is_smooth_.push_back(joins_smoothly(area.element(area.previous(i)), area.element(i)));
  }
}

bool SmoothRows::may_share_disc(const BoundarySite& a, const BoundarySite& b) const {
  if (a.is_corner() && b.is_corner()) return true;
  if (a.is_corner()) return !a.has(b.element);
  if (b.is_corner()) return !b.has(a.element);
  return growing_[a.element] != growing_[b.element] && falling_[a.element] != falling_[b.element];
}

std::vector<std::uint32_t> SmoothRows::numbered(const cnc::pocket::AreaDistance& area,
                                                double sign) {
  std::vector<std::uint32_t> rows(area.element_count());
  std::uint32_t row = 0;
  for (std::uint32_t first = 0; first < rows.size();) {
    // Goes around the loop. It begins at the start of a row, or at the first element if the loop
    // has no start of a row.
    std::uint32_t begin = first;
    std::uint32_t end = first;
    do {
      if (!goes_on(area.element(area.previous(end)), area.element(end), sign)) begin = end;
      end = area.next(end);
    } while (end != first);
    std::uint32_t i = begin;
    do {
      if (i == begin || !goes_on(area.element(area.previous(i)), area.element(i), sign)) ++row;
      rows[i] = row;
      first = std::max(first, i + 1);
      i = area.next(i);
    } while (i != begin);
  }
  return rows;
}

}  // namespace sim::pocket
