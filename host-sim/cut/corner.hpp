#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host-sim/cut/clearance.hpp"
#include "host-sim/cut/layer_settings.hpp"
#include "host-sim/cut/stroke.hpp"

namespace sim::cut {

/// A point where the beam's path along a part turns sharply.
struct Corner {
  std::size_t stroke =
      /// Number of the stroke at the corner. It is the arc around an outer corner, or the stroke
      /// that begins at an inner corner.
      0;
  /// Whether the waste is on the outside of the turn. A loop may then have free space.
  bool is_outer = false;
  Place place{0.0, 0.0};  ///< Point in the middle of the turn.
};

/// Returns the corners of a row of strokes along the edge of a part on the left, at which the row
/// turns by at least `min_turn`. The point where a closed row closes may be a corner, too. Outer
/// corners are arcs of half the kerf around a drawn corner. Rounded corners of the drawing are no
/// corners.
/// @param min_turn radians
[[nodiscard]] std::vector<Corner> corners_of(const std::vector<Stroke>& strokes,
                                             double min_turn,
                                             double half_kerf_mm);

/// Result of the treatment of a cut's corners.
struct CornerWork {
  /// Number of outer corners without a loop, because a loop would come too near to a part.
  std::size_t without_room = 0;
  std::optional<Place> first_without{};  ///< Point of the first outer corner without a loop.
  std::size_t smaller = 0;               ///< Number of loops with a radius below the required one.
  /// Point of the first corner whose loop has a smaller radius.
  std::optional<Place> first_smaller{};
};

/// Changes strokes to prevent burnt corners, as the settings require. A loop continues straight
/// past an outer corner, turns around in the waste and comes back along the next edge. So the beam
/// passes the corner of the part at speed. Where free space is lacking, the radius of the loop is
/// reduced, at most to an eighth. At inner corners, and at outer corners without free space, the
/// beam rests with its power off for the time of the dwell.
/// @param parts all drawn edges; every point of a loop is at least half the kerf from each of them
CornerWork treat_corners(std::vector<Stroke>& strokes,
                         const LayerSettings& settings,
                         const Clearance& parts,
                         double half_kerf_mm);

}  // namespace sim::cut
