#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host-sim/cut/stroke.hpp"
#include "planner/contour/box_tree.hpp"

namespace sim::cut {

/// Finds the strokes near a point among many strokes. It measures only a few of them, however close
/// together they lie.
class Clearance {
 public:
  /// The nearest stroke and its distance.
  struct Nearest {
    double distance_mm = 0.0;
    std::size_t owner = 0;           ///< Owner of the nearest stroke, as given to add().
    std::size_t looks = 0;           ///< Number of strokes that the search measured.
    const Stroke* stroke = nullptr;  ///< The nearest stroke; null if none is within reach.
    std::uint32_t entry = 0;         ///< Index of the nearest stroke in this object.
  };

  /// Searches only within `reach_mm`.
  /// @param reach_mm above 0
  explicit Clearance(double reach_mm) : reach_mm_{reach_mm} {}
  ~Clearance() = default;
  Clearance(const Clearance&) = delete;
  Clearance& operator=(const Clearance&) = delete;

  void add(const Stroke& stroke, std::size_t owner);
  /// Prepares the searches. Call it after the last add().
  void prepare();

  /// Returns the nearest stroke. If no stroke is within reach, the distance is the reach and the
  /// owner has no meaning.
  [[nodiscard]] Nearest nearest(const Place& place) const;
  /// Returns the nearest stroke, and is faster than the other overload if the point is near the
  /// last one. Of several strokes with one owner at equal distances, it may return another one than
  /// the other overload.
  /// @param last the result for the last point
  [[nodiscard]] Nearest nearest(const Place& place, const Nearest& last) const;

  /// Returns the owners of all strokes whose boxes come within `mm` of the box of a stroke, in no
  /// particular order.
  [[nodiscard]] std::vector<std::size_t> owners_near(const Stroke& stroke, double mm) const;

  /// Returns whether every point of a stroke is at least `min_mm` from all added strokes. The
  /// answer is exact.
  [[nodiscard]] bool is_clear(const Stroke& stroke, double min_mm) const;

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
