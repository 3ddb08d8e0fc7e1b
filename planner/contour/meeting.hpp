#pragma once

#include <array>
#include <cstdint>

#include "planner/contour/curve.hpp"

namespace cnc::contour {

/// Points where two curves cross or touch. Curves that coincide have no such points.
template <typename Scalar>
struct Meetings {
  std::array<BasicVec2<Scalar>, 2> places{BasicVec2<Scalar>{Scalar{0}, Scalar{0}},
                                          BasicVec2<Scalar>{Scalar{0}, Scalar{0}}};
  std::uint32_t count = 0;
};

/// Returns the points that are within `touch` mm of both curves. If the two circles miss each other
/// by less than `touch`, the result contains the point between them.
template <typename Scalar>
[[nodiscard]] Meetings<Scalar> meetings_of(const Curve<Scalar>& a,
                                           const Curve<Scalar>& b,
                                           Scalar touch);

}  // namespace cnc::contour
