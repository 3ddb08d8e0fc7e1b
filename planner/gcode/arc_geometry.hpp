#pragma once

#include <cstdint>

namespace cnc::gcode {

/// A vector in the plane of an arc, in whole nanometres. Differences of places
/// that are in range, so |component| ≤ 2e12.
struct PlaneVector {
  std::int64_t first = 0;
  std::int64_t second = 0;

  [[nodiscard]] bool is_null() const { return first == 0 && second == 0; }
  /// In mm, relative error at most 3e-7.
  [[nodiscard]] float length() const;

  friend PlaneVector operator-(PlaneVector a, PlaneVector b) {
    return {a.first - b.first, a.second - b.second};
  }
};

/// How far the end of an arc may lie off the circle through its start.
struct ArcTolerance {
  float absolute_mm = 0.05F;
  float relative = 0.01F;  ///< Of the radius.
};

/// The greater of the two tolerances, at most 0.5 mm, but never stricter than
/// Grbl 1.1, which takes 0.005 mm, or 0.1 % of the radius up to 0.5 mm.
[[nodiscard]] float allowed_deviation(const ArcTolerance& tolerance, float radius_mm);

/// | |centre to end| − |centre to start| | in mm, both vectors from the start.
///
/// Not the difference of the two radii, which for large circles is rounding
/// noise, but |d·(d − 2c)| / (r0 + r1), the same since r1² − r0² = d·(d − 2c), with
/// the product in integers. Error at most 1e-6 of the result, plus 2e-8 of the
/// radius where that exceeds 0.5 m.
/// @pre centre is not the start.
[[nodiscard]] float radius_deviation(PlaneVector end, PlaneVector centre);

struct CentreByRadius {
  PlaneVector centre;  ///< From the start.
  /// By how much the chord exceeds the diameter; 0 when it does not. Error at
  /// most 1e-8 of the radius, and none below 1 m.
  float excess_mm = 0.0F;
};

/// The centre of the arc to `end`, from the start, whose radius is given
/// (RS274/NGC 3.5.3.1): of the two, that of the shorter arc for a positive
/// radius and of the longer for a negative one. A chord that is longer than the
/// diameter has no centre, and its middle is taken.
/// Error at most 3e-7 of the radius; the centre is that close to the
/// perpendicular through the middle of the chord.
/// @param radius_nm not zero, in the range of a coordinate.
/// @pre end is not the start.
[[nodiscard]] CentreByRadius centre_by_radius(PlaneVector end,
                                              std::int64_t radius_nm,
                                              bool clockwise);

}  // namespace cnc::gcode
