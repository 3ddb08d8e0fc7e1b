#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host-sim/cut/free_leg.hpp"

namespace sim::cut {

/// Finds paths for rapids around areas.
class RapidRouter {
 public:
  /// Rules that the paths of rapids satisfy.
  struct Rules {
    double clearance_mm = 0.5;  ///< Distance from areas, above 0. In a gap it may be less.
    /// Depth inside an area up to which a point counts as on the edge.
    double depth_mm = 0.01;
    /// Corners to the left of this point, or below it, are used only if there is no other path.
    Place lowest{0.0, 0.0};
  };

  /// Makes a router around `areas`. Each call of find() uses the areas that exist at that time.
  RapidRouter(const FreedAreas& areas, const Rules& rules) : areas_{&areas}, rules_{rules} {}

  /// Returns all points of the path of a rapid, including its ends. The path is nearly the shortest
  /// one that keeps the clearance. If no path keeps it, the returned path keeps a quarter or a
  /// sixteenth of the clearance. The result is empty if an end is in an area, if there is no path,
  /// or if the search would require more than some ten thousand trials.
  /// @param just_cut the area whose edge the beam has just cut. From inside or near this area the
  /// rapid leaves by the shortest path, and does not come back
  [[nodiscard]] std::vector<Place> find(const Place& from,
                                        const Place& to,
                                        std::optional<std::uint32_t> just_cut) const;

 private:
  /// One try of a search. `legs` decides which legs are free. Corners to the left of `lowest`, or
  /// below it, are not used.
  struct Try {
    FreeLegs legs;
    Place lowest;
    bool was_bounded = false;  ///< Whether the search left out a corner by the rule of `lowest`.
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
