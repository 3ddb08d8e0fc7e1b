#pragma once

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>
#include <optional>

namespace proof {

/// Integers of up to 1,024 bits, which no computation here exceeds.
using Whole = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<1024,
                                           1024,
                                           boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked,
                                           void>,
    boost::multiprecision::et_off>;
using WholeVector = std::array<Whole, 3>;

inline WholeVector difference(const WholeVector& a, const WholeVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline WholeVector scaled(const WholeVector& a, const Whole& by) {
  return {a[0] * by, a[1] * by, a[2] * by};
}
inline Whole dot(const WholeVector& a, const WholeVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline WholeVector cross(const WholeVector& a, const WholeVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A cone whose coordinates are integer multiples of a unit, so that every result is exact. With z
/// along the axis, the cone contains a point p if 0 ≤ z ≤ length and z² ≥ cos² |p|².
struct WholeCone {
  WholeVector tip{};
  WholeVector axis{};   ///< Direction of the axis; its length is an integer, too.
  Whole axis_length{};  ///< Length of the axis.
  Whole cosine{};       ///< Cosine of the half angle, times `whole`.
  Whole whole{};
  Whole length{};  ///< Length in units.

  /// Returns whether the cone intersects or touches a triangle.
  [[nodiscard]] bool meets(const std::array<WholeVector, 3>& triangle) const {
    const std::array<WholeVector, 3> corners{
        difference(triangle[0], tip), difference(triangle[1], tip), difference(triangle[2], tip)};
    std::array<WholeVector, 2> crossings{};
    std::array<Whole, 2> shares{};
    std::size_t count = 0;
    const Whole top = length * axis_length;
    for (std::size_t i = 0; i < 3; ++i) {
      const WholeVector& from = corners[i];
      const WholeVector& to = corners[(i + 1) % 3];
      if (meets_line(from, to, 1)) return true;
      const Whole low = dot(from, axis);
      const Whole climb = dot(to, axis) - low;
      if (count == 2 || (low > top) == (low + climb > top)) continue;
      // The edge passes the plane at from + (top − low) / climb (to − from).
      const Whole sign = climb < 0 ? -1 : 1;
      const WholeVector way = scaled(difference(to, from), sign * (top - low));
      const WholeVector base = scaled(from, sign * climb);
      crossings[count] = {base[0] + way[0], base[1] + way[1], base[2] + way[2]};
      shares[count++] = sign * climb;
    }
    if (count == 2 && meets_line(scaled(crossings[0], shares[1]),
                                 scaled(crossings[1], shares[0]),
                                 shares[0] * shares[1])) {
      return true;
    }
    return axis_meets(corners);
  }

 private:
  /// Returns z² − cos² p·q for two vectors, times the factor that makes it an integer. For p = q it
  /// is at least 0 if the point is in the double cone.
  [[nodiscard]] Whole form(const WholeVector& p, const WholeVector& q) const {
    return whole * whole * dot(p, axis) * dot(q, axis) -
           cosine * cosine * axis_length * axis_length * dot(p, q);
  }

  /// A fraction with a positive denominator.
  struct Share {
    Whole over;
    Whole under;
  };

  /// Returns whether a line intersects the cone; its ends have a common positive denominator.
  [[nodiscard]] bool meets_line(const WholeVector& from,
                                const WholeVector& to,
                                const Whole& under) const {
    const WholeVector way = difference(to, from);
    const Whole low = dot(from, axis);
    const Whole climb = dot(way, axis);
    Share begin{0, 1};
    Share end{1, 1};
    for (const Whole& plane : {Whole{0}, Whole{length * axis_length * under}}) {
      const bool keeps_above = plane == 0;
      // Positive if `from` is outside.
      const Whole beyond = keeps_above ? plane - low : low - plane;
      const Whole leaving = keeps_above ? Whole{-climb} : climb;
      if (leaving == 0) {
        if (beyond > 0) return false;
        continue;
      }
      // A point is inside if beyond + leaving t ≤ 0.
      if (leaving > 0) {
        if (-beyond * end.under < end.over * leaving) end = {-beyond, leaving};
      } else if (beyond * begin.under > begin.over * -leaving) {
        begin = {beyond, -leaving};
      }
    }
    if (begin.over * end.under > end.over * begin.under) return false;
    const Whole a = form(way, way);
    const Whole b = form(from, way);
    const Whole c = form(from, from);
    for (const Share& share : {begin, end}) {
      if (a * share.over * share.over + 2 * b * share.over * share.under +
              c * share.under * share.under >=
          0) {
        return true;
      }
    }
    if (a >= 0) return false;
    // The greatest value is at b / −a.
    const bool is_between = begin.over * -a <= b * begin.under && b * end.under <= end.over * -a;
    return is_between && b * b >= a * c;
  }

  [[nodiscard]] bool axis_meets(const std::array<WholeVector, 3>& corners) const {
    std::array<Whole, 3> areas{};
    for (std::size_t i = 0; i < 3; ++i) {
      areas[i] = dot(cross(corners[(i + 1) % 3], corners[(i + 2) % 3]), axis);
    }
    const bool has_left = areas[0] > 0 || areas[1] > 0 || areas[2] > 0;
    const bool has_right = areas[0] < 0 || areas[1] < 0 || areas[2] < 0;
    if (has_left == has_right) return false;
    Whole sum = areas[0] + areas[1] + areas[2];
    Whole along = areas[0] * dot(corners[0], axis) + areas[1] * dot(corners[1], axis) +
                  areas[2] * dot(corners[2], axis);
    if (sum < 0) {
      sum = -sum;
      along = -along;
    }
    return along >= 0 && along <= length * axis_length * sum;
  }
};

}  // namespace proof
