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

template <typename Scalar>
Curve<Scalar> curve_of(const BasicVec2<Scalar>& start, const BasicVec2<Scalar>& end, Scalar bulge) {
  const BasicVec2<Scalar> chord = end - start;
  const Scalar length = chord.norm();
  const BasicVec2<Scalar> along = chord / length;
  if (bulge == Scalar{0}) return {start, end, along, along, Scalar{0}};
  const Scalar scale = Scalar{1} / (Scalar{1} + bulge * bulge);
  const BasicVec2<Scalar> forward = (Scalar{1} - bulge * bulge) * scale * along;
  const BasicVec2<Scalar> aside = Scalar{2} * bulge * scale * left_normal(along);
  return {start, end, forward - aside, forward + aside, Scalar{4} * bulge * scale / length};
}

template struct Curve<float>;
template struct Curve<double>;
template Curve<float> curve_of(const BasicVec2<float>&, const BasicVec2<float>&, float);
template Curve<double> curve_of(const BasicVec2<double>&, const BasicVec2<double>&, double);

}  // namespace cnc::contour
