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

/// Finds how the time of a cut depends on its beginning: at a corner the machine stands where it
/// would have slowed down anyway, in the middle of an edge it stands once more.
///
/// Times are those of ControllerClock, from the end of the rapid to the end of the cut. Cuts with
/// the same strokes share them, those that are turned by a quarter too where both axes have the
/// same limits. The work is
/// bounded by numbers of strokes, so that results are the same on every machine; a cut that comes
/// after that costs the same with all its beginnings.
class OwnCosts {
 public:
  /// Returns the strokes of a cut with one of its beginnings.
  using StrokesOf = std::function<std::vector<Stroke>(const Beginning&)>;

  /// @param machine must outlive this
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
  std::size_t motions_left_;                           ///< That may be planned.
  std::unordered_map<std::uint64_t, double> known_s_;  ///< Times by digest.
};

/// Returns the cost of a cut itself wherever it begins: as with the listed beginning there, or with
/// the nearest one within the same stroke, or else with the most expensive.
[[nodiscard]] double own_cost_at(const UnbegunCut& cut, const Beginning& beginning);

}  // namespace sim::cut
