#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "host-sim/cut/freed_areas.hpp"

namespace sim::cut {

/// An end of a rapid. A cut fixes its position, so areas may be nearer to it than the clearance.
struct RapidEnd {
  Place place{0.0, 0.0};
  /// Areas that are nearer to the end than the clearance: the number of the area, and the distance
  /// of the end from its skin, mm. The distance is negative inside the area.
  std::vector<std::pair<std::uint32_t, double>> near{};
};

/// Decides which straight legs of a rapid keep the clearance from areas.
class FreeLegs {
 public:
  /// Makes an object that checks legs against `areas`, which must outlive it.
  /// @param clearance_mm distance to keep, above 0
  /// @param depth_mm depth inside of an area at which a point does not yet count as inside. Points
  /// at a cut along the area may be that deep by rounding
  FreeLegs(const FreedAreas& areas, double clearance_mm, double depth_mm)
      : areas_{&areas}, clearance_mm_{clearance_mm}, depth_mm_{depth_mm} {}

  [[nodiscard]] const FreedAreas& areas() const { return *areas_; }
  [[nodiscard]] double clearance_mm() const { return clearance_mm_; }
  [[nodiscard]] double depth_mm() const { return depth_mm_; }

  /// Returns the end of a rapid at the point `place`, with the areas near this point.
  [[nodiscard]] RapidEnd end_at(const Place& place) const;

  /// Returns an area other than `but` that contains the point at a depth above `depth_mm`; nothing
  /// if there is none.
  [[nodiscard]] std::optional<std::uint32_t> area_around(
      const Place& place, std::optional<std::uint32_t> but = std::nullopt) const;

  /// Returns an area that contains the point or is nearer to it than the clearance; nothing if
  /// there is none.
  [[nodiscard]] std::optional<std::uint32_t> area_at(const Place& place) const;

  /// Returns an area, other than `but`, that prevents a straight leg; nothing if the leg is free.
  /// An area prevents a leg that is nearer to it than the clearance. If an end of the leg is
  /// already nearer, the area prevents only a leg that comes even nearer than this end.
  /// @pre no end of the leg is inside of an area other than `but`
  [[nodiscard]] std::optional<std::uint32_t> blocker(
      const Place& from,
      const Place& to,
      const RapidEnd* begin,
      const RapidEnd* end,
      std::optional<std::uint32_t> but = std::nullopt) const;

 private:
  const FreedAreas* areas_;
  double clearance_mm_;
  double depth_mm_;
};

}  // namespace sim::cut
