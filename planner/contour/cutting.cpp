#include "planner/contour/cutting.hpp"

#include <cmath>

namespace cnc::contour {

template <typename Scalar>
bool Cutting<Scalar>::find_meetings() {
  BoxTree<Scalar> tree{space_.raw_boxes};
  index_raw_curves(tree);
  for (std::uint32_t i = 0; i < raw_count_ && !full_; ++i) {
    tree.search(tree.leaf(i), i + 1, [&](std::uint32_t other) {
      meet(i, other);
      return !full_;
    });
  }
  return !full_;
}

template <typename Scalar>
void Cutting<Scalar>::index_raw_curves(BoxTree<Scalar>& tree) const {
  for (std::uint32_t i = 0; i < raw_count_; ++i) {
    FlatBox<Scalar> box = space_.raw[i].curve.box();
    tree.leaf(i) = {box.x0 - tolerance_.touch,
                    box.y0 - tolerance_.touch,
                    box.x1 + tolerance_.touch,
                    box.y1 + tolerance_.touch};
  }
  tree.build(raw_count_);
}

template <typename Scalar>
void Cutting<Scalar>::meet(std::uint32_t a, std::uint32_t b) {
  const RawCurve<Scalar>& first = space_.raw[a];
  const RawCurve<Scalar>& second = space_.raw[b];
  if (clear_of(first.curve, second.curve) || clear_of(second.curve, first.curve)) return;
  // Neighbours share a node, so the test below would never succeed for them. They are half of all
  // pairs.
  if (first.end_node != second.start_node &&
      (beside(first.curve, second.curve) || beside(second.curve, first.curve))) {
    return;
  }
  end_on(first.curve.start, first.start_node, b);
  end_on(first.curve.end, first.end_node, b);
  end_on(second.curve.start, second.start_node, a);
  end_on(second.curve.end, second.end_node, a);
  const Meetings<Scalar> found = meetings_of(first.curve, second.curve, tolerance_.touch);
  for (std::uint32_t i = 0; i < found.count; ++i) {
    if (!is_joint(a, b, found.places[i])) meet_at(a, b, found.places[i]);
  }
}

/// Returns whether `other`, a line, is completely on one side of the straight line through `line`.
template <typename Scalar>
bool Cutting<Scalar>::clear_of(const Curve<Scalar>& line, const Curve<Scalar>& other) const {
  if (line.curvature != Scalar{0} || other.curvature != Scalar{0}) return false;
  const Scalar start = cross(line.start_tangent, other.start - line.start);
  const Scalar end = cross(line.start_tangent, other.end - line.start);
  return std::min(start, end) > tolerance_.touch || std::max(start, end) < -tolerance_.touch;
}

/// Returns whether another curve is completely on one side of a band, with a margin such that no
/// point is within `touch` of both curves. The band is between the chord of `curve` and the
/// parallel of the chord that touches `curve`. For most pairs with an arc this test avoids the full
/// computation.
///
/// The test needs no bulge. Let x be half the sweep. The height of an arc is its chord times
/// tan(x/2) / 2, which is at most the chord times sin(x) / 2. Ends that were drawn together may be
/// some `touch` away from their curve, or may make it slightly more than half a turn. Therefore the
/// factor is 5/8 instead of 1/2, and the margin contains 16 `touch`. All distances are multiplied
/// by the chord of `curve`, which avoids a square root.
template <typename Scalar>
bool Cutting<Scalar>::beside(const Curve<Scalar>& curve, const Curve<Scalar>& other) const {
  constexpr Scalar kHeight{0.625};
  const Vector chord = curve.end - curve.start;
  const Vector far = other.end - other.start;
  const Scalar length = std::abs(chord.x()) + std::abs(chord.y());
  const Scalar height = kHeight * std::abs(cross(other.start_tangent, far));
  const Scalar slack = length * (height + Scalar{16} * tolerance_.touch);
  const Scalar start = cross(chord, other.start - curve.start);
  const Scalar end = cross(chord, other.end - curve.start);
  // A curve that turns left is on the right of its chord.
  const Scalar own = -kHeight * length * cross(chord, curve.end_tangent);
  return std::min(start, end) > std::max(Scalar{0}, own) + slack ||
         std::max(start, end) < std::min(Scalar{0}, own) - slack;
}

/// Handles `place`, an end of another curve, if it is on curve `raw`: cuts `raw` there, or unites
/// the two ends if `raw` also ends there. Overlapping curves are divided in this way.
template <typename Scalar>
void Cutting<Scalar>::end_on(const Vector& place, std::uint32_t node, std::uint32_t raw) {
  const RawCurve<Scalar>& other = space_.raw[raw];
  if (node == other.start_node || node == other.end_node) return;
  if (const std::uint32_t end = end_near(raw, place); end != kNone) {
    nodes_.unite(node, end);
  } else if (other.curve.faces(place, Scalar{0}) &&
             other.curve.from_circle(place) <= tolerance_.touch) {
    cut(raw, node, place);
  }
}

/// Returns whether a meeting of neighbours is only their joint: between the joint and the meeting
/// the two curves do not separate.
template <typename Scalar>
bool Cutting<Scalar>::is_joint(std::uint32_t a, std::uint32_t b, const Vector& place) {
  const RawCurve<Scalar>& first = space_.raw[a];
  const RawCurve<Scalar>& second = space_.raw[b];
  const auto is_end_of_second = [&](std::uint32_t node) {
    return node == second.start_node || node == second.end_node;
  };
  const auto reaches = [&](const Vector& joint) {
    if ((place - joint).norm() <= tolerance_.touch) return true;
    const bool forwards = first.curve.order_of(joint) < first.curve.order_of(place);
    const Vector middle = forwards ? first.curve.middle_between(joint, place)
                                   : first.curve.middle_between(place, joint);
    return second.curve.from_circle(middle) <= tolerance_.touch;
  };
  return (is_end_of_second(first.start_node) && reaches(first.curve.start)) ||
         (is_end_of_second(first.end_node) && reaches(first.curve.end));
}

template <typename Scalar>
void Cutting<Scalar>::meet_at(std::uint32_t a, std::uint32_t b, const Vector& place) {
  const std::uint32_t end_of_a = end_near(a, place);
  const std::uint32_t end_of_b = end_near(b, place);
  if (end_of_a != kNone && end_of_b != kNone) {
    nodes_.unite(end_of_a, end_of_b);
  } else if (end_of_a != kNone) {
    cut(b, end_of_a, place);
  } else if (end_of_b != kNone) {
    cut(a, end_of_b, place);
  } else {
    if (cut_count_ + 2 > space_.cuts.size()) {
      full_ = true;
      return;
    }
    const std::uint32_t node = nodes_.add(place);
    cut(a, node, place);
    cut(b, node, place);
  }
}

/// Returns whether two points are within `touch`. Most points already differ enough in x, which
/// avoids the square root.
template <typename Scalar>
bool Cutting<Scalar>::is_near(const Vector& one, const Vector& other) const {
  return std::abs(one.x() - other.x()) <= tolerance_.touch &&
         (one - other).norm() <= tolerance_.touch;
}

template <typename Scalar>
std::uint32_t Cutting<Scalar>::end_near(std::uint32_t raw, const Vector& place) const {
  const RawCurve<Scalar>& curve = space_.raw[raw];
  if (is_near(curve.curve.start, place)) return curve.start_node;
  if (is_near(curve.curve.end, place)) return curve.end_node;
  return kNone;
}

template <typename Scalar>
void Cutting<Scalar>::cut(std::uint32_t raw, std::uint32_t node, const Vector& place) {
  if (cut_count_ == space_.cuts.size()) {
    full_ = true;
    return;
  }
  space_.cuts[cut_count_++] = {space_.raw[raw].curve.order_of(place), raw, node};
}

template <typename Scalar>
std::uint32_t Cutting<Scalar>::divide() {
  sort_cuts();
  for (std::uint32_t i = 0; i < raw_count_; ++i) unite_neighbours(i);
  for (std::uint32_t i = 0; i < raw_count_; ++i) {
    std::uint32_t from = nodes_.find(space_.raw[i].start_node);
    for (std::uint32_t c = space_.first_cuts[i]; c < space_.first_cuts[i + 1]; ++c) {
      const std::uint32_t to = nodes_.find(space_.sorted_cuts[c].node);
      add_piece(i, from, to);
      from = to;
    }
    add_piece(i, from, nodes_.find(space_.raw[i].end_node));
  }
  return piece_count_;
}

/// Sorts the cuts by raw curve, and along each raw curve. A counting sort comes first, because most
/// raw curves have at most one cut.
template <typename Scalar>
void Cutting<Scalar>::sort_cuts() {
  for (std::uint32_t i = 0; i <= raw_count_; ++i) space_.first_cuts[i] = 0;
  for (std::uint32_t c = 0; c < cut_count_; ++c) ++space_.first_cuts[space_.cuts[c].raw];
  std::uint32_t before = 0;
  for (std::uint32_t i = 0; i <= raw_count_; ++i) {
    before += space_.first_cuts[i];
    space_.first_cuts[i] = before;
  }
  for (std::uint32_t c = cut_count_; c-- > 0;) {
    space_.sorted_cuts[--space_.first_cuts[space_.cuts[c].raw]] = space_.cuts[c];
  }
  for (std::uint32_t i = 0; i < raw_count_; ++i) {
    sort_along(space_.first_cuts[i], space_.first_cuts[i + 1]);
  }
}

/// Sorts by Shell's method, which is fast for a few cuts and takes at most n^1.5 steps for many.
template <typename Scalar>
void Cutting<Scalar>::sort_along(std::uint32_t first, std::uint32_t end) {
  const Slice<Cut<Scalar>> cuts = space_.sorted_cuts;
  std::uint32_t gap = 1;
  while (gap < (end - first) / 3) gap = 3 * gap + 1;
  for (; gap > 0; gap /= 3) {
    for (std::uint32_t i = first + gap; i < end; ++i) {
      const Cut<Scalar> moved = cuts[i];
      std::uint32_t place = i;
      for (; place >= first + gap && moved.order < cuts[place - gap].order; place -= gap) {
        cuts[place] = cuts[place - gap];
      }
      cuts[place] = moved;
    }
  }
}

template <typename Scalar>
void Cutting<Scalar>::unite_neighbours(std::uint32_t raw) {
  const Scalar close = Scalar{4} * tolerance_.touch;
  std::uint32_t before = space_.raw[raw].start_node;
  const auto pass = [&](std::uint32_t node) {
    const Vector way = nodes_.place(nodes_.find(node)) - nodes_.place(nodes_.find(before));
    if (way.norm() <= close) nodes_.unite(before, node);
    before = node;
  };
  for (std::uint32_t c = space_.first_cuts[raw]; c < space_.first_cuts[raw + 1]; ++c) {
    pass(space_.sorted_cuts[c].node);
  }
  if (space_.first_cuts[raw] < space_.first_cuts[raw + 1]) pass(space_.raw[raw].end_node);
}

template <typename Scalar>
void Cutting<Scalar>::add_piece(std::uint32_t raw,
                                std::uint32_t start_node,
                                std::uint32_t end_node) {
  if (start_node == end_node) return;
  Piece piece;
  piece.raw = raw;
  piece.start_node = start_node;
  piece.end_node = end_node;
  space_.pieces[piece_count_++] = piece;
}

template class Cutting<float>;
template class Cutting<double>;

}  // namespace cnc::contour
