#include "planner/contour/curve.hpp"

namespace cnc::contour {

template <typename Scalar>
FlatBox<Scalar> Curve<Scalar>::box() const {
  FlatBox<Scalar> box{std::min(start.x(), end.x()),
                      std::min(start.y(), end.y()),
                      std::max(start.x(), end.x()),
                      std::max(start.y(), end.y())};
  if (curvature == Scalar{0}) return box;
  const Vector outwards =
      Scalar{-0.5} * bulge_between(start, end) * left_normal(Vector{end - start});
  const Vector a = start + outwards;
  const Vector b = end + outwards;
  box.include({std::min(a.x(), b.x()),
               std::min(a.y(), b.y()),
               std::max(a.x(), b.x()),
               std::max(a.y(), b.y())});
  return box;
}

template struct Curve<float>;
template struct Curve<double>;

}  // namespace cnc::contour
