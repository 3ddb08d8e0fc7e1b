#pragma once

#include <concepts>

#include "planner/base/result.hpp"
#include "planner/base/units.hpp"
#include "planner/geometry/vector.hpp"

namespace cnc {

enum class ArcError {
  /// The ends are closer than `kShortestChord`: rounding determines the direction of the chord.
  kChordTooShort,
  kSweepTooLarge,  ///< |bulge| > 1: the arc has more than half a turn and must be split first.
};

/// A circular arc of at most half a turn, the only primitive of a tool path.
///
/// A straight line is an arc with bulge 0, so later stages need no separate case for lines.
///
/// An arc is stored as end points plus bulge b = tan(sweep / 4), positive to the left, rather than
/// as centre and angles. So end points stay bit-exact when arcs are joined, and a nearly straight
/// arc has no far-away centre that loses digits. With h = sweep / 2: sin h = 2b / (1 + b²), cos h =
/// (1 − b²) / (1 + b²), and the chord is 2 R sin h.
///
/// The controller computes with `Arc`, and path makers on the host compute with `WideArc`. Angles
/// and lengths exist for `Arc` only, because they need an arc tangent.
template <std::floating_point Scalar>
class BasicArc {
 public:
  using Vector = BasicVec2<Scalar>;

  /// Shortest chord of an arc. In double precision the limit is smaller, in proportion to the
  /// resolution.
  /// NOLINTNEXTLINE(bugprone-dynamic-static-initializers): constant in each instantiation.
  // NOLINTNEXTLINE(bugprone-dynamic-static-initializers): constant in each instantiation.
  static constexpr Length kShortestChord{sizeof(Scalar) > sizeof(float) ? 1.0e-12F : 1.0e-6F};
  /// Greatest bulge: 1, plus an allowance for a half turn whose bulge was computed in single
  /// precision.
  /// NOLINTNEXTLINE(bugprone-dynamic-static-initializers): constant in each instantiation.
  // NOLINTNEXTLINE(bugprone-dynamic-static-initializers): constant in each instantiation.
  static constexpr Scalar kLargestBulge = Scalar{1.0F + 1.0e-5F};

  [[nodiscard]] static Result<BasicArc, ArcError> make(const Vector& start,
                                                       const Vector& end,
                                                       Scalar bulge);

  [[nodiscard]] const Vector& start() const { return start_; }
  [[nodiscard]] const Vector& end() const { return end_; }
  [[nodiscard]] Scalar bulge() const { return bulge_; }

  /// Returns the curvature in 1/mm, positive if the arc turns left. It is exactly 0 for a line.
  [[nodiscard]] Scalar curvature() const;

  /// Returns half the sweep in radians, with the sign of the bulge.
  [[nodiscard]] Scalar half_sweep() const requires std::same_as<Scalar, float>;

  /// Returns the length of the arc. The relative error is below 1e-6 for every legal bulge
  /// (arc_test.cpp, LengthAgreesWithDoublePrecision).
  [[nodiscard]] Length length() const requires std::same_as<Scalar, float>;

  /// Returns the unit direction of travel at the start of the arc, or at its end.
  [[nodiscard]] Vector start_tangent() const;
  [[nodiscard]] Vector end_tangent() const;

  /// Returns the same curve, travelled in the opposite direction.
  [[nodiscard]] BasicArc reversed() const;

 private:
  BasicArc(const Vector& start, const Vector& end, Scalar bulge)
      : start_{start}, end_{end}, bulge_{bulge} {}
  [[nodiscard]] Vector chord_turned_by_half_sweep(Scalar direction) const;

  Vector start_;
  Vector end_;
  Scalar bulge_;
};

using Arc = BasicArc<float>;
using WideArc = BasicArc<double>;

extern template class BasicArc<float>;
extern template class BasicArc<double>;

}  // namespace cnc
