#pragma once

#include <cstddef>
#include <string>

#include "host-sim/cut/lead.hpp"
#include "host-sim/cut/outlines.hpp"
#include "host-sim/cut/unbegun_cut.hpp"

namespace sim::cut {

/// Returns the reason why a controller cannot compute the compensated path of a cut itself. The
/// text is empty if it may be able to.
/// @param loops number of cuts of the same contour
[[nodiscard]] std::string reason_against_controller(const UnbegunCut& cut,
                                                    bool is_hole,
                                                    std::size_t loops);

/// Removes beginnings from which the controller cannot compute its path, unless that would remove
/// all of them.
/// @pre there is no reason against the controller
void keep_what_the_controller_finds(UnbegunCut& cut, const Outline& outline, const LeadRoom& room);

}  // namespace sim::cut
