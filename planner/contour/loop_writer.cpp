#include "planner/contour/loop_writer.hpp"

#include <cmath>

namespace cnc::contour {

template <typename Scalar>
bool LoopWriter<Scalar>::write(std::uint32_t run_count) {
  for (std::uint32_t i = 0; i < run_count; ++i) {
    const Run& run = space_.runs[i];
    if (run.standing == Standing::kKept && !run.written && !write_loop(i)) return false;
  }
  return true;
}

template <typename Scalar>
bool LoopWriter<Scalar>::write_loop(std::uint32_t run) {
  const std::uint32_t home = space_.runs[run].start_node;
  pending_ = {};
  std::uint32_t node = kNone;
  while (node != home) {
    space_.runs[run].written = true;
    if (!write_run(space_.runs[run])) return false;
    node = space_.runs[run].end_node;
    if (node != home) run = next_run(node, pending_);
  }
  return flush() && out_.end_loop();
}

template <typename Scalar>
bool LoopWriter<Scalar>::write_run(const Run& run) {
  for (std::uint32_t i = run.first_piece; i != kNone; i = space_.pieces[i].next) {
    const Piece& part = space_.pieces[i];
    if (pending_.raw == part.raw && pending_.end_node == part.start_node) {
      pending_.end_node = part.end_node;
    } else {
      if (!flush()) return false;
      pending_ = part;
    }
  }
  return true;
}

template <typename Scalar>
bool LoopWriter<Scalar>::flush() {
  if (pending_.raw == kNone) return true;
  const Vector& start = nodes_.place(pending_.start_node);
  const Vector& end = nodes_.place(pending_.end_node);
  const Scalar bulge = space_.raw[pending_.raw].curve.bulge_between(start, end);
  return out_.add({start.x(), start.y(), bulge});
}

template <typename Scalar>
std::uint32_t LoopWriter<Scalar>::next_run(std::uint32_t node, const Piece& arriving) const {
  const Curve<Scalar>& curve = space_.raw[arriving.raw].curve;
  const Direction back{-curve.tangent_at(nodes_.place(node)), -curve.curvature};
  std::uint32_t best = kNone;
  for (std::uint32_t i = space_.junctions[node].first_out; i != kNone;
       i = space_.runs[i].next_out) {
    const Run& run = space_.runs[i];
    if (run.standing != Standing::kKept || run.written) continue;
    if (best == kNone || comes_first(back, leaving(run), leaving(space_.runs[best]))) best = i;
  }
  CNC_ASSERT(best != kNone);
  return best;
}

template <typename Scalar>
typename LoopWriter<Scalar>::Direction LoopWriter<Scalar>::leaving(const Run& run) const {
  const Curve<Scalar>& curve = space_.raw[space_.pieces[run.first_piece].raw].curve;
  return {curve.tangent_at(nodes_.place(run.start_node)), curve.curvature};
}

/// Returns a measure that grows from 0 to 4 with the clockwise angle from the direction `back` to
/// `way`. If the two directions agree, the measure is 0 if `way` bends more to the right than
/// `back`, and 4 otherwise.
template <typename Scalar>
Scalar LoopWriter<Scalar>::clockwise(const Direction& back, const Direction& way) {
  constexpr Scalar kSameWay = sizeof(Scalar) > sizeof(float) ? Scalar(1.0e-6) : Scalar(1.0e-3);
  const Scalar cosine = back.tangent.dot(way.tangent);
  const Scalar sine = -cross(back.tangent, way.tangent);
  if (cosine > Scalar{0} && std::abs(sine) < kSameWay) {
    return way.curvature < back.curvature ? Scalar{0} : Scalar{4};
  }
  return sine >= Scalar{0} ? Scalar{1} - cosine : Scalar{3} + cosine;
}

template <typename Scalar>
bool LoopWriter<Scalar>::comes_first(const Direction& back,
                                     const Direction& one,
                                     const Direction& other) {
  constexpr Scalar kSameWay = sizeof(Scalar) > sizeof(float) ? Scalar(1.0e-6) : Scalar(1.0e-3);
  if (one.tangent.dot(other.tangent) > Scalar{0} &&
      std::abs(cross(one.tangent, other.tangent)) < kSameWay) {
    return one.curvature < other.curvature;
  }
  return clockwise(back, one) < clockwise(back, other);
}

template class LoopWriter<float>;
template class LoopWriter<double>;

}  // namespace cnc::contour
