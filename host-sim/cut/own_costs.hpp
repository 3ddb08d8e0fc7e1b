#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

#include "host-sim/cut/order_wish.hpp"
#include "host-sim/cut/recipe.hpp"
#include "host-sim/cut/unbegun_cut.hpp"

namespace sim::cut {

/// Finds how the time of a cut depends on its beginning. A cut that begins at a corner stops where
/// the machine would have slowed down anyway. A cut that begins in the middle of an edge needs one
/// more stop.
///
/// Times are those of ControllerClock, from the end of the rapid to the end of the cut. Cuts with
/// the same strokes share their times. Cuts that differ by a quarter turn share them, too, if both
/// axes have the same limits. The work is bounded by numbers of strokes, so that results are the
/// same on every machine. Beyond this bound, a cut costs the same with all its beginnings.
class OwnCosts {
 public:
  /// Returns the strokes of a cut with one of its beginnings.
  using StrokesOf = std::function<std::vector<Stroke>(const Beginning&)>;

  /// Sets the machine whose limits determine the times.
  /// @param machine must outlive this object
  explicit OwnCosts(const OrderWish& machine);

  /// Sets the own costs of a cut that has several beginnings.
  void find(UnbegunCut& cut, const LayerPlan& layer, const StrokesOf& strokes_of);

 private:
  [[nodiscard]] std::uint64_t digest_of(const std::vector<Stroke>& strokes,
                                        const LayerPlan& layer) const;
  [[nodiscard]] double time_of(const std::vector<Stroke>& strokes, const LayerPlan& layer);

  const OrderWish& machine_;
  bool is_even_;  ///< Both axes have the same limits.
  std::size_t strokes_left_;
  /// Number of motions that may still be planned.
  std::size_t motions_left_;
  std::unordered_map<std::uint64_t, double> known_s_;  ///< Known times by digest of the strokes.
};

/// Returns the own cost of a cut at any beginning: the cost of the listed beginning at that point,
/// otherwise that of the nearest listed beginning within the same stroke, otherwise the highest
/// cost.
[[nodiscard]] double own_cost_at(const UnbegunCut& cut, const Beginning& beginning);

}  // namespace sim::cut
