#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "host-sim/cut/freed_areas.hpp"

namespace sim::cut {

/// An end of a rapid: cuts begin and end where they must, so that areas may be nearer to it than
/// the rest of the rapid comes.
struct RapidEnd {
  Place place{0.0, 0.0};
  /// Areas nearer than the clearance, and how far their skins are, mm; negative inside of it.
  std::vector<std::pair<std::uint32_t, double>> near{};
};

/// Which straight legs of a rapid keep their distance from areas.
class FreeLegs {
 public:
  /// @param clearance_mm distance to keep, above 0
  /// @param depth_mm less than this inside of an area is not in it: rounding, at a cut along it
  FreeLegs(const FreedAreas& areas, double clearance_mm, double depth_mm)
      : areas_{&areas}, clearance_mm_{clearance_mm}, depth_mm_{depth_mm} {}

  [[nodiscard]] const FreedAreas& areas() const { return *areas_; }
  [[nodiscard]] double clearance_mm() const { return clearance_mm_; }
  [[nodiscard]] double depth_mm() const { return depth_mm_; }

  /// Returns an end with the areas that are near.
  [[nodiscard]] RapidEnd end_at(const Place& place) const;

  /// Returns an area in which a place is, deeper than the rounding, other than `but`.
  [[nodiscard]] std::optional<std::uint32_t> area_around(
      const Place& place, std::optional<std::uint32_t> but = std::nullopt) const;

  /// Returns an area that a place is in or too near to.
  [[nodiscard]] std::optional<std::uint32_t> area_at(const Place& place) const;

  /// Returns an area, other than `but`, that keeps a straight leg from being driven: it comes too
  /// near, or nearer than those of its ends that are nearer anyway.
  /// @pre no place of the leg's ends is inside of another area
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
