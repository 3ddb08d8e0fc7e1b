#pragma once

#include <cstddef>
#include <string>

#include "host-sim/cut/lead.hpp"
#include "host-sim/cut/outlines.hpp"
#include "host-sim/cut/unbegun_cut.hpp"

namespace sim::cut {

/// Returns why a controller cannot find the way of a cut beside its line itself; empty where it
/// may be able to.
/// @param loops number of cuts of the same contour
[[nodiscard]] std::string reason_against_controller(const UnbegunCut& cut,
                                                    bool is_hole,
                                                    std::size_t loops);

/// Leaves out beginnings from which the controller does not find its way, unless that is all.
/// @pre there is no reason against the controller
void keep_what_the_controller_finds(UnbegunCut& cut, const Outline& outline, const LeadRoom& room);

}  // namespace sim::cut
