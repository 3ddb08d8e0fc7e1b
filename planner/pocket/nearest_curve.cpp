#include "planner/pocket/nearest_curve.hpp"

#include <cmath>

#include "planner/pocket/loop_measures.hpp"
#include "planner/pocket/nearest_point.hpp"

namespace cnc::pocket {

template <typename Scalar>
bool NearestCurve<Scalar>::read(const contour::ContourView<Scalar>& contour) {
  count_ = 0;
  if (contour.vertices.size() > curves_.size()) return false;
  if (contour::BoxTree<Scalar>::size_for(contour.vertices.size()) > boxes_.size()) return false;
  for (std::size_t loop = 0; loop < contour.loop_ends.size(); ++loop) {
    for (std::uint32_t i = contour.loop_begin(loop); i < contour.loop_ends[loop]; ++i) {
      const LoopElement<Scalar> element = element_at(contour, loop, i);
      contour::Curve<Scalar>& curve = curves_[count_];
      if (!make_curve(element, curve)) {
        curve = {};
        curve.start = curve.end = element.start;
      }
      tree_.leaf(count_) = curve.box();
      ++count_;
    }
  }
  tree_.build(count_);
  return true;
}

template <typename Scalar>
NearestPoint<Scalar> NearestCurve<Scalar>::nearest_to(const BasicVec2<Scalar>& place,
                                                      std::uint32_t guess) const {
  std::uint32_t best = guess;
  Scalar distance = curves_[best].distance(place);
  const auto may_be_nearer = [&](const contour::FlatBox<Scalar>& box) {
    return square_to_box(box, place) < distance * distance;
  };
  tree_.search_where(may_be_nearer, 0, [&](std::uint32_t index) {
    const Scalar found = curves_[index].distance(place);
    if (found < distance) {
      distance = found;
      best = index;
    }
    return true;
  });
  return {nearest_point_of(curves_[best], place), distance, best};
}

template class NearestCurve<double>;

}  // namespace cnc::pocket
