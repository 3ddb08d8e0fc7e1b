#pragma once

#include <cstddef>

namespace sim::cut {

/// What was asked for, and done, so that an order of cuts is safe to run, and what came with it.
struct SafetyFigures {
  bool avoids_freed = false;  ///< Rapids were led round what has been cut free.
  std::size_t led_round = 0;  ///< Rapids that have corners for it.
  double longer_mm = 0.0;     ///< Length by which these exceed straight ones.
  std::size_t lifted = 0;     ///< Rapids with the head lifted.
  std::size_t no_way = 0;     ///< Rapids without a way; each is a fault.

  bool cools = false;             ///< Pierces keep off fresh heat.
  std::size_t cooling_swaps = 0;  ///< Cuts that came earlier for it.
  std::size_t waits = 0;          ///< Pierces that the beam rests before, off…
  double waits_s = 0.0;           ///< …in all.

  bool chains = false;    ///< Cuts were joined without a pierce where that saves time.
  std::size_t links = 0;  ///< Pierces saved.
  double links_mm = 0.0;  ///< Length of the cuts between them.
  double links_s = 0.0;   ///< Time saved, by feeds and rates alone.

  bool slices_waste = false;  ///< The waste was cut into pieces.
  std::size_t slices = 0;     ///< Cuts for it.
  double slices_mm = 0.0;     ///< Their length.

  [[nodiscard]] bool is_asked() const { return avoids_freed || cools || chains || slices_waste; }
};

}  // namespace sim::cut
