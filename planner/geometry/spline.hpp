#pragma once

#include <array>
#include <cstddef>

#include "planner/base/contract.hpp"
#include "planner/base/coordinate.hpp"
#include "planner/geometry/bezier.hpp"

namespace cnc {

/// A control point of a spline, which attracts the curve in proportion to its weight.
struct ControlPoint {
  /// Position relative to the first control point, in nm; each coordinate within 2 km.
  PlanePlace place{};
  float weight = 1.0F;  ///< Weight, kMinWeight…kMaxWeight.
};

/// A rational B-spline (NURBS) in the X Y plane over uniform knots. It is clamped at both ends: it
/// begins in the first control point and ends in the last.
///
/// A spline with as many control points as its order is a rational Bézier curve. So the curves of
/// G5 and G5.1 are splines, too.
///
/// The knots are those of LinuxCNC's G5.2: 0 repeated order() times, then 1, 2, …, and the last
/// knot repeated order() times.
class Spline {
 public:
  static constexpr std::size_t kMaxPoints = 64;
  static constexpr std::size_t kLowestOrder = 3;
  static constexpr std::size_t kHighestOrder = Bezier::kHighestDegree + 1;
  static constexpr float kMinWeight = 1.0e-3F;
  static constexpr float kMaxWeight = 1.0e3F;

  void clear() { size_ = 0; }
  [[nodiscard]] bool full() const { return size_ == kMaxPoints; }
  /// Appends a control point. The first control point is the origin of all others. @pre !full()
  void append(const ControlPoint& point) {
    CNC_ASSERT(size_ < kMaxPoints);
    points_[size_++] = point;
  }
  /// Sets the weight of the first control point. @pre size() > 0
  void set_first_weight(float weight) {
    CNC_ASSERT(size_ > 0);
    points_[0].weight = weight;
  }
  /// Sets the order of the spline, which is its degree + 1. @pre kLowestOrder ≤ order ≤
  /// kHighestOrder
  void set_order(std::size_t order) {
    CNC_ASSERT(order >= kLowestOrder && order <= kHighestOrder);
    order_ = order;
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t order() const { return order_; }
  [[nodiscard]] const ControlPoint& point(std::size_t index) const { return points_[index]; }
  /// Returns whether the points define a curve: there are at least as many control points as the
  /// order.
  [[nodiscard]] bool complete() const { return size_ >= order_; }

  /// Returns the number of Bézier curves of which the spline consists. @pre complete()
  [[nodiscard]] std::size_t segment_count() const { return size_ - order_ + 1; }
  /// Returns a segment as a Bézier curve, by knot insertion (Böhm 1980) in the form of blossoms.
  /// Control point m of the segment between the knots a and b is f(a…a, b…b) with b repeated m
  /// times.
  /// @pre index < segment_count()
  [[nodiscard]] Bezier segment(std::size_t index) const;

 private:
  [[nodiscard]] float knot(std::size_t index) const;
  [[nodiscard]] WeightedPoint blossom(std::size_t segment, std::size_t times_end) const;

  std::array<ControlPoint, kMaxPoints> points_{};
  std::size_t size_ = 0;
  std::size_t order_ = kLowestOrder;
};

}  // namespace cnc
