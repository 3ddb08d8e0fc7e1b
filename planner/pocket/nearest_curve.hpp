#pragma once

#include <cstdint>

#include "planner/contour/box_tree.hpp"
#include "planner/contour/contour.hpp"
#include "planner/contour/offset_space.hpp"

namespace cnc::pocket {

/// The point of a contour that is nearest to a given point.
template <typename Scalar>
struct NearestPoint {
  BasicVec2<Scalar> point{Scalar{0}, Scalar{0}};
  Scalar distance{};  ///< mm.
  std::uint32_t curve = contour::kNone;
};

/// The elements of a contour, prepared for queries for the nearest point.
template <typename Scalar>
class NearestCurve {
 public:
  NearestCurve(contour::Slice<contour::Curve<Scalar>> curves,
               contour::Slice<contour::FlatBox<Scalar>> boxes)
      : curves_{curves}, boxes_{boxes}, tree_{boxes} {}

  /// Replaces the stored elements by the elements of a contour. Each vertex gives one curve; an
  /// element without length gives a point. Returns false if the storage is full.
  [[nodiscard]] bool read(const contour::ContourView<Scalar>& contour);

  [[nodiscard]] std::uint32_t size() const { return count_; }
  [[nodiscard]] const contour::Curve<Scalar>& operator[](std::uint32_t index) const {
    return curves_[index];
  }

  /// Returns the point nearest to `place`. Time: log n.
  /// @param guess  index of a curve that is probably near to `place`; a good guess saves time
  /// @pre guess < size()
  [[nodiscard]] NearestPoint<Scalar> nearest_to(const BasicVec2<Scalar>& place,
                                                std::uint32_t guess = 0) const;

  /// Calls `visit(index)` for each curve whose box overlaps `box`, until a call returns false.
  template <typename Visit>
  void search(const contour::FlatBox<Scalar>& box, Visit&& visit) const {
    tree_.search(box, 0, visit);
  }

 private:
  contour::Slice<contour::Curve<Scalar>> curves_;
  contour::Slice<contour::FlatBox<Scalar>> boxes_;
  contour::BoxTree<Scalar> tree_;
  std::uint32_t count_ = 0;
};

}  // namespace cnc::pocket
