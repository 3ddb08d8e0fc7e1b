#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host-sim/cut/stroke.hpp"
#include "planner/contour/box_tree.hpp"

namespace sim::cut {

/// Finds what of many strokes is near a place, and measures few of them for that, however close
/// together they lie.
class Clearance {
 public:
  /// What is nearest, and how near.
  struct Nearest {
    double distance_mm = 0.0;
    std::size_t owner = 0;           ///< Of the stroke, as given to add().
    std::size_t looks = 0;           ///< Strokes that were measured for it.
    const Stroke* stroke = nullptr;  ///< Null where none is within reach.
    std::uint32_t entry = 0;         ///< The number of that stroke here.
  };

  /// Nothing farther than `reach` is looked for, mm > 0.
  explicit Clearance(double reach_mm) : reach_mm_{reach_mm} {}
  ~Clearance() = default;
  Clearance(const Clearance&) = delete;
  Clearance& operator=(const Clearance&) = delete;

  void add(const Stroke& stroke, std::size_t owner);
  /// After the last add().
  void prepare();

  /// The nearest stroke; where none is within reach, the reach and no owner that means anything.
  [[nodiscard]] Nearest nearest(const Place& place) const;
  /// The same, sooner where the place is near the last one. @param last what was nearest to it; of
  /// strokes with one owner that are equally near it may be another one
  [[nodiscard]] Nearest nearest(const Place& place, const Nearest& last) const;

  /// Returns the owners of all strokes whose boxes come within `mm` of that of a stroke, in no
  /// order that means anything.
  [[nodiscard]] std::vector<std::size_t> owners_near(const Stroke& stroke, double mm) const;

  /// Returns whether no point of a stroke is nearer than `least_mm` to any of those added, exactly.
  [[nodiscard]] bool is_clear(const Stroke& stroke, double least_mm) const;

 private:
  struct Entry {
    Stroke stroke{};
    std::size_t owner = 0;
  };
  using Box = cnc::contour::FlatBox<double>;

  [[nodiscard]] static Box box_of(const Stroke& stroke);
  [[nodiscard]] Nearest nearest_from(std::uint32_t first, const Place& place) const;
  void sort_by_place();

  double reach_mm_;
  std::vector<Entry> entries_;
  std::vector<Box> boxes_;
  cnc::contour::BoxTree<double> tree_{cnc::contour::Slice<Box>{}};
};

}  // namespace sim::cut
