#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "host-sim/cut/stroke.hpp"

namespace sim::cut {

/// Everything that discs cover, by cells of the plane.
class SweptArea {
 public:
  /// Edges farther than this outside of a disc are not told apart, mm.
  static constexpr double kReachMm = 0.25;

  void add(const Place& centre, double radius_mm);

  /// How far a place is inside of what is covered, negative outside; −kReachMm at least. Inside,
  /// where discs follow each other closely, it is the distance to the edge of their band.
  [[nodiscard]] double depth_of(const Place& place) const;

 private:
  struct Disc {
    Place centre;
    double radius_mm;
  };
  static constexpr double kCellMm = 0.5;

  [[nodiscard]] static std::int64_t cell_of(double mm);
  [[nodiscard]] static std::int64_t key_of(std::int64_t column, std::int64_t row);

  double widest_mm_ = 0.0;
  std::unordered_map<std::int64_t, std::vector<Disc>> cells_;
};

}  // namespace sim::cut
