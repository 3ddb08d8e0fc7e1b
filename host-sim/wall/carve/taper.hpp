#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace sim::wall {

/// Lean that heat gives to walls, fitted to measured cuts.
///
/// If a beam leans away from a wall by `gain` half angles more than its cone needs, the wall gets
/// the angle: drawn angle + heat - response * gain * half angle. The gain that gives the drawn
/// angle is thus heat / (response * half angle).
struct TaperFit {
  double heat_deg = 0.0;  ///< Angle by which a wall leans if the beam only just clears it.
  /// Decrease of the wall's lean divided by the additional lean of the beam.
  double response = 1.0;
  double gain = 0.0;      ///< Gain that gives walls their drawn angle.
  double rest_deg = 0.0;  ///< Root mean square of the cuts' deviations from this fit.
  std::size_t used = 0;   ///< Number of cuts used.
  /// Number of cuts without information: an upright beam clears their walls.
  std::size_t passed = 0;
};

/// Maximum useful gain.
inline constexpr double kMaxTaperGain = 12.0;

/// Fits heat and response to a text of measured walls by least squares. If the text has only one
/// gain, the response is 1.
/// @param cuts `drawn carved gain` on each line: angles from the vertical in degrees, above 0 if
/// the part is wider below, and the gain of the cut, 0 if left out
/// @param name name of the text, for messages
/// Throws std::invalid_argument for a line that is not a cut, if no cut can be used, if a greater
/// gain makes no wall steeper, and for a gain beyond kMaxTaperGain.
[[nodiscard]] TaperFit fit_taper(std::string_view cuts,
                                 double half_angle_deg,
                                 const std::string& name);

}  // namespace sim::wall
