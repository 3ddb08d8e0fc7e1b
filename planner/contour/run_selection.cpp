#include "planner/contour/run_selection.hpp"

namespace cnc::contour {

template <typename Scalar>
bool RunSelection<Scalar>::select(std::uint32_t element_count, std::uint32_t run_count) {
  run_count_ = run_count;
  for (std::uint32_t i = 0; i < element_count; ++i) tree_.leaf(i) = space_.elements[i].box();
  tree_.build(element_count);
  for (std::uint32_t i = 0; i < run_count; ++i) space_.runs[i].standing = judge(space_.runs[i]);
  connect();
  for (std::uint32_t i = 0; i < nodes_.count(); ++i) {
    while (space_.junctions[i].in > space_.junctions[i].out) {
      if (!lead_on(i)) return false;
    }
  }
  for (std::uint32_t i = 0; i < nodes_.count(); ++i) {
    if (space_.junctions[i].in != space_.junctions[i].out) return false;
  }
  return true;
}

/// Returns the standing of a run, judged by the middle of its longest piece. That point is farthest
/// from the nodes at which other runs begin.
template <typename Scalar>
Standing RunSelection<Scalar>::judge(const Run& run) const {
  Scalar longest{};
  Vector middle{Scalar{0}, Scalar{0}};
  for (std::uint32_t i = run.first_piece; i != kNone; i = space_.pieces[i].next) {
    const Piece& part = space_.pieces[i];
    const Vector& start = nodes_.place(part.start_node);
    const Vector& end = nodes_.place(part.end_node);
    const Scalar length = (end - start).squaredNorm();
    if (length > longest) {
      longest = length;
      middle = space_.raw[part.raw].curve.middle_between(start, end);
    }
  }
  const Scalar excess = excess_nearness(middle);
  if (excess > tolerance_.shallow) return Standing::kDropped;
  const bool brief = longest <= tolerance_.brief * tolerance_.brief;
  return brief || excess > tolerance_.touch ? Standing::kOptional : Standing::kKept;
}

/// Returns the amount by which a point is nearer to the input than the distance, mm. Stops once the
/// result exceeds `shallow`, because the run is then dropped.
template <typename Scalar>
Scalar RunSelection<Scalar>::excess_nearness(const Vector& place) const {
  Scalar excess{};
  const FlatBox<Scalar> near{
      place.x() - distance_, place.y() - distance_, place.x() + distance_, place.y() + distance_};
  tree_.search(near, 0, [&](std::uint32_t element) {
    excess = std::max(excess, distance_ - space_.elements[element].distance(place));
    return excess <= tolerance_.shallow;
  });
  return excess;
}

template <typename Scalar>
void RunSelection<Scalar>::connect() {
  for (std::uint32_t i = 0; i < nodes_.count(); ++i) {
    Junction& junction = space_.junctions[i];
    junction.in = junction.out = 0;
    junction.first_out = kNone;
  }
  for (std::uint32_t i = 0; i < run_count_; ++i) {
    Run& run = space_.runs[i];
    Junction& start = space_.junctions[run.start_node];
    run.next_out = start.first_out;
    start.first_out = i;
    if (run.standing != Standing::kKept) continue;
    ++start.out;
    ++space_.junctions[run.end_node].in;
  }
}

template <typename Scalar>
void RunSelection<Scalar>::keep(std::uint32_t run) {
  space_.runs[run].standing = Standing::kKept;
  ++space_.junctions[space_.runs[run].start_node].out;
  ++space_.junctions[space_.runs[run].end_node].in;
}

/// Keeps the shortest path of optional runs from `node`, at which more kept runs arrive than leave,
/// to a node at which more kept runs leave than arrive. Visits each node at most once.
template <typename Scalar>
bool RunSelection<Scalar>::lead_on(std::uint32_t node) {
  std::uint32_t seen = 0;
  std::uint32_t waiting = 0;
  space_.queue[waiting++] = node;
  space_.junctions[node].reached_by = node;  // Any value except kNone marks the node as reached.
  while (seen < waiting) {
    const std::uint32_t from = space_.queue[seen++];
    for (std::uint32_t i = space_.junctions[from].first_out; i != kNone;
         i = space_.runs[i].next_out) {
      const std::uint32_t to = space_.runs[i].end_node;
      if (space_.runs[i].standing != Standing::kOptional) continue;
      if (space_.junctions[to].reached_by != kNone) continue;
      space_.junctions[to].reached_by = i;
      space_.queue[waiting++] = to;
      if (space_.junctions[to].in >= space_.junctions[to].out) continue;
      for (std::uint32_t back = to; back != node;) {
        const std::uint32_t run = space_.junctions[back].reached_by;
        keep(run);
        back = space_.runs[run].start_node;
      }
      forget(waiting);
      return true;
    }
  }
  forget(waiting);
  return false;
}

template <typename Scalar>
void RunSelection<Scalar>::forget(std::uint32_t reached) {
  for (std::uint32_t i = 0; i < reached; ++i) {
    space_.junctions[space_.queue[i]].reached_by = kNone;
  }
}

template class RunSelection<float>;
template class RunSelection<double>;

}  // namespace cnc::contour
