#pragma once

#include <cstddef>
#include <optional>

#include "host-sim/cut/lead.hpp"
#include "host-sim/cut/outlines.hpp"
#include "host-sim/cut/unbegun_cut.hpp"

namespace sim::cut {

/// Limits on where a cut may begin, beside those of its settings.
struct BeginningRoom {
  bool is_planned_here = true;  ///< Else the controller finds the way beside the contour.
  std::optional<Place> mark{};  ///< In the drawing: nearest to it, and nowhere else.
  std::size_t count = 16;       ///< About as many beginnings.
};

/// Gives a cut the list of its beginnings, and says whether it may begin between them, too.
void find_possible_beginnings(UnbegunCut& cut,
                              const Outline& outline,
                              const LeadRoom& leads,
                              const BeginningRoom& room);

}  // namespace sim::cut
