#include "host-sim/import/dxf_splines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace sim::drawing {
namespace {

/// A tridiagonal system of equations. The left side of row i is `lower · x[i-1] + middle · x[i] +
/// upper · x[i+1]`.
struct Tridiagonal {
  std::vector<double> lower;
  std::vector<double> middle;
  std::vector<double> upper;

  /// Returns the solution for the right side `right`, by elimination without pivoting (Thomas).
  /// @pre in each row, |middle| is greater than |lower| + |upper|
  template <typename Value>
  [[nodiscard]] std::vector<Value> solved(std::vector<Value> right) const {
    std::vector<double> share(right.size(), 0.0);
    for (std::size_t i = 0; i < right.size(); ++i) {
      const double pivot = middle[i] - (i == 0 ? 0.0 : lower[i] * share[i - 1]);
      share[i] = upper[i] / pivot;
      if (i != 0) right[i] -= lower[i] * right[i - 1];
      right[i] /= pivot;
    }
    for (std::size_t i = right.size() - 1; i-- > 0;) right[i] -= share[i] * right[i + 1];
    return right;
  }
};

/// Points, each with its distance to the next point. The point after the last one is the first one.
struct Chords {
  explicit Chords(const std::vector<Place>& through) : places{through}, spans(through.size()) {
    for (std::size_t i = 0; i < spans.size(); ++i) spans[i] = distance(places[i], after(i));
  }
  [[nodiscard]] const Place& after(std::size_t i) const { return places[(i + 1) % places.size()]; }
  [[nodiscard]] Place way(std::size_t i) const { return (after(i) - places[i]) / spans[i]; }

  const std::vector<Place>& places;
  std::vector<double> spans;
};

std::vector<Shape> beziers(const Chords& chords, const std::vector<Place>& slopes, bool closed) {
  std::vector<Shape> shapes;
  const std::size_t count = chords.places.size();
  for (std::size_t i = 0; i + (closed ? 0 : 1) < count; ++i) {
    const double third = chords.spans[i] / 3.0;
    const Place& from = chords.places[i];
    const Place& to = chords.after(i);
    shapes.emplace_back(
        Bezier{{from, from + slopes[i] * third, to - slopes[(i + 1) % count] * third, to}});
  }
  return shapes;
}

/// Adds the equation of a point: the curve has the same curvature on both sides of it.
void add_smooth_row(Tridiagonal& rows,
                    std::vector<Place>& right,
                    const Chords& chords,
                    std::size_t before,
                    std::size_t after) {
  const double low = 1.0 / chords.spans[before];
  const double high = 1.0 / chords.spans[after];
  rows.lower.push_back(low);
  rows.middle.push_back(2.0 * (low + high));
  rows.upper.push_back(high);
  right.emplace_back(3.0 * (low * chords.way(before) + high * chords.way(after)));
}

/// The data from which a spline is made, as the file gives them.
struct SplineData {
  std::size_t degree = 0;
  std::vector<Place> points;
  std::vector<double> weights;
  std::vector<double> knots;
};

/// Returns the reason why control points, weights and knots define no spline; empty if no fault is
/// found.
std::string wrong_of(const SplineData& data) {
  const std::size_t wanted = data.points.size() + data.degree + 1;
  if (data.degree < 1 || data.degree > kHighestDegree) {
    return fmt::format("its degree is not from 1 to {}", kHighestDegree);
  }
  if (data.points.size() <= data.degree) {
    return fmt::format(
        "{} control points make no spline of degree {}", data.points.size(), data.degree);
  }
  if (data.points.size() > kMaxControlPoints) {
    return fmt::format("it has more than {} control points", kMaxControlPoints);
  }
  if (data.knots.size() != wanted) {
    return fmt::format("it has {} knots, but {} control points of degree {} need {}",
                       data.knots.size(),
                       data.points.size(),
                       data.degree,
                       wanted);
  }
  if (!data.weights.empty() && data.weights.size() != data.points.size()) {
    return fmt::format(
        "it has {} weights for {} control points", data.weights.size(), data.points.size());
  }
  if (std::ranges::any_of(data.weights, [](double weight) { return !(weight > 0.0); })) {
    return "one of its weights is not above 0";
  }
  if (!std::ranges::is_sorted(data.knots)) return "its knots are not in ascending order";
  for (std::size_t i = 0; i + data.degree + 1 < data.knots.size(); ++i) {
    if (data.knots[i] == data.knots[i + data.degree + 1]) {
      return fmt::format("one of its knots occurs more than {} times", data.degree + 1);
    }
  }
  return {};
}

/// Returns the part of a spline from knot `from` up to, but not including, knot `to`.
std::optional<Nurbs> part_of(const SplineData& data, std::size_t from, std::size_t to) {
  const auto cut = [&](const auto& all, std::size_t count) {
    const auto start = all.begin() + static_cast<std::ptrdiff_t>(from);
    return std::vector(start, start + static_cast<std::ptrdiff_t>(count));
  };
  const std::size_t count = to - from - data.degree - 1;
  return nurbs(data.degree,
               cut(data.points, count),
               data.weights.empty() ? std::vector<double>{} : cut(data.weights, count),
               cut(data.knots, to - from));
}

/// Returns the curves of a spline, which is divided at inner knots that are repeated degree + 1
/// times.
DxfShapes spline_of(const SplineData& data) {
  DxfShapes drawn{.wrong = wrong_of(data)};
  if (!drawn.wrong.empty()) return drawn;
  const std::size_t repeats = data.degree + 1;
  std::size_t from = 0;
  // A part without a span, at the beginning or the end, is outside the domain of the curve.
  const auto add = [&](std::size_t to) {
    if (to - from <= 2 * data.degree + 1) return;
    if (auto curve = part_of(data, from, to)) drawn.shapes.emplace_back(*std::move(curve));
  };
  for (std::size_t i = 1; i + repeats < data.knots.size(); ++i) {
    if (data.knots[i] != data.knots[i + data.degree]) continue;
    add(i + repeats);
    from = i;
  }
  add(data.knots.size());
  if (drawn.shapes.empty()) drawn.wrong = "its knots define no span";
  return drawn;
}

std::optional<Place> tangent(const DxfEntity& entity, int code) {
  const Place way = entity.place(code);
  if (!entity.number(code) || !(way.norm() > 0.0)) return {};
  return way;
}

DxfShapes through_places(const DxfEntity& entity, std::vector<Place> through) {
  constexpr int kClosedFlag = 1;
  const bool closed = (entity.whole(70, 0) & kClosedFlag) != 0;
  // std::ranges::unique of this standard library does not compile with Clang 14.
  through.erase(std::unique(through.begin(), through.end()), through.end());
  const auto start = tangent(entity, 12);
  const auto end = tangent(entity, 13);
  if (closed && through.size() > 1 && through.front() == through.back()) through.pop_back();
  if (closed && !start && !end && through.size() > 2) return {.shapes = closed_spline(through)};
  if (closed && through.size() > 1) through.push_back(through.front());
  if (through.size() < 2) return {.wrong = "it has neither control points nor two fit points"};
  return {.shapes = fitted_spline(through, start, end)};
}

/// Returns whether all heights with the code `code` are equal. If not, the curve is drawn as it
/// appears from above.
bool is_level(const DxfEntity& entity, int code) {
  const std::vector<double> heights = entity.numbers(code);
  if (heights.empty()) return true;
  const auto [low, high] = std::ranges::minmax(heights);
  return high - low <= kFlatEnoughUnits;
}

}  // namespace

