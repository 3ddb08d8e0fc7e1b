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
  /// Greatest distance of any point of a drawn curve from its arcs, and of any point of the arcs
  /// from the curve.
  double tolerance_mm = 0.01;
  cnc::contour::FitMethod method = cnc::contour::FitMethod::kFewest;
};

/// Returns `fewest` or `paper`.
[[nodiscard]] std::string_view name_of(cnc::contour::FitMethod method);

/// Returns whether a shape is neither a line nor an arc of a circle.
[[nodiscard]] bool is_free_form(const drawing::Shape& shape);

inline constexpr double kMinToleranceMm = 1.0e-5;
inline constexpr double kGreatestToleranceMm = 10.0;

/// A contour of a drawing as lines and arcs, or the reason why there are none.
struct FittedContour {
  /// Vertices at which lines and arcs begin. The last vertex of an open contour is its end.
  std::vector<ContourVertex> vertices;
  /// Reason why the contour could not be fitted. If there is a fault, there are no vertices.
  std::optional<drawing::Fault> fault;
};

/// Returns a drawn contour as lines and arcs. Drawn lines and arcs stay exactly the same, except
/// that an arc of more than half a turn becomes two arcs. Other curves become arcs within the
/// tolerance. Corners keep their points. Where the drawing is smooth, the result is smooth, too:
/// arcs within a row of curves have a common tangent where they meet, and next to a drawn line or
/// arc they have the tangent of the drawn curve. A change of direction below kDrawnSmooth counts as
/// smooth. The result of a closed contour may begin at another point of it.
/// @pre the tolerance is within its limits
[[nodiscard]] FittedContour arcs_of(const drawing::DrawnContour& contour,
                                    const OutlineOptions& options);
/// Returns exactly the same arcs as arcs_of() without `known`, but fits each row of curves only
/// once, even if it is repeated.
/// @param known rows of earlier contours, to which the rows of this contour are added; must be used
/// by one thread only
[[nodiscard]] FittedContour arcs_of(const drawing::DrawnContour& contour,
                                    const OutlineOptions& options,
                                    KnownRows& known);
/// Greatest change of direction that counts as smooth, radians. Control points that are rounded to
/// three decimals cause changes of direction up to this size where the author of the drawing meant
/// none.
inline constexpr double kDrawnSmooth = 0.01;

/// The closed contours of a drawing as lines and arcs.
struct Outline {
  /// One loop for each closed contour, in the order of the drawing. The material is on the left of
  /// each loop.
  Contour contour;
  /// For each loop, the index of its contour in Drawing::contours, which contains its layer, parent
  /// and depth.
  std::vector<std::size_t> drawn;
  /// Faults about contours that could not be fitted and are left out: entity, point and reason.
  std::vector<drawing::Fault> faults;
};

/// Returns the closed contours of a drawing as lines and arcs. Leaves out open contours, which
/// Drawing::faults lists.
[[nodiscard]] Outline outline_of(const drawing::Drawing& drawing,
                                 const OutlineOptions& options = {});

}  // namespace sim
