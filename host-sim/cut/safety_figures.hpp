#pragma once

#include <cstddef>

namespace sim::cut {

/// Effects of the measures that were taken to make an order of cuts safe to run.
struct SafetyFigures {
  bool avoids_freed = false;  ///< Whether rapids were routed around freed areas.
  std::size_t led_round = 0;  ///< Number of rapids that have corners to avoid freed areas.
  double longer_mm = 0.0;     ///< Length that avoiding freed areas adds to rapids.
  std::size_t lifted = 0;     ///< Number of rapids that are lifted.
  std::size_t no_way = 0;     ///< Number of rapids for which no path was found; each is a fault.

  bool cools = false;             ///< Whether pierces keep away from fresh heat.
  std::size_t cooling_swaps = 0;  ///< Number of cuts that were moved forward to avoid heat.
  /// Number of pierces before which the beam waits with its power off.
  std::size_t waits = 0;
  double waits_s = 0.0;  ///< Total time of the waits before pierces.

  bool chains = false;    ///< Whether cuts were joined without a pierce where this saves time.
  std::size_t links = 0;  ///< Number of links, each of which saves a pierce.
  double links_mm = 0.0;  ///< Total length of the links.
  double links_s = 0.0;   ///< Time that the links save, computed without acceleration.

  bool slices_waste = false;  ///< Whether the waste was divided into pieces.
  std::size_t slices = 0;     ///< Number of cuts that divide the waste.
  double slices_mm = 0.0;     ///< Length of the cuts that divide the waste.

  [[nodiscard]] bool is_asked() const { return avoids_freed || cools || chains || slices_waste; }
};

}  // namespace sim::cut
