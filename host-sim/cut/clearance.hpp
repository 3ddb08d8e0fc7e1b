#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host-sim/cut/stroke.hpp"

namespace sim::cut {

/// Finds what of many strokes is near a place, by cells of a grid that hold what reaches
/// into them.
class Clearance {
 public:
  /// What is nearest, and how near.
  struct Nearest {
    double distance_mm = 0.0;
    std::size_t owner = 0;  ///< Of the stroke, as given to add().
  };

  /// Nothing farther than `reach` is looked for, mm > 0.
  explicit Clearance(double reach_mm) : reach_mm_{reach_mm} {}

  void add(const Stroke& stroke, std::size_t owner);
  /// After the last add().
  void prepare();

  /// The nearest stroke; where none is within reach, the reach and no owner that means anything.
  [[nodiscard]] Nearest nearest(const Place& place) const;

  /// Whether no place of a stroke is nearer than so much to any, looked at every 20 µm.
  [[nodiscard]] bool is_clear(const Stroke& stroke, double least_mm) const;

 private:
  struct Entry {
    Stroke stroke{};
    std::size_t owner = 0;
  };
  struct Box {
    Place least;
    Place most;
  };

  [[nodiscard]] static Box box_of(const Stroke& stroke);
  [[nodiscard]] std::size_t column(double x) const;
  [[nodiscard]] std::size_t row(double y) const;

  double reach_mm_;
  double cell_mm_ = 1.0;
  Place origin_{0.0, 0.0};
  std::size_t columns_ = 0;
  std::size_t rows_ = 0;
  std::vector<Entry> entries_;
  std::vector<std::vector<std::uint32_t>> cells_;
};

}  // namespace sim::cut
