#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace sim::wall {

/// A model of the lean that heat causes at walls, fitted to measured cuts.
///
/// A beam leans away from a wall by the angle that its cone requires plus gain * half angle. The
/// wall then gets the angle drawn angle + heat - response * gain * half angle. So the gain for the
/// drawn angle is heat / (response * half angle).
struct TaperFit {
  /// Additional lean of a wall if the beam touches the drawn wall (gain 0).
  double heat_deg = 0.0;
  /// Decrease of the wall's lean per additional lean of the beam.
  double response = 1.0;
  double gain = 0.0;      ///< Gain for which walls get the drawn angle.
  double rest_deg = 0.0;  ///< Root mean square of the cuts' deviations from the fit.
  std::size_t used = 0;   ///< Number of cuts used.
  /// Number of ignored cuts, at which an upright beam clears the wall.
  std::size_t passed = 0;
};

/// Maximum useful gain.
inline constexpr double kMaxTaperGain = 12.0;

/// Fits heat and response to measured walls by least squares. If all cuts have the same gain, the
/// response is 1.
/// @param cuts `drawn carved gain` on each line: angles from the vertical in degrees, > 0 if the
/// part is wider below, and the gain of the cut, 0 if omitted
/// @param name name of the text, for messages
/// Throws std::invalid_argument for a line that is not a cut, if no cut can be used, if a greater
/// gain makes no wall steeper, and for a gain beyond kMaxTaperGain.
[[nodiscard]] TaperFit fit_taper(std::string_view cuts,
                                 double half_angle_deg,
                                 const std::string& name);

}  // namespace sim::wall
