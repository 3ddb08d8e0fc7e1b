#include "planner/pocket/paper_pocket.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "planner/contour/moved_curve.hpp"
#include "planner/pocket/full_meetings.hpp"
#include "planner/pocket/loop_measures.hpp"

namespace cnc::pocket {
namespace {

using contour::Curve;

/// Sine of the turn between two elements below which they count as joined with one tangent.
constexpr double kOneTangent = 1.0e-9;

/// The loops of paper 5 inside one wall.
template <typename Scalar>
class PaperLoops {
 public:
  using Vector = BasicVec2<Scalar>;

  PaperLoops(contour::Slice<Curve<Scalar>> elements, std::uint32_t count, Scalar slant_factor)
      : elements_{elements}, count_{count}, slant_factor_{slant_factor} {}

  [[nodiscard]] std::uint32_t count() const { return count_; }

  /// Returns element `index` moved inwards; nothing if it is an arc whose radius is not greater
  /// than the distance.
  [[nodiscard]] std::optional<Curve<Scalar>> moved(std::uint32_t index, Scalar distance) const {
    const Curve<Scalar>& element = elements_[index];
    const Scalar inwards = -distance * stretch(element);
    if (contour::is_used_up(element, inwards)) return {};
    return contour::moved_aside(element, inwards);
  }

  /// Returns the intersection of element `before` at one distance with the next element at another
  /// distance. If there are two intersections, returns the intersection at which the path turns to
  /// the same side as at the wall.
  [[nodiscard]] std::optional<Vector> vertex(std::uint32_t before,
                                             Scalar distance,
                                             Scalar distance_of_next) const {
    const std::uint32_t next = before + 1 < count_ ? before + 1 : 0;
    const auto one = moved(before, distance);
    const auto other = moved(next, distance_of_next);
    if (!one || !other) return {};
    const Scalar turn = sine_at_wall(before, next);
    if (std::abs(turn) < Scalar{kOneTangent} && distance == distance_of_next) return one->end;
    const auto found = full_meetings(*one, *other);
    for (std::uint32_t i = 0; i < found.count; ++i) {
      const Vector& place = found.places[i];
      const Scalar sine = cross(one->tangent_at(place), other->tangent_at(place));
      if (sine * turn > Scalar{0} || found.count == 1) return place;
    }
    return {};
  }

  /// Returns sin(θ / 2), where θ is the smallest vertex angle of a loop, modulo 180°; 1 if there is
  /// no vertex.
  /// @pre is_loop(distance)
  [[nodiscard]] Scalar sharpest(Scalar distance) const {
    Scalar least{1};
    for (std::uint32_t i = 0; i < count_; ++i) {
      const std::uint32_t next = i + 1 < count_ ? i + 1 : 0;
      const Vector place = *vertex(i, distance, distance);
      const Vector in = moved(i, distance)->tangent_at(place);
      const Vector out = moved(next, distance)->tangent_at(place);
      const Scalar turn = cross(in, out);
      if (std::abs(turn) < Scalar{kOneTangent} && in.dot(out) > Scalar{0}) continue;
      // Half of the vertex angle is 90° minus half of the turn. For a vertex angle beyond 180°,
      // taken modulo 180°, it equals half of the turn.
      const Scalar sign = turn > Scalar{0} ? Scalar{1} : Scalar{-1};
      const Scalar square = Scalar{0.5} * (Scalar{1} + sign * in.dot(out));
      least = std::min(least, std::sqrt(std::max(Scalar{0}, square)));
    }
    return least;
  }

  /// Returns whether all elements exist at a distance, and follow each other in the same order as
  /// at the wall.
  [[nodiscard]] bool is_loop(Scalar distance) const {
    for (std::uint32_t i = 0; i < count_; ++i) {
      const auto from = vertex(i > 0 ? i - 1 : count_ - 1, distance, distance);
      const auto to = vertex(i, distance, distance);
      if (!from || !to) return false;
      const Curve<Scalar> element = *moved(i, distance);
      const Vector chord = *to - *from;
      const Vector along = element.tangent_at(*from) + element.tangent_at(*to);
      // If an element is half a turn, both tangents are perpendicular to the chord, so the product
      // is nearly 0.
      if (!(chord.dot(along) > -Scalar{kOneTangent} * chord.norm())) return false;
    }
    return true;
  }

 private:
  /// Returns the quotient of the distance by which the paper's program moves an element and the
  /// correct distance; 1 if the program is right.
  [[nodiscard]] Scalar stretch(const Curve<Scalar>& element) const {
    const Vector& t = element.start_tangent;
    const bool slanted = element.curvature == Scalar{0} && t.x() != Scalar{0} && t.y() != Scalar{0};
    return slanted && slant_factor_ > Scalar{0} ? slant_factor_ * std::abs(t.x()) : Scalar{1};
  }
  [[nodiscard]] Scalar sine_at_wall(std::uint32_t before, std::uint32_t next) const {
    return cross(elements_[before].end_tangent, elements_[next].start_tangent);
  }

