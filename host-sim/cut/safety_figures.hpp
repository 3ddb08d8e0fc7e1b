#pragma once

#include <cstddef>

namespace sim::cut {

/// Measures that were required and taken to make an order of cuts safe to run, with their effects.
struct SafetyFigures {
  bool avoids_freed = false;  ///< Rapids were routed around freed areas.
  std::size_t led_round = 0;  ///< Number of rapids that have corners for this reason.
  double longer_mm = 0.0;     ///< Length by which these rapids exceed straight ones.
  std::size_t lifted = 0;     ///< Number of rapids with the head lifted.
  std::size_t no_way = 0;     ///< Number of rapids without a path; each is a fault.

  bool cools = false;             ///< Pierces keep away from fresh heat.
  std::size_t cooling_swaps = 0;  ///< Number of cuts that were moved forward to avoid heat.
  std::size_t waits = 0;          ///< Number of pierces before which the beam rests off.
  double waits_s = 0.0;           ///< Total time of these rests.

  bool chains = false;    ///< Cuts were joined without a pierce where that saves time.
  std::size_t links = 0;  ///< Number of links, each of which saves a pierce.
  double links_mm = 0.0;  ///< Total length of the links.
  double links_s = 0.0;   ///< Saved time, computed from feeds and rates alone.

  bool slices_waste = false;  ///< The waste was cut into pieces.
  std::size_t slices = 0;     ///< Number of cuts that divide the waste.
  double slices_mm = 0.0;     ///< Length of these cuts.

  [[nodiscard]] bool is_asked() const { return avoids_freed || cools || chains || slices_waste; }
};

}  // namespace sim::cut
