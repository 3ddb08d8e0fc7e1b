#pragma once

#include <string>
#include <vector>

#include "host-sim/cut/layer_settings.hpp"
#include "host-sim/cut/lead.hpp"
#include "host-sim/cut/stroke.hpp"

namespace sim::cut {

/// What a controller is given that finds the way beside a part itself, or why it cannot be.
struct ControllerWay {
  /// A pierce in the waste where one is asked for, the entry (kLeadIn, the first of G42), the
  /// drawn outline with the part on its left, a bit of it once more, and the exit (kLeadOut, the
  /// first after G40); none where there is a reason.
  std::vector<Stroke> strokes{};
  std::string reason{};
};

/// The way of a cut for G42, beginning beside the place where the beam's way begins and ending
/// in the waste. Entry and exit are straight; the entry turns into the outline at an angle, so the
/// beam reaches it a little later, and the end goes on as far.
/// @param outline closed, the part on its left
/// @param beam the same cut as it is planned here, leads included
[[nodiscard]] ControllerWay controller_way(const std::vector<Stroke>& outline,
                                           const std::vector<Stroke>& beam,
                                           const LayerSettings& settings,
                                           const LeadRoom& room);

}  // namespace sim::cut
