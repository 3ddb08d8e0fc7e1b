#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "host-sim/import/place.hpp"
#include "planner/contour/plane_curve.hpp"

namespace sim::drawing {

struct Line {
  Place start;
  Place end;
};

/// An arc of a circle. Its end points are stored as the file gives them, not computed from centre
/// and angle.
struct Arc {
  Place start;
  Place end;
  Place centre;
  /// Angle that the arc covers, radians: at most a full turn, positive if the arc turns left.
  double sweep;
};

/// An elliptical arc: centre + cos t · major + sin t · minor, for t from `from` to `to`, in
/// radians. It covers at most a full turn in either direction. The axes `major` and `minor` need
/// not be perpendicular: any affine map of a circle has this form.
struct Ellipse {
  Place centre;
  Place major;
  Place minor;
  double from;
  double to;
};

/// A cubic Bézier curve. A quadratic curve is converted to a cubic one, which has exactly the same
/// points.
struct Bezier {
  std::array<Place, 4> points;
};

/// A rational B-spline (NURBS).
/// @invariant made by `nurbs()`
struct Nurbs {
  std::size_t degree;
  std::vector<Place> points;
  std::vector<double> weights;  ///< Weight of each control point, above 0.
  /// Knots in ascending order; their number is the number of points + degree + 1. Knots may repeat.
  std::vector<double> knots;
  std::vector<std::size_t> spans;  ///< Indices of the knots at which spans begin.
};

using Shape = std::variant<Line, Arc, Ellipse, Bezier, Nurbs>;

/// Returns the name of a shape's kind: `line`, `arc`, `ellipse`, `bezier` or `spline`.
[[nodiscard]] std::string_view name_of(const Shape& shape);

inline constexpr std::size_t kHighestDegree = 11;
inline constexpr std::size_t kMaxControlPoints = 100'000;

/// Returns a spline; nothing if degree, counts, knots or weights do not define a curve. The first
/// and the last `degree` + 1 knots may be equal. Any other knot may occur at most `degree` times.
[[nodiscard]] std::optional<Nurbs> nurbs(std::size_t degree,
                                         std::vector<Place> points,
                                         std::vector<double> weights,
                                         std::vector<double> knots);

/// Returns the arc with the bulge tan(sweep / 4). Returns a line if the bulge is 0, or if the arc
/// would leave its chord by less than a nanometre.
[[nodiscard]] Shape bulge_edge(const Place& start, const Place& end, double bulge);

/// Returns the arc of a circle that begins at the angle `from` and covers the angle `sweep`, both
/// in radians.
/// @pre radius > 0
[[nodiscard]] Arc arc_of(const Place& centre, double radius, double from, double sweep);

[[nodiscard]] Place start_of(const Shape& shape);
[[nodiscard]] Place end_of(const Shape& shape);
[[nodiscard]] bool finite(const Shape& shape);
[[nodiscard]] Shape reversed(Shape shape);

/// Returns the image of a shape under an affine map. An arc becomes an elliptical arc unless the
/// map keeps circles. An ellipse that becomes a circle is returned as an arc.
[[nodiscard]] Shape transformed(const Shape& shape, const Transform& transform);

/// Returns the number of spans, which are the smooth parts of a shape. Each span has its own
/// parameter `share` from 0 to 1.
[[nodiscard]] std::size_t span_count(const Shape& shape);

/// A point of a span, and the first and second derivatives of the span by the parameter `share`.
using Jet = cnc::contour::CurveJet;

/// Returns the point and the derivatives of a span at the parameter `share`.
/// @pre span < span_count(shape), share in 0…1
[[nodiscard]] Jet jet(const Shape& shape, std::size_t span, double share);

}  // namespace sim::drawing
