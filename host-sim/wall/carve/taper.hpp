#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace sim::wall {

/// How heat leans walls, from measured cuts.
///
/// A beam that leans away from a wall by `gain` half angles more than its cone needs leaves the
/// wall at: drawn angle + heat - response * gain * half angle, so the gain that leaves it as drawn
/// is heat / (response * half angle).
struct TaperFit {
  double heat_deg = 0.0;   ///< By which a wall leans where the beam only clears it.
  double response = 1.0;   ///< Share of what the beam leans more by which the wall leans less.
  double gain = 0.0;       ///< That leaves walls as drawn.
  double rest_deg = 0.0;   ///< Root of the mean square of what the cuts are off this.
  std::size_t used = 0;    ///< Cuts.
  std::size_t passed = 0;  ///< Cuts that tell nothing: an upright beam clears their wall.
};

/// Greatest gain that is of use.
inline constexpr double kMostTaperGain = 12.0;

/// Fits heat and response to a text of measured walls by least squares. With one gain in the text
/// the response is 1.
/// @param cuts `drawn carved gain` on each line: angles from the vertical in degrees, above 0 where
/// the part is wider below, and the gain of the cut, 0 where left out
/// @param name of the text, for messages. Throws std::invalid_argument for a line that is no cut,
/// where no cut counts, where a greater gain makes no wall steeper, and for a gain beyond
/// kMostTaperGain.
[[nodiscard]] TaperFit fit_taper(std::string_view cuts,
                                 double half_angle_deg,
                                 const std::string& name);

}  // namespace sim::wall