  contour::Slice<Curve<Scalar>> elements_;
  std::uint32_t count_;
  Scalar slant_factor_;
};

/// Reads the elements of the wall. Returns the number of elements, or a fault.
template <typename Scalar>
Result<std::uint32_t, PaperFault> read_wall(const contour::ContourView<Scalar>& pocket,
                                            contour::Slice<Curve<Scalar>> elements) {
  if (pocket.loop_ends.size() != 1) return PaperFault::kNotOneLoop;
  std::uint32_t count = 0;
  for (std::uint32_t i = 0; i < pocket.loop_ends[0]; ++i) {
    const contour::Vertex<Scalar>& vertex = pocket.vertices[i];
    if (!std::isfinite(vertex.x + vertex.y + vertex.bulge)) return PaperFault::kNotANumber;
    if (count == elements.size()) return PaperFault::kTooManyElements;
    if (make_curve(element_at(pocket, 0, i), elements[count])) ++count;
  }
  if (count < 2) return PaperFault::kNotOneLoop;
  return count;
}

/// Finds the distances of all loops from the wall, beginning with the outermost loop.
template <typename Scalar>
Result<std::uint32_t, PaperFault> find_distances(const PaperLoops<Scalar>& loops,
                                                 Scalar radius,
                                                 contour::Slice<Scalar> distances) {
  std::uint32_t count = 0;
  for (Scalar distance = radius; loops.is_loop(distance);) {
    if (count == distances.size()) return PaperFault::kTooManyPasses;
    distances[count++] = distance;
    distance += radius * (Scalar{1} + loops.sharpest(distance));  // Equation 10 of paper 5.
  }
  if (count == 0) return PaperFault::kToolTooLarge;
  return count;
}

/// Writes the loops as one spiral path.
template <typename Scalar>
class SpiralWriter {
 public:
  using Vector = BasicVec2<Scalar>;

  SpiralWriter(const PaperLoops<Scalar>& loops, Scalar z, ToolPathWriter<Scalar>& out)
      : loops_{loops}, z_{z}, out_{out}, last_{loops.count() - 1} {}

  void start_at(const Vector& place) { place_ = place; }

  /// Appends all elements of a loop except the last. Returns false if the storage is full.
  [[nodiscard]] bool write_loop(Scalar distance) {
    for (std::uint32_t i = 0; i < last_; ++i) {
      if (!follow(i, distance, *loops_.vertex(i, distance, distance))) return false;
    }
    return true;
  }
  /// Appends the last element up to its intersection with the first element of the next loop.
  [[nodiscard]] bool lead_to(Scalar distance, Scalar next) {
    const auto meeting = loops_.vertex(last_, distance, next);
    if (meeting) return follow(last_, distance, *meeting);
    // Concentric circles do not intersect: a line leads to the beginning of the next loop.
    if (!follow(last_, distance, *loops_.vertex(last_, distance, distance))) return false;
    const Vector start = place_;
    place_ = *loops_.vertex(last_, next, next);
    return add(start, Scalar{0});
  }
  [[nodiscard]] bool end() { return add(place_, Scalar{0}) && out_.end_row(); }

 private:
  [[nodiscard]] bool add(const Vector& place, Scalar bulge) {
    return out_.add({place.x(), place.y(), z_, bulge, Use::kPass});
  }
  [[nodiscard]] bool follow(std::uint32_t element, Scalar distance, const Vector& to) {
    const Vector from = place_;
    place_ = to;
    return add(from, loops_.moved(element, distance)->bulge_between(from, to));
  }

  const PaperLoops<Scalar>& loops_;
  Scalar z_;
  ToolPathWriter<Scalar>& out_;
  std::uint32_t last_;
  Vector place_{Scalar{0}, Scalar{0}};
};

}  // namespace

template <typename Scalar>
Result<std::uint32_t, PaperFault> write_paper_path(const contour::ContourView<Scalar>& pocket,
                                                   const PaperTool<Scalar>& tool,
                                                   const PaperSpace<Scalar>& space,
                                                   ToolPathWriter<Scalar>& out) {
  if (!(tool.radius > Scalar{0}) || !std::isfinite(tool.radius)) return PaperFault::kNotANumber;
  const auto elements = read_wall(pocket, space.elements);
  if (!elements.ok()) return elements.error();
  const PaperLoops<Scalar> loops{space.elements, elements.value(), tool.slant_factor};
  const auto count = find_distances(loops, tool.radius, space.distances);
  if (!count.ok()) return count.error();
  SpiralWriter<Scalar> writer{loops, tool.z, out};
  const Scalar innermost = space.distances[count.value() - 1];
  writer.start_at(*loops.vertex(loops.count() - 1, innermost, innermost));
  for (std::uint32_t i = count.value(); i-- > 0;) {
    const Scalar distance = space.distances[i];
    const Scalar next = i > 0 ? space.distances[i - 1] : distance;
    if (!writer.write_loop(distance) || !writer.lead_to(distance, next)) {
      return PaperFault::kPathTooLong;
    }
  }
  if (!writer.end()) return PaperFault::kPathTooLong;
  return count;
}

template Result<std::uint32_t, PaperFault> write_paper_path(const contour::ContourView<double>&,
                                                            const PaperTool<double>&,
                                                            const PaperSpace<double>&,
                                                            ToolPathWriter<double>&);

}  // namespace cnc::pocket
