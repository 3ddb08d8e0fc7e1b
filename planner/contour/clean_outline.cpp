#include "planner/contour/clean_outline.hpp"

#include <cmath>

namespace cnc::contour {

template <typename Scalar>
bool CleanOutline<Scalar>::read(const ContourView<Scalar>& contour, std::size_t loop) {
  begin_ = end_ = 0;
  const std::uint32_t first = contour.loop_begin(loop);
  const std::uint32_t last = contour.loop_ends[loop];
  if (first == last) return true;
  place_ = contour.vertices[first].point();
  for (std::uint32_t i = first; i < last; ++i) {
    const Vector end = contour.vertices[i + 1 < last ? i + 1 : first].point();
    if (!add(place_, end, contour.vertices[i].bulge)) return false;
  }
  close();
  return true;
}

template <typename Scalar>
bool CleanOutline<Scalar>::add(const Vector& start, const Vector& end, Scalar bulge) {
  const Vector chord = end - start;
  if (chord.norm() <= touch_) return true;
  const Scalar size = std::abs(bulge);
  if (size <= Scalar{1}) return add_half(start, end, bulge);
  const Scalar half = bulge / (Scalar{1} + std::sqrt(Scalar{1} + bulge * bulge));
  const Vector middle = Scalar{0.5} * (start + end - bulge * left_normal(chord));
  return add_half(start, middle, half) && add_half(middle, end, half);
}

template <typename Scalar>
bool CleanOutline<Scalar>::turns_back(const Vector& start,
                                      const Vector& corner,
                                      const Vector& end,
                                      Scalar bulge_in,
                                      Scalar bulge_out) const {
  const Vector in = corner - start;
  const Vector out = end - corner;
  const Scalar shorter = std::min(in.norm(), out.norm());
  const bool straight =
      std::abs(bulge_in) * in.norm() <= touch_ && std::abs(bulge_out) * out.norm() <= touch_;
  if (!straight) {
    return (end - start).norm() <= touch_ && std::abs(bulge_in + bulge_out) * shorter <= touch_;
  }
  const Scalar longer = std::max(in.norm(), out.norm());
  return in.dot(out) < Scalar{0} && std::abs(cross(in, out)) <= touch_ * longer;
}

template <typename Scalar>
bool CleanOutline<Scalar>::add_half(const Vector& start, const Vector& end, Scalar bulge) {
  Vector from = start;
  while (end_ > begin_) {
    const Vertex<Scalar>& before = kept_[end_ - 1];
    if (!turns_back(before.point(), from, end, before.bulge, bulge)) break;
    from = before.point();
    --end_;
    if ((end - from).norm() <= touch_) {
      place_ = from;
      return true;
    }
  }
  if (end_ == kept_.size()) return false;
  kept_[end_++] = {from.x(), from.y(), bulge};
  place_ = end;
  return true;
}

/// Closes the loop. The last element and the first element together may also form a path out and
/// back, which is removed. The end of the last element may differ from the start of the loop,
/// because elements that were too short between them were removed.
template <typename Scalar>
void CleanOutline<Scalar>::close() {
  while (count() >= 2) {
    const Vertex<Scalar> last = kept_[end_ - 1];
    const Vertex<Scalar> first = kept_[begin_];
    const Vector second = kept_[begin_ + 1].point();
    if ((first.point() - last.point()).norm() <= touch_) {
      --end_;
      continue;
    }
    if (!turns_back(last.point(), first.point(), second, last.bulge, first.bulge)) break;
    ++begin_;
    if ((second - last.point()).norm() > touch_) continue;
    --end_;
    if (count() > 0) {
      kept_[begin_].x = last.x;
      kept_[begin_].y = last.y;
    }
  }
  if (count() < 2) begin_ = end_ = 0;
}

template <typename Scalar>
Result<BasicArc<Scalar>, ArcError> CleanOutline<Scalar>::element(std::uint32_t index) const {
  const Vertex<Scalar>& vertex = kept_[begin_ + index];
  const std::uint32_t next = begin_ + index + 1 == end_ ? begin_ : begin_ + index + 1;
  return BasicArc<Scalar>::make(vertex.point(), kept_[next].point(), vertex.bulge);
}

template class CleanOutline<float>;
template class CleanOutline<double>;

}  // namespace cnc::contour