DxfShapes spline_shapes(const DxfEntity& entity) {
  DxfEntity spline = entity;
  if (spline.type == "HELIX") spline.drop_part("AcDbHelix");
  SplineData data{.degree = static_cast<std::size_t>(std::max(0, spline.whole(71, 3))),
                  .points = spline.places(10),
                  .weights = spline.numbers(41),
                  .knots = spline.numbers(40)};
  const bool by_points = !data.points.empty();
  DxfShapes drawn = by_points ? spline_of(data) : through_places(spline, spline.places(11));
  if (!is_level(spline, by_points ? 30 : 31)) drawn.notes.emplace_back(kDxfSeenFromAbove);
  return drawn;
}

std::vector<Shape> fitted_spline(const std::vector<Place>& places,
                                 const std::optional<Place>& start_tangent,
                                 const std::optional<Place>& end_tangent) {
  const Chords chords{places};
  const std::size_t last = places.size() - 1;
  Tridiagonal rows{.lower{0.0}, .middle{1.0}, .upper{start_tangent ? 0.0 : 0.5}};
  std::vector<Place> right;
  right.emplace_back(start_tangent ? Place{*start_tangent / start_tangent->norm()}
                                   : Place{1.5 * chords.way(0)});
  for (std::size_t i = 1; i < last; ++i) add_smooth_row(rows, right, chords, i - 1, i);
  rows.lower.push_back(end_tangent ? 0.0 : 0.5);
  rows.middle.push_back(1.0);
  rows.upper.push_back(0.0);
  right.emplace_back(end_tangent ? Place{*end_tangent / end_tangent->norm()}
                                 : Place{1.5 * chords.way(last - 1)});
  return beziers(chords, rows.solved(std::move(right)), false);
}

std::vector<Shape> closed_spline(const std::vector<Place>& places) {
  const Chords chords{places};
  const std::size_t count = places.size();
  Tridiagonal rows;
  std::vector<Place> right;
  for (std::size_t i = 0; i < count; ++i) {
    add_smooth_row(rows, right, chords, (i + count - 1) % count, i);
  }
  // The matrix of a closed spline has two corner elements as well. They are added to the
  // tridiagonal matrix as the product of a column and a row (Sherman and Morrison).
  const double corner = rows.lower.front();
  const double shift = -rows.middle.front();
  rows.middle.front() -= shift;
  rows.middle.back() -= corner * corner / shift;
  std::vector<double> column(count, 0.0);
  column.front() = shift;
  column.back() = corner;
  const std::vector<Place> one = rows.solved(std::move(right));
  const std::vector<double> other = rows.solved(std::move(column));
  const double ratio = corner / shift;
  const Place excess =
      (one.front() + ratio * one.back()) / (1.0 + other.front() + ratio * other.back());
  std::vector<Place> slopes(count);
  for (std::size_t i = 0; i < count; ++i) slopes[i] = one[i] - excess * other[i];
  return beziers(chords, slopes, true);
}

}  // namespace sim::drawing
