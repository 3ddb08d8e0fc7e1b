#pragma once

#include <string>

#include "tests/support/contour_corpus.hpp"

namespace proof {

/// Closed contours by centres, radii and angles. The class shares nothing with the planner, which
/// uses tangents and curvatures.
class ExactContour {
 public:
  struct Element {
    double x0, y0, x1, y1;
    double centre_x, centre_y, radius;  ///< A line has radius 0.
    double start_angle, sweep;

    [[nodiscard]] double distance(double x, double y) const;
    /// Computes the point at a share of the length, and the unit normal to the right at that point.
    void at(double share, double& x, double& y, double& right_x, double& right_y) const;
    [[nodiscard]] double length() const;
    [[nodiscard]] double distance_to_flat_arc(double x, double y) const;
  };

  explicit ExactContour(const cnc::contour::ContourView<double>& contour);

  [[nodiscard]] const std::vector<Element>& elements() const { return elements_; }
  [[nodiscard]] double distance(double x, double y) const;
  /// Returns the winding number of all loops, or of one loop, around a point: turns
  /// counter-clockwise.
  [[nodiscard]] int winding(double x, double y) const;
  [[nodiscard]] int winding_of_loop(std::size_t loop, double x, double y) const;
  [[nodiscard]] std::size_t loop_of(std::size_t element) const { return loops_[element]; }
  [[nodiscard]] double area() const;
  [[nodiscard]] double length() const;

 private:
  std::vector<Element> elements_;
  std::vector<std::size_t> loops_;
  std::vector<std::size_t> loop_ends_;
};

/// Result of the check of one offset.
struct OffsetVerdict {
  std::string complaint;  ///< The first fault; empty if there is none.
  /// Greatest difference between the wanted distance and that of a point of the result, mm.
  double worst_deviation = 0.0;
};

/// Returns whether two elements have a point in common that is not an end of both. Computed for
/// each pair, so that no crossing is too short to be found. Elements on one line or circle do not
/// count. Arcs with radii above 100 m may seem to cross where they join at a small angle.
/// @pre no arc is of more than half a turn
[[nodiscard]] bool elements_cross(const ExactContour& contour);

/// Returns whether loops cross neither themselves nor each other, and have material on their left
/// and none on their right. @pre no arc is of more than half a turn
[[nodiscard]] bool is_simple(const cnc::contour::ContourView<double>& contour);

/// Checks an offset: distances and winding numbers are computed independently, and the area is
/// compared with that of Clipper's offset of the flattened input.
[[nodiscard]] OffsetVerdict check_offset(const OffsetCase& wanted,
                                         const cnc::contour::ContourView<double>& result,
                                         std::uint64_t seed);

/// Returns the area of Clipper's offset of the same contour, whose arcs are chords within
/// `tolerance_mm`.
[[nodiscard]] double clipper_area(const ExactContour& contour,
                                  double distance_mm,
                                  double tolerance_mm);

}  // namespace proof
