#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host-sim/cut/lead.hpp"

namespace sim::cut {

/// The beginnings of a cut that are required.
struct BeginningWish {
  StartAt where = StartAt::kAny;
  std::size_t count = 16;  ///< Approximate number of beginnings; at least one is found.
  /// Distance along the loop to the only permitted beginning, mm; nothing: no such limit.
  std::optional<double> marked_mm{};
};

/// Returns the beginning of a cut whose order does not matter: in the middle of the longest stroke,
/// or otherwise at the end of a stroke, where the leads have enough free space. Leads are shortened
/// down to an eighth of their length before they are left out.
[[nodiscard]] Beginning usual_beginning(const MeasuredRow& loop,
                                        const LayerSettings& settings,
                                        const LeadRoom& room);

/// Returns beginnings of a closed loop with the part on its left, at least one. All of them have
/// leads with one share of the set length: the greatest share for which any beginning has free
/// space. The usual beginning comes first if it has that share. If no lead has free space, the
/// beginnings have no leads.
[[nodiscard]] std::vector<Beginning> beginnings_of(const MeasuredRow& loop,
                                                   const LayerSettings& settings,
                                                   const LeadRoom& room,
                                                   const BeginningWish& wish);

/// Returns beginnings of a loop that is cut on its line, without leads. The start of the loop comes
/// first.
[[nodiscard]] std::vector<Beginning> beginnings_on_line(const MeasuredRow& loop,
                                                        const LayerSettings& settings,
                                                        const BeginningWish& wish);

/// Returns both directions of an open line as beginnings. The direction in which the line is drawn
/// comes first.
[[nodiscard]] std::vector<Beginning> beginnings_of_line(const MeasuredRow& line);

/// Returns a copy of a beginning at another point of the loop, without a check whether its leads
/// have free space there.
/// @param way_mm distance along the loop to the new point
[[nodiscard]] Beginning moved_to(const Beginning& beginning,
                                 const MeasuredRow& loop,
                                 const LayerSettings& settings,
                                 double way_mm);

}  // namespace sim::cut
