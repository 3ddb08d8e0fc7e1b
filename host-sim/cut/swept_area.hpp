#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "host-sim/cut/stroke.hpp"
#include "planner/contour/curve.hpp"

namespace sim::cut {

/// The area that discs cover, stored by cells of the plane.
class SweptArea {
 public:
  /// Outside of the discs, distances to the edge are measured up to this limit, mm.
  static constexpr double kReachMm = 0.25;

  void add(const Place& centre, double radius_mm);

  /// Returns the depth of a point inside the covered area; negative outside, at least −kReachMm.
  /// Inside, where discs follow each other closely, it is the distance to the edge of their band.
  [[nodiscard]] double depth_of(const Place& place) const;

 private:
  struct Disc {
    Place centre;
    double radius_mm;
  };
  /// The box of the centres of some discs, and their greatest radius.
  struct Group {
    cnc::contour::FlatBox<double> centres{};
    double widest_mm = 0.0;

    /// Returns whether a point may be deeper than `depth_mm` in a disc of the group.
    [[nodiscard]] bool may_be_deeper(const Place& place, double depth_mm) const;
    /// Returns the square of the distance between a point and the box, mm².
    [[nodiscard]] double squared_distance(const Place& place) const;
  };
  /// Discs in the order in which they were added, so that neighbours are near each other.
  struct Cell {
    std::vector<Disc> discs{};
    /// Groups of discs. Each holds kGroup discs; the last may hold fewer.
    std::vector<Group> groups{};
  };
  static constexpr double kCellMm = 0.5;
  static constexpr std::size_t kGroup = 16;

  [[nodiscard]] static std::int64_t cell_of(double mm);
  [[nodiscard]] static std::int64_t key_of(std::int64_t column, std::int64_t row);
  template <typename Visit>
  void visit_groups(const Place& place, const Visit& visit) const;

  double widest_mm_ = 0.0;
  std::unordered_map<std::int64_t, Cell> cells_;
};

}  // namespace sim::cut
