#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host-sim/cut/clearance.hpp"
#include "host-sim/cut/layer_settings.hpp"
#include "host-sim/cut/stroke.hpp"

namespace sim::cut {

/// Where the beam's way beside a part turns sharply.
struct Corner {
  std::size_t stroke =
      0;                  ///< The arc around an outer corner; at an inner one that which leaves it.
  bool is_outer = false;  ///< The waste is outside the turn: there is room for a loop.
  Place place{0.0, 0.0};  ///< In the middle of the turn.
};

/// Corners between strokes along the edge of a part on the left, that turn by at least so much;
/// of a closed row also where it closes.
/// Outer ones are arcs of half the kerf around a drawn corner; drawn rounds are none.
/// @param least_turn radians
[[nodiscard]] std::vector<Corner> corners_of(const std::vector<Stroke>& strokes,
                                             double least_turn,
                                             double half_kerf_mm);

/// What was done about the corners of a cut.
struct CornerWork {
  std::size_t without_room = 0;  ///< Outer corners whose loops would come too near to a part…
  std::optional<Place> first_without{};  ///< …and the first of them.
  std::size_t smaller = 0;               ///< Loops with less than the radius that was set…
  std::optional<Place> first_smaller{};  ///< …and the first of them.
};

/// Against burnt corners, as the settings ask. A loop goes straight on past an outer corner, turns
/// round in the waste and comes back along the next edge, so that the part is passed at speed; it
/// is made smaller, to an eighth, where there is no room. At inner corners, and where there is no
/// room for a loop, the beam rests dark for the dwell before it goes on.
/// @param parts all drawn edges; nothing of a loop is nearer to one than half the kerf
CornerWork treat_corners(std::vector<Stroke>& strokes,
                         const LayerSettings& settings,
                         const Clearance& parts,
                         double half_kerf_mm);

}  // namespace sim::cut
