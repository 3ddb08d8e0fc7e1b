#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/cut/beginning.hpp"
#include "host-sim/cut/layer_settings.hpp"
#include "host-sim/cut/stroke.hpp"

namespace sim::cut {

/// A cut before its beginning and its position in the order are chosen.
struct UnbegunCut {
  /// Path of the cut, with the part on its left. For an open line, the line itself.
  MeasuredRow path;
  bool is_open = false;  ///< Whether the path is open: it ends at another point than its start.
  /// Whether the path follows edges that parts share; see shared_edges().
  bool is_on_edge = false;
  LayerSettings settings;  ///< Settings of the cut's layer or contour.
  double half_kerf_mm = 0.0;
  std::size_t layer = 0;
  std::size_t part = 0;  ///< Number of the cut's part. All cuts of the part have the same number.
  /// Turn of the cut's part. Parts of lower turns are cut first.
  std::size_t part_turn = 0;
  std::vector<std::size_t> after{};  ///< Numbers of the cuts that must come before this cut.
  /// Listed beginnings, at least one; the usual one comes first.
  std::vector<Beginning> beginnings{};
  /// Own cost of the cut with each listed beginning, minus the least own cost, in the units of
  /// RapidCost. Empty: all have the same own cost.
  std::vector<double> own_cost{};
  bool may_move = true;  ///< Whether the cut may also begin between the listed beginnings.

  /// Returns the own cost of the cut with the beginning of the given number.
  [[nodiscard]] double own_cost_of(std::size_t beginning) const {
    return own_cost.empty() ? 0.0 : own_cost[beginning];
  }
};

/// A cut at its position in an order, with its beginning.
struct OrderedCut {
  std::size_t cut = 0;  ///< Number of the cut in the list of UnbegunCut.
  Beginning beginning{};
};

}  // namespace sim::cut
