#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/import/drawing.hpp"
#include "planner/contour/arc_spline_fit.hpp"

namespace sim {

class KnownRows;

struct OutlineOptions {
  double tolerance_mm = 0.01;  ///< Between a drawn curve and its arcs, both ways.
  cnc::contour::FitMethod method = cnc::contour::FitMethod::kFewest;
};

/// `fewest` or `paper`.
[[nodiscard]] std::string_view name_of(cnc::contour::FitMethod method);

/// Neither a line nor an arc of a circle.
[[nodiscard]] bool is_free_form(const drawing::Shape& shape);

inline constexpr double kLeastToleranceMm = 1.0e-5;
inline constexpr double kGreatestToleranceMm = 10.0;

/// A contour of a drawing as lines and arcs, or why it is none.
struct FittedContour {
  std::vector<ContourVertex> vertices;  ///< Of an open contour the last one is its end.
  std::optional<drawing::Fault> fault;  ///< No vertices then.
};

/// Lines and arcs stay what they are, to the bit, an arc of more than half a turn in two. Curves
/// between them become arcs within the tolerance. Corners stay where they are; where the
/// drawing goes on smoothly, so do the arcs: within a row of curves with one tangent, beside
/// lines and arcs with the curve's own. What changes direction by less than kDrawnSmooth is smooth.
/// A closed contour may begin at another of its places.
/// @pre the tolerance within its limits
[[nodiscard]] FittedContour arcs_of(const drawing::DrawnContour& contour,
                                    const OutlineOptions& options);
/// Returns the same arcs, to the bit, but fits a row of curves that it knows only once.
/// @param known rows of the contours before, for one thread; the row of this one is added
[[nodiscard]] FittedContour arcs_of(const drawing::DrawnContour& contour,
                                    const OutlineOptions& options,
                                    KnownRows& known);
/// Radians: control points with three decimals make such corners where none is meant.
inline constexpr double kDrawnSmooth = 0.01;

/// All closed contours of a drawing, as lines and arcs.
struct Outline {
  /// A loop for each, in the drawing's order; material is on the left.
  Contour contour;
  /// Of each loop: its index in Drawing::contours, where its layer, parent and depth are.
  std::vector<std::size_t> drawn;
  /// What could not be fitted and is left out: entity, place and reason.
  std::vector<drawing::Fault> faults;
};

/// Open contours are no part of it: they are among the drawing's own faults.
[[nodiscard]] Outline outline_of(const drawing::Drawing& drawing,
                                 const OutlineOptions& options = {});

}  // namespace sim
