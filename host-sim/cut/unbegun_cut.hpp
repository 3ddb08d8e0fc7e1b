#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/cut/beginning.hpp"
#include "host-sim/cut/layer_settings.hpp"
#include "host-sim/cut/stroke.hpp"

namespace sim::cut {

/// A contour as the beam goes along it, whose beginning and place in the order are not chosen yet.
struct UnbegunCut {
  MeasuredRow path;         ///< With the part on its left, or along an open line.
  bool is_open = false;     ///< It ends elsewhere than it begins.
  bool is_on_edge = false;  ///< It goes along edges that parts share; see shared_edges().
  LayerSettings settings;   ///< Of its layer.
  double half_kerf_mm = 0.0;
  std::size_t layer = 0;
  std::size_t part = 0;              ///< Cuts of one part have one number.
  std::size_t part_turn = 0;         ///< The turn of its part; parts of lower turns are cut first.
  std::vector<std::size_t> after{};  ///< Cuts that must come before.
  std::vector<Beginning> beginnings{};  ///< Not empty; the usual one first.
  /// Cost of the cut itself with each beginning, above that of the cheapest, in the units of
  /// RapidCost; empty: the same for all.
  std::vector<double> own_cost{};
  bool may_move = true;  ///< It may begin anywhere between these, too.

  /// Returns the own cost with a beginning, by its number.
  [[nodiscard]] double own_cost_of(std::size_t beginning) const {
    return own_cost.empty() ? 0.0 : own_cost[beginning];
  }
};

/// A cut in its turn, and where it begins.
struct OrderedCut {
  std::size_t cut = 0;  ///< Number of the unbegun cut.
  Beginning beginning{};
};

}  // namespace sim::cut
