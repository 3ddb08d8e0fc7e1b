#pragma once

#include <cstddef>

#include "host-sim/wall/carve/beam_strokes.hpp"
#include "host-sim/wall/carve/columns.hpp"

namespace sim::wall {

/// The cone of a beam that burns, and how heat widens it.
struct BurningBeam {
  double half_angle_rad = 0.0;  ///< Above 0, below a right angle.
  /// By which heat widens the cone, on each side; with the half angle below a right angle.
  double heat_rad = 0.0;
  double waist_mm = 0.0;  ///< Radius at the tip, at least 0.
};

/// By which a beam whose axis turns along its stroke burns too far at the height of the stock's
/// top, at most, mm.
inline constexpr double kSwingErrorMm = 1.0e-3;

/// Burns the strokes of a beam into columns.
///
/// Everything is burned that is within the cone above the tip, up to the lens, which is above the
/// stock, and within the waist down to the depth below the tip. Between two poses the tip moves on
/// a line and the axis turns in one plane. Where the axis stays, heights are exact. Where it turns,
/// the stroke is divided and the cone widened by what the axis turns in a part, so that never less
/// is burned, and at the stock's top no more than kSwingErrorMm too far.
class BeamCarver {
 public:
  BeamCarver(Columns& columns, const BurningBeam& beam) : columns_{columns}, beam_{beam} {}

  void carve(const BeamStroke& stroke);

  /// Returns how many lines of the tip were carved, and from how many parts.
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
