#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host-sim/cut/free_leg.hpp"

namespace sim::cut {

/// Leads rapids round areas.
class RapidRouter {
 public:
  /// What rapids keep to.
  struct Rules {
    double clearance_mm = 0.5;  ///< Distance from areas, above 0; a gap may leave less.
    double depth_mm = 0.01;     ///< Less than this inside of an area is its edge.
    Place lowest{0.0, 0.0};     ///< Corners left of or below it only where there is no other way.
  };

  /// @param areas what is not to be crossed, as it is at the time of each find()
  RapidRouter(const FreedAreas& areas, const Rules& rules) : areas_{&areas}, rules_{rules} {}

  /// Returns all places of the way of a rapid, its ends included: nearly the shortest one that
  /// keeps the clearance, or a quarter or a sixteenth of it where there is no other. None where an
  /// end is in an area, there is no way, or it takes more than some ten thousand trials.
  /// @param just_cut the area whose edge the beam has just cut; from inside of it or beside it the
  /// rapid leaves by the shortest way, and does not come back
  [[nodiscard]] std::vector<Place> find(const Place& from,
                                        const Place& to,
                                        std::optional<std::uint32_t> just_cut) const;

 private:
  /// One try: what is free, and how far left and down corners may be.
  struct Try {
    FreeLegs legs;
    Place lowest;
    bool was_bounded = false;  ///< A corner was left out for that.
  };
  [[nodiscard]] static std::vector<Place> search(Try& t, const RapidEnd& from, const RapidEnd& to);
  [[nodiscard]] static std::vector<Place> find(Try& t, const RapidEnd& from, const RapidEnd& to);
  [[nodiscard]] std::vector<Place> find_out(Try& t,
                                            const RapidEnd& from,
                                            const RapidEnd& to,
                                            std::uint32_t just_cut) const;

  const FreedAreas* areas_;
  Rules rules_;
};

}  // namespace sim::cut
