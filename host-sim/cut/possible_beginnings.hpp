#pragma once

#include <cstddef>
#include <optional>

#include "host-sim/cut/lead.hpp"
#include "host-sim/cut/outlines.hpp"
#include "host-sim/cut/unbegun_cut.hpp"

namespace sim::cut {

/// Limits on the beginning of a cut, in addition to those of its settings.
struct BeginningRoom {
  bool is_planned_here = true;  ///< If false, the controller computes the compensated path.
  /// A point of the drawing: the cut begins only at the point nearest to it.
  std::optional<Place> mark{};
  std::size_t count = 16;  ///< Approximate number of beginnings.
};

/// Sets the list of a cut's beginnings, and whether the cut may also begin between them.
void find_possible_beginnings(UnbegunCut& cut,
                              const Outline& outline,
                              const LeadRoom& leads,
                              const BeginningRoom& room);

}  // namespace sim::cut
