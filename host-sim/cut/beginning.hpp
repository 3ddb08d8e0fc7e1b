#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host-sim/cut/lead.hpp"

namespace sim::cut {

/// Which beginnings of a cut are of interest.
struct BeginningWish {
  StartAt where = StartAt::kAny;
  std::size_t count = 16;             ///< About as many; at least one is found.
  std::optional<double> marked_mm{};  ///< Along the loop: there and nowhere else.
};

/// Returns the beginning that a cut has where its order does not matter: in the middle of the
/// longest stroke, or else at the end of a stroke, where the leads have room. They are shortened to
/// an eighth before they are left out.
[[nodiscard]] Beginning usual_beginning(const MeasuredRow& loop,
                                        const LayerSettings& settings,
                                        const LeadRoom& room);

/// Returns beginnings of a closed loop with the part on its left, never none: all with the greatest
/// share of the leads' length that has room at any of them, the usual one first where it has that
/// share. Where no lead has room, beginnings without leads.
[[nodiscard]] std::vector<Beginning> beginnings_of(const MeasuredRow& loop,
                                                   const LayerSettings& settings,
                                                   const LeadRoom& room,
                                                   const BeginningWish& wish);

/// Returns beginnings of a loop that is cut on its line, without leads; its own start first.
[[nodiscard]] std::vector<Beginning> beginnings_on_line(const MeasuredRow& loop,
                                                        const LayerSettings& settings,
                                                        const BeginningWish& wish);

/// Returns both directions of an open line, its own first.
[[nodiscard]] std::vector<Beginning> beginnings_of_line(const MeasuredRow& line);

/// Returns the same beginning elsewhere on the loop, whether or not its leads have room there.
[[nodiscard]] Beginning moved_to(const Beginning& beginning,
                                 const MeasuredRow& loop,
                                 const LayerSettings& settings,
                                 double way_mm);

}  // namespace sim::cut
