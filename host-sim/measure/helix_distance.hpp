#pragma once

namespace sim {

/// Squared distance of a point from a helix of less than a full turn, as a function of the
/// fraction f of the helix:
///
///   point_radius² + radius² − 2 point_radius radius cos(sweep f − point_angle)
///   + run_squared f² + 2 run_offset f + offset_squared
///
/// The first line is the squared distance in the plane of the circle. The second line is the
/// squared distance on all other axes, which move straight.
struct HelixDistance {
  double radius = 0.0;        ///< Radius of the helix, mm.
  double sweep = 0.0;         ///< Angle of the helix, radians, positive.
  double point_radius = 0.0;  ///< Distance of the point from the axis of the helix, mm.
  double point_angle = 0.0;   ///< Angle of the point from the start, in the direction of travel.
  /// |run|², where run is the motion of the straight axes from start to end, mm².
  double run_squared = 0.0;
  double run_offset = 0.0;      ///< run · (start − point) on the straight axes, mm².
  double offset_squared = 0.0;  ///< |start − point|² on the straight axes, mm².

  [[nodiscard]] double squared(double fraction) const;

  /// Returns the fraction from `from` to 1 at which the distance is least.
  ///
  /// Begins with the result for the linearised curve and continues with Newton's method. A
  /// stationary point that is nearer than the radius is the nearest point, because the reach of a
  /// helix of up to half a turn is at least its radius (Federer, Curvature Measures, 4.8). For
  /// points farther away, and for longer helices, the complete curve is searched.
  [[nodiscard]] double nearest_fraction(double from) const;

 private:
  [[nodiscard]] double half_slope(double fraction) const;
  [[nodiscard]] double half_slope_rate(double fraction) const;
  [[nodiscard]] bool stationary(double fraction, double from) const;
  [[nodiscard]] double refined(double fraction, double low, double high) const;
  [[nodiscard]] double searched(double from) const;
};

}  // namespace sim
