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
  /// Greatest distance between a drawn curve and its arcs, in both directions.
  double tolerance_mm = 0.01;
  cnc::contour::FitMethod method = cnc::contour::FitMethod::kFewest;
};

/// Returns `fewest` or `paper`.
[[nodiscard]] std::string_view name_of(cnc::contour::FitMethod method);

/// Returns whether a shape is neither a line nor an arc of a circle.
[[nodiscard]] bool is_free_form(const drawing::Shape& shape);

inline constexpr double kMinToleranceMm = 1.0e-5;
inline constexpr double kGreatestToleranceMm = 10.0;

/// A contour of a drawing as lines and arcs, or the reason why that is not possible.
struct FittedContour {
  /// Vertices; the last vertex of an open contour is its end.
  std::vector<ContourVertex> vertices;
  std::optional<drawing::Fault> fault;  ///< If there is a fault, there are no vertices.
};

/// Returns a drawn contour as lines and arcs. Lines and arcs stay the same to the bit, except that
/// an arc of more than half a turn becomes two arcs. Other curves become arcs within the tolerance.
/// Corners keep their points. Where the drawing is smooth, the arcs are smooth, too: within a row
/// of curves they have one tangent, and next to lines and arcs they have the curve's own tangent. A
/// change of direction below kDrawnSmooth counts as smooth. A closed contour may begin at another
/// of its points.
/// @pre the tolerance is within its limits
[[nodiscard]] FittedContour arcs_of(const drawing::DrawnContour& contour,
                                    const OutlineOptions& options);
/// Returns the same arcs as arcs_of() without `known`, to the bit. A row of curves that is repeated
/// is fitted only once.
/// @param known rows of earlier contours, for one thread; the rows of this contour are added
[[nodiscard]] FittedContour arcs_of(const drawing::DrawnContour& contour,
                                    const OutlineOptions& options,
                                    KnownRows& known);
/// Greatest change of direction that counts as smooth, radians. Control points with three decimals
/// make such corners where the author meant none.
inline constexpr double kDrawnSmooth = 0.01;

/// All closed contours of a drawing, as lines and arcs.
struct Outline {
  /// One loop for each closed contour, in the drawing's order; material is on the left.
  Contour contour;
  /// Index of each loop in Drawing::contours, which has its layer, parent and depth.
  std::vector<std::size_t> drawn;
  /// Contours that could not be fitted and are left out: entity, point and reason.
  std::vector<drawing::Fault> faults;
};

/// Returns the closed contours of a drawing as lines and arcs. Open contours are not included; the
/// drawing's own faults list them.
[[nodiscard]] Outline outline_of(const drawing::Drawing& drawing,
                                 const OutlineOptions& options = {});

}  // namespace sim
