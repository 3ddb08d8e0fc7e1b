#pragma once

#include <string>
#include <vector>

#include "host-sim/cut/layer_settings.hpp"
#include "host-sim/cut/lead.hpp"
#include "host-sim/cut/stroke.hpp"

namespace sim::cut {

/// The path for a controller that computes the compensated path itself, or the reason why there is
/// no such path.
struct ControllerWay {
  /// The strokes in order. A pierce in the waste comes first, if one is required. The entry follows
  /// (kLeadIn, the first stroke under G42). Then come the drawn outline with the part on its left,
  /// and a short piece of the outline for a second time. The exit is last (kLeadOut, the first
  /// stroke after G40). Empty if `reason` has a text.
  std::vector<Stroke> strokes{};
  std::string reason{};
};

/// Returns the path of a cut for G42. It begins where `beam` begins, and ends in the waste. Entry
/// and exit are straight. The entry meets the outline at an angle, so the beam reaches the edge a
/// little after the start of the outline. The path continues past the start of the outline by the
/// same distance, so that no edge stays uncut.
/// @param outline closed, with the part on its left
/// @param beam path of the beam for this cut as planned by this program, with its leads
[[nodiscard]] ControllerWay controller_way(const std::vector<Stroke>& outline,
                                           const std::vector<Stroke>& beam,
                                           const LayerSettings& settings,
                                           const LeadRoom& room);

}  // namespace sim::cut
