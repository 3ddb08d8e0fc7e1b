#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host-sim/cut/stroke.hpp"
#include "planner/contour/box_tree.hpp"

namespace sim::cut {

/// Index of many strokes that finds the strokes near a point. A search measures only a few strokes,
/// even where many are close together.
class Clearance {
 public:
  /// The nearest stroke and its distance, as a search returns them.
  struct Nearest {
    double distance_mm = 0.0;
    /// Owner of the nearest stroke, as it was passed to add().
    std::size_t owner = 0;
    std::size_t looks = 0;           ///< Number of strokes that the search measured.
    const Stroke* stroke = nullptr;  ///< The nearest stroke; null if none is within reach.
    std::uint32_t entry = 0;         ///< Number of the nearest stroke in this index.
  };

  /// Makes an index whose searches find only strokes within `reach_mm`.
  /// @param reach_mm above 0
  explicit Clearance(double reach_mm) : reach_mm_{reach_mm} {}
  ~Clearance() = default;
  Clearance(const Clearance&) = delete;
  Clearance& operator=(const Clearance&) = delete;

  void add(const Stroke& stroke, std::size_t owner);
  /// Prepares the searches. Call it after the last add().
  void prepare();

  /// Returns the nearest stroke. If no stroke is within reach, `distance_mm` is the reach and
  /// `owner` has no meaning.
  [[nodiscard]] Nearest nearest(const Place& place) const;
  /// Returns the nearest stroke. This overload is faster than the other one if the point is near
  /// the point of the previous search. If several strokes of one owner are equally near, the
  /// overloads may return different strokes.
  /// @param last result of the previous search
  [[nodiscard]] Nearest nearest(const Place& place, const Nearest& last) const;

  /// Returns the owners of all strokes whose boxes are within `mm` of the box of `stroke`, in no
  /// particular order.
  [[nodiscard]] std::vector<std::size_t> owners_near(const Stroke& stroke, double mm) const;

  /// Returns whether every point of a stroke is at least `min_mm` from all added strokes. The
  /// result is exact.
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
