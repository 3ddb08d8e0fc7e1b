#pragma once

#include <array>
#include <cstdint>

#include "planner/contour/curve.hpp"

namespace cnc::contour {

/// Where two curves cross or touch; curves that run on top of each other have
/// no such places.
template <typename Scalar>
struct Meetings {
  std::array<BasicVec2<Scalar>, 2> places{BasicVec2<Scalar>{Scalar{0}, Scalar{0}},
                                          BasicVec2<Scalar>{Scalar{0}, Scalar{0}}};
  std::uint32_t count = 0;
};

/// The places that are on both curves within `touch` mm. Where the circles miss
/// each other by less, the place between them counts.
template <typename Scalar>
[[nodiscard]] Meetings<Scalar> meetings_of(const Curve<Scalar>& a,
                                           const Curve<Scalar>& b,
                                           Scalar touch);

}  // namespace cnc::contour
