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

/// An arc of a circle; its end points are those of the file, not computed anew.
struct Arc {
  Place start;
  Place end;
  Place centre;
  double sweep;  ///< Radians, at most a full turn; positive turns left.
};

/// centre + cos t · major + sin t · minor, t from `from` to `to` in radians, at
/// most a full turn either way. The two need not be perpendicular: any affine
/// map of a circle has this form.
struct Ellipse {
  Place centre;
  Place major;
  Place minor;
  double from;
  double to;
};

/// A cubic Bézier curve; a quadratic one is raised to it, which changes no place.
struct Bezier {
  std::array<Place, 4> points;
};

/// A rational B-spline. @invariant made by `nurbs()`.
struct Nurbs {
  std::size_t degree;
  std::vector<Place> points;
  std::vector<double> weights;     ///< One for each point, above 0.
  std::vector<double> knots;       ///< points + degree + 1, not falling.
  std::vector<std::size_t> spans;  ///< The knots at which spans begin.
};

using Shape = std::variant<Line, Arc, Ellipse, Bezier, Nurbs>;

/// `line`, `arc`, `ellipse`, `bezier`, `spline`.
[[nodiscard]] std::string_view name_of(const Shape& shape);

inline constexpr std::size_t kHighestDegree = 11;
inline constexpr std::size_t kMostControlPoints = 100'000;

/// Nothing where degree, counts, knots or weights make no curve. Knots beyond
/// the first and last `degree` + 1 may be repeated `degree` times at most.
[[nodiscard]] std::optional<Nurbs> nurbs(std::size_t degree,
                                         std::vector<Place> points,
                                         std::vector<double> weights,
                                         std::vector<double> knots);

/// The arc whose bulge is tan(sweep / 4); a line where it is 0, or where the arc
/// would leave the chord by less than a nanometre.
[[nodiscard]] Shape bulge_edge(const Place& start, const Place& end, double bulge);

/// @pre radius > 0
[[nodiscard]] Arc arc_of(const Place& centre, double radius, double from, double sweep);

[[nodiscard]] Place start_of(const Shape& shape);
[[nodiscard]] Place end_of(const Shape& shape);
[[nodiscard]] bool finite(const Shape& shape);
[[nodiscard]] Shape reversed(Shape shape);

/// Arcs stay arcs where circles stay circles, and an ellipse that became a
/// circle is an arc.
[[nodiscard]] Shape transformed(const Shape& shape, const Transform& transform);

/// Smooth parts of a shape, each with a share of 0…1 of its own.
[[nodiscard]] std::size_t span_count(const Shape& shape);

/// Place and derivatives by the share.
using Jet = cnc::contour::CurveJet;

/// @pre span < span_count(shape), share in 0…1
[[nodiscard]] Jet jet(const Shape& shape, std::size_t span, double share);

}  // namespace sim::drawing
