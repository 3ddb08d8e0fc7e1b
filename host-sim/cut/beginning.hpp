#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host-sim/cut/lead.hpp"

namespace sim::cut {

/// Requirements on the beginnings of a cut.
struct BeginningWish {
  StartAt where = StartAt::kAny;
  std::size_t count = 16;  ///< Approximate number of beginnings. At least one is found.
  /// Distance along the loop to the only permitted beginning, mm. Without a value, every beginning
  /// is permitted.
  std::optional<double> marked_mm{};
};

/// Returns the beginning of a cut that is chosen without regard to other cuts. It is in the middle
/// of the longest stroke that has free space for the leads, or otherwise at the end of a stroke.
/// The leads may be shortened to an eighth of their length before they are left out.
[[nodiscard]] Beginning usual_beginning(const MeasuredRow& loop,
                                        const LayerSettings& settings,
                                        const LeadRoom& room);

/// Returns beginnings of a closed loop with the part on its left, at least one. The leads of all
/// beginnings have the same share of the set length. It is the greatest of the shares 1, 1/2, 1/4
/// and 1/8 for which any beginning has free space. The usual beginning comes first if its leads
/// have this share. If no lead has free space, the beginnings have no leads.
[[nodiscard]] std::vector<Beginning> beginnings_of(const MeasuredRow& loop,
                                                   const LayerSettings& settings,
                                                   const LeadRoom& room,
                                                   const BeginningWish& wish);

/// Returns beginnings of a loop that is cut on its line. They have no leads. The start of the loop
/// comes first.
[[nodiscard]] std::vector<Beginning> beginnings_on_line(const MeasuredRow& loop,
                                                        const LayerSettings& settings,
                                                        const BeginningWish& wish);

/// Returns both directions of an open line as beginnings, the direction in which it is drawn first.
[[nodiscard]] std::vector<Beginning> beginnings_of_line(const MeasuredRow& line);

/// Returns a copy of a beginning at another point of the loop. Does not check that the leads have
/// free space at this point.
/// @param way_mm distance along the loop to the new point
[[nodiscard]] Beginning moved_to(const Beginning& beginning,
                                 const MeasuredRow& loop,
                                 const LayerSettings& settings,
                                 double way_mm);

}  // namespace sim::cut
