#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "host-sim/cut/freed_areas.hpp"

namespace sim::cut {

/// An end of a rapid. Cuts fix the ends of rapids, so areas may be nearer to an end than the
/// clearance of the rest of the rapid.
struct RapidEnd {
  Place place{0.0, 0.0};
  /// Areas nearer than the clearance, each with the distance to its skin, mm. The distance is
  /// negative inside the area.
  std::vector<std::pair<std::uint32_t, double>> near{};
};

/// Decides which straight legs of a rapid keep their distance from areas.
class FreeLegs {
 public:
  /// @param clearance_mm distance to keep, above 0
  /// @param depth_mm a point less deep than this inside of an area does not count as inside; it is
  /// there by rounding, at a cut along the area
  FreeLegs(const FreedAreas& areas, double clearance_mm, double depth_mm)
      : areas_{&areas}, clearance_mm_{clearance_mm}, depth_mm_{depth_mm} {}

  [[nodiscard]] const FreedAreas& areas() const { return *areas_; }
  [[nodiscard]] double clearance_mm() const { return clearance_mm_; }
  [[nodiscard]] double depth_mm() const { return depth_mm_; }

  /// Returns the end of a rapid at a point, with the areas near it.
  [[nodiscard]] RapidEnd end_at(const Place& place) const;

  /// Returns an area other than `but` that contains the point deeper than `depth_mm`.
  [[nodiscard]] std::optional<std::uint32_t> area_around(
      const Place& place, std::optional<std::uint32_t> but = std::nullopt) const;

  /// Returns an area that contains the point or is nearer to it than the clearance.
  [[nodiscard]] std::optional<std::uint32_t> area_at(const Place& place) const;

  /// Returns an area, other than `but`, that prevents a straight leg. Such an area comes nearer
  /// than the clearance. An area that is already nearer to an end of the leg prevents it only by
  /// coming even nearer than at that end.
  /// @pre no end of the leg is inside of another area
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
