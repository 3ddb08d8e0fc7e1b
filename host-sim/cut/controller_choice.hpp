#pragma once

#include <cstddef>
#include <string>

#include "host-sim/cut/lead.hpp"
#include "host-sim/cut/outlines.hpp"
#include "host-sim/cut/unbegun_cut.hpp"

namespace sim::cut {

/// Returns the reason why a controller cannot compute the compensated path of a cut. The text is
/// empty if no reason is known. Even then, the controller may fail to compute the path.
/// @param loops number of cuts of the same contour
[[nodiscard]] std::string reason_against_controller(const UnbegunCut& cut,
                                                    bool is_hole,
                                                    std::size_t loops);

/// Removes the beginnings of a cut from which the controller cannot compute the path. If no
/// beginning would be left, removes none.
/// @pre reason_against_controller() returned no reason
void keep_what_the_controller_finds(UnbegunCut& cut, const Outline& outline, const LeadRoom& room);

}  // namespace sim::cut
