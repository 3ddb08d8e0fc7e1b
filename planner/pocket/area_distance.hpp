#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "planner/contour/box_tree.hpp"
#include "planner/contour/contour.hpp"
#include "planner/contour/curve.hpp"
#include "planner/contour/slice.hpp"

namespace cnc::pocket {

/// The point of an area's boundary that is nearest to a given point.
struct BoundaryPoint {
  /// Point on the boundary. If several points are equally near, it is one of them.
  WideVec2 point{0.0, 0.0};
  double distance = 0.0;  ///< Distance in mm, never negative.
  std::uint32_t element = 0;
  /// Whether the given point is in the area. For a point on the boundary the value may be true or
  /// false.
  bool inside = false;
};

/// Sizes of the storage for an AreaDistance.
struct DistanceSizes {
  std::size_t vertices;  ///< Number of vertices of the area's contours.
  std::size_t loops;

  /// Returns the greatest possible number of elements. An arc of more than half a turn counts as
  /// two elements.
  [[nodiscard]] constexpr std::size_t elements() const { return 2 * vertices; }
  [[nodiscard]] constexpr std::size_t boxes() const {
    return contour::BoxTree<double>::size_for(elements());
  }
};

/// Working storage of an AreaDistance. The storage must outlive the AreaDistance. The comment of
/// each span names the member of DistanceSizes that gives its size.
struct DistanceSpace {
  contour::Slice<contour::Vertex<double>> vertices;  ///< elements()
  contour::Slice<contour::Curve<double>> elements;   ///< elements()
  contour::Slice<contour::FlatBox<double>> boxes;    ///< boxes()
  contour::Slice<std::uint32_t> loop_ends;           ///< loops
};

/// Storage for an AreaDistance, with its capacity in the type.
template <std::size_t kVertices, std::size_t kLoops>
class BoundedDistanceSpace {
 public:
  [[nodiscard]] DistanceSpace space() { return {vertices_, elements_, boxes_, loop_ends_}; }

 private:
  // NOLINTNEXTLINE(bugprone-dynamic-static-initializers): constant in each instantiation.
  static constexpr DistanceSizes kSizes{kVertices, kLoops};
  std::array<contour::Vertex<double>, kSizes.elements()> vertices_{};
  std::array<contour::Curve<double>, kSizes.elements()> elements_{};
  std::array<contour::FlatBox<double>, kSizes.boxes()> boxes_{};
  std::array<std::uint32_t, kLoops> loop_ends_{};
};

/// Distances from the boundary of an area of lines and arcs, found with a tree of boxes.
///
/// Guarantee: the error of a distance is at most 2e-11 times the greatest coordinate, because
/// elements shorter than this are ignored. For a point farther than this error from the boundary,
/// `inside` is right. If the n elements are in the order of a contour, a search checks O(log n)
/// boxes.
class AreaDistance {
 public:
  explicit AreaDistance(const DistanceSpace& space) : space_{space}, tree_{space.boxes} {}

  /// Reads contours that have the area on their left and do not cross each other. Ignores elements
  /// without length, and paths out and back along one line.
  /// @return false if the storage is too small, or if a number is not finite
  [[nodiscard]] bool read(const contour::ContourView<double>& area);

  /// Returns the number of elements: lines, and arcs of at most half a turn. It is 0 for an area
  /// without extent.
  [[nodiscard]] std::uint32_t element_count() const { return count_; }
  /// Returns element `index`. @pre index < element_count()
  [[nodiscard]] const contour::Curve<double>& element(std::uint32_t index) const {
    return space_.elements[index];
  }
  /// Returns the index of the element that begins where element `index` ends, or of the element
  /// that ends where element `index` begins.
  [[nodiscard]] std::uint32_t next(std::uint32_t index) const;
  [[nodiscard]] std::uint32_t previous(std::uint32_t index) const;

  /// Returns the point of the boundary nearest to `place`. @pre element_count() > 0
  [[nodiscard]] BoundaryPoint nearest(const WideVec2& place) const;
  /// Returns the distance from the boundary, mm, negative outside the area.
  /// @pre element_count() > 0
  [[nodiscard]] double depth(const WideVec2& place) const {
    const BoundaryPoint found = nearest(place);
    return found.inside ? found.distance : -found.distance;
  }

  /// Calls `visit(element)` for each element whose box overlaps `box`, until a call returns false.
  template <typename Visit>
  void search(const contour::FlatBox<double>& box, Visit&& visit) const {
    tree_.search(box, 0, [&](std::uint32_t index) { return visit(space_.elements[index]); });
  }

 private:
  [[nodiscard]] bool is_inside(const WideVec2& place, std::uint32_t element) const;
  [[nodiscard]] std::uint32_t loop_of(std::uint32_t index) const;

  DistanceSpace space_;
  contour::BoxTree<double> tree_;
  std::uint32_t count_ = 0;
  std::uint32_t loop_count_ = 0;
};

}  // namespace cnc::pocket
