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

/// Computes the own costs of cuts: the time that each beginning adds to its cut. A cut that begins
/// at a corner stops where the machine would slow down in any case. A cut that begins in the middle
/// of an edge makes one more stop.
///
/// Times are those of ControllerClock, from the end of the rapid to the end of the cut. Cuts with
/// the same strokes share their times. Cuts that differ by a quarter turn share them, too, if both
/// axes have the same limits. The work is bounded by numbers of strokes, so that results are the
/// same on every machine. Beyond this bound, all beginnings of a cut have the same cost.
class OwnCosts {
 public:
  /// Function that returns the strokes of a cut with one of its beginnings.
  using StrokesOf = std::function<std::vector<Stroke>(const Beginning&)>;

  /// Makes an object without known times.
  /// @param machine limits of the machine, which determine the times; must outlive this object
  explicit OwnCosts(const OrderWish& machine);

  /// Sets the own cost of each beginning of a cut that has several beginnings.
  void find(UnbegunCut& cut, const LayerPlan& layer, const StrokesOf& strokes_of);

 private:
  [[nodiscard]] std::uint64_t digest_of(const std::vector<Stroke>& strokes,
                                        const LayerPlan& layer) const;
  [[nodiscard]] double time_of(const std::vector<Stroke>& strokes, const LayerPlan& layer);

  const OrderWish& machine_;
  bool is_even_;  ///< Whether both axes have the same limits.
  std::size_t strokes_left_;
  /// Number of motions that may still be planned before the bound is reached.
  std::size_t motions_left_;
  /// Known times, s, by the digest of the strokes.
  std::unordered_map<std::uint64_t, double> known_s_;
};

/// Returns the own cost of a cut at any beginning. This is the cost of the listed beginning at the
/// same point, otherwise of the nearest listed beginning within the same stroke, otherwise the
/// highest cost.
[[nodiscard]] double own_cost_at(const UnbegunCut& cut, const Beginning& beginning);

}  // namespace sim::cut
