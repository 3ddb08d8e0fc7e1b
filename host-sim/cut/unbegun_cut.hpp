#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/cut/beginning.hpp"
#include "host-sim/cut/layer_settings.hpp"
#include "host-sim/cut/stroke.hpp"

namespace sim::cut {

/// The path of the beam along a contour, before its beginning and its position in the order are
/// chosen.
struct UnbegunCut {
  MeasuredRow path;         ///< Path with the part on its left, or along an open line.
  bool is_open = false;     ///< The path does not end where it begins.
  bool is_on_edge = false;  ///< The path follows edges that parts share; see shared_edges().
  LayerSettings settings;   ///< Settings of its layer.
  double half_kerf_mm = 0.0;
  std::size_t layer = 0;
  std::size_t part = 0;  ///< Number of the part, which is the same for all its cuts.
  /// Turn of the cut's part; parts of lower turns are cut first.
  std::size_t part_turn = 0;
  std::vector<std::size_t> after{};     ///< Cuts that must come before this cut.
  std::vector<Beginning> beginnings{};  ///< Beginnings, at least one; the usual one first.
  /// Own cost of the cut with each beginning, minus that of the cheapest one, in the units of
  /// RapidCost. Empty: the same for all beginnings.
  std::vector<double> own_cost{};
  bool may_move = true;  ///< The cut may also begin anywhere between these beginnings.

  /// Returns the own cost with a beginning, which is given by its number.
  [[nodiscard]] double own_cost_of(std::size_t beginning) const {
    return own_cost.empty() ? 0.0 : own_cost[beginning];
  }
};

/// A cut in an order, with its beginning.
struct OrderedCut {
  std::size_t cut = 0;  ///< Number of the cut in the list of unbegun cuts.
  Beginning beginning{};
};

}  // namespace sim::cut
