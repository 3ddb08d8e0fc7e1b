#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/contour/outline.hpp"
#include "host-sim/cut/beginning.hpp"
#include "host-sim/cut/clearance.hpp"
#include "host-sim/cut/lead.hpp"
#include "host-sim/cut/plan.hpp"

namespace sim::cut {

inline void append_faults(std::vector<drawing::Fault>& faults,
                          const std::vector<drawing::Fault>& more) {
  faults.insert(faults.end(), more.begin(), more.end());
}

/// A plan while it is made.
struct PlanWork {
  const drawing::Drawing& drawn;
  /// Greatest distance at which edges affect each other and searches find edges: twice the widest
  /// kerf, mm.
  double reach_mm;
  Clearance edges{reach_mm};
  /// The plan. Until the order is chosen, its cuts have no strokes and are in the order of the
  /// drawing.
  CutPlan plan{};
  std::vector<UnbegunCut> unbegun{};  ///< One unbegun cut for each cut of the plan.
  std::vector<Outline> outlines{};    ///< Outline of each contour; empty if the contour is not cut.

  [[nodiscard]] const LayerPlan& layer_of(std::size_t contour) const {
    return plan.recipes.of(contour, plan.layers[drawn.contours[contour].entity.layer]);
  }
  [[nodiscard]] double half_kerf(std::size_t contour) const {
    return 0.5 * layer_of(contour).condition.kerf_mm;
  }
  [[nodiscard]] LeadRoom room_of(std::size_t contour) const { return {edges, half_kerf(contour)}; }
};

}  // namespace sim::cut
