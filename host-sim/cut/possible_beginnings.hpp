#pragma once

#include <cstddef>
#include <optional>

#include "host-sim/cut/lead.hpp"
#include "host-sim/cut/outlines.hpp"
#include "host-sim/cut/unbegun_cut.hpp"

namespace sim::cut {

/// Limits on the beginnings of a cut, in addition to the limits in its settings.
struct BeginningRoom {
  /// Whether this program computes the compensated path; otherwise the controller does.
  bool is_planned_here = true;
  /// A marked point of the drawing. The cut then begins only at the point nearest to the mark.
  std::optional<Place> mark{};
  std::size_t count = 16;  ///< Approximate number of beginnings.
};

/// Sets the list of a cut's beginnings. Also sets whether the cut may begin at points between them.
void find_possible_beginnings(UnbegunCut& cut,
                              const Outline& outline,
                              const LeadRoom& leads,
                              const BeginningRoom& room);

}  // namespace sim::cut
