#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "host-sim/cut/stroke.hpp"
#include "planner/contour/curve.hpp"

namespace sim::cut {

/// The area that many discs cover. It stores the discs in cells of the plane.
class SweptArea {
 public:
  /// Greatest distance that depth_of() measures outside of the discs, mm.
  static constexpr double kReachMm = 0.25;

  void add(const Place& centre, double radius_mm);

  /// Returns the depth of a point inside the covered area, mm; negative outside, but at least
  /// −kReachMm. Where discs follow each other closely, the depth is the distance to the edge of the
  /// band that they cover.
  [[nodiscard]] double depth_of(const Place& place) const;

 private:
  struct Disc {
    Place centre;
    double radius_mm;
  };
  /// A group of discs: the box around their centres, and their greatest radius.
  struct Group {
    cnc::contour::FlatBox<double> centres{};
    double widest_mm = 0.0;

    /// Returns whether a point may be deeper than `depth_mm` in any disc of the group.
    [[nodiscard]] bool may_be_deeper(const Place& place, double depth_mm) const;
    /// Returns the square of the distance between a point and the box of centres, mm².
    [[nodiscard]] double squared_distance(const Place& place) const;
  };
  /// The discs of one cell, in the order in which they were added, so that discs with adjacent
  /// numbers are near each other.
  struct Cell {
    std::vector<Disc> discs{};
    /// Groups of kGroup consecutive discs; the last group may have fewer.
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
