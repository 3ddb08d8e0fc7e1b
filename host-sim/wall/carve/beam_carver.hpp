#pragma once

#include <cstddef>

#include "host-sim/wall/carve/beam_strokes.hpp"
#include "host-sim/wall/carve/columns.hpp"

namespace sim::wall {

/// Shape of a burning beam: its cone, and the angle by which heat widens the cone.
struct BurningBeam {
  double half_angle_rad = 0.0;  ///< Half angle of the cone, > 0 and < 90 degrees.
  /// Angle by which heat widens the cone on each side. The sum with the half angle is < 90 degrees.
  double heat_rad = 0.0;
  double waist_mm = 0.0;  ///< Radius of the beam at its tip, at least 0.
};

/// Maximum width in mm, at the height of the stock's top, by which the carver burns too much if the
/// axis turns along a stroke.
inline constexpr double kSwingErrorMm = 1.0e-3;

/// Removes from columns the material that the strokes of a beam burn.
///
/// The beam burns everything within the cone from the tip up to the lens, which is above the stock.
/// Below the tip, it burns a cylinder of the waist's radius down to the depth. Between two poses,
/// the tip moves on a line and the axis turns in one plane. If the axis keeps its direction,
/// heights are exact. If the axis turns, the stroke is divided into parts, and the cone is widened
/// by the turn of the axis within a part. So the carver never burns too little; at the stock's top,
/// it burns at most kSwingErrorMm too wide.
class BeamCarver {
 public:
  BeamCarver(Columns& columns, const BurningBeam& beam) : columns_{columns}, beam_{beam} {}

  void carve(const BeamStroke& stroke);

  /// moves() returns the number of carved lines. parts() returns the number of parts into which the
  /// lines were divided.
  [[nodiscard]] std::size_t moves() const { return moves_; }
  [[nodiscard]] std::size_t parts() const { return parts_; }

 private:
  void move(const BeamPose& from, const BeamPose& to);
  void burn(const CutCone& cone, const Eigen::Vector3d& from, const Eigen::Vector3d& way);
  void burn_row(const SweptCone& cone, int row, double from, double until);

  Columns& columns_;
  BurningBeam beam_;
  std::size_t moves_ = 0;
  std::size_t parts_ = 0;
};

}  // namespace sim::wall
