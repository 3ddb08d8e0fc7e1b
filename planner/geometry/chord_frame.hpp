#pragma once

#include <cstdint>

namespace cnc {

/// Position of a point of an arc relative to its chord, in chord lengths. `along` runs from 0 at
/// the start to 1 at the end; `across` is positive to the left. Q30 means that 2^30 stands for 1.
struct ChordPoint {
  std::int32_t along_q30;
  std::int32_t across_q30;
  float along_rate;   ///< Derivative d along / d fraction.
  float across_rate;  ///< Derivative d across / d fraction.
};

/// Evaluates an arc of at most half a turn at a fraction of its length. It uses fixed point and
/// multiplications only, because it runs once for each motion segment and decides at which times
/// steps occur.
///
/// With half sweep h and μ = 2·fraction − 1:
///   along  = ½ + ½ sin(μh) / sin h
///   across = −½ (cos μh − cos h) / sin h
/// Both are written with S(z) = sin x / x and C(z) = (1 − cos x) / x², z = x². S and C are
/// well-conditioned polynomials. So an arc that is nearly a line needs no separate case, and a line
/// is simply h = 0.
///
/// Guarantee: along and across are within kChordPointError of the exact values for the stored half
/// sweep; at a chord of 4 m that is 20 nm.
class ChordFrame {
 public:
  static constexpr double kChordPointError = 5.0e-9;

  ChordFrame() : ChordFrame{0.0F} {}
  /// @param half_sweep in radians, |half_sweep| ≤ π/2 except for rounding; positive turns left.
  explicit ChordFrame(float half_sweep);

  /// Returns a point of the arc.
  /// @param fraction share of the arc length; 2^32 stands for the end.
  [[nodiscard]] ChordPoint at(std::uint32_t fraction) const;

 private:
  float half_sweep_;
  std::uint32_t quarter_square_q32_;  ///< (h / 2)², with the half sweep h.
  std::uint32_t versine_q32_;         ///< Value of the function C at h².
  std::uint32_t inverse_sine_q31_;    ///< The ratio h / sin h, 1…π/2.
  std::int32_t height_scale_q29_;     ///< The ratio h² / sin h, for the scale of `across`.
  float inverse_sine_;
};

}  // namespace cnc
