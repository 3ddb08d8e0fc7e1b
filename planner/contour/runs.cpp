#include "planner/contour/runs.hpp"

namespace cnc::contour {

template <typename Scalar>
std::uint32_t RunFinder<Scalar>::find() {
  connect();
  for (std::uint32_t i = 0; i < piece_count_; ++i) cancel_if_double(i);
  for (std::uint32_t i = 0; i < piece_count_; ++i) {
    const Piece& piece = space_.pieces[i];
    if (piece.dropped) continue;
    if (space_.junctions[piece.start_node].in == 0) {
      drop_from_loose_start(i);
    } else if (space_.junctions[piece.end_node].out == 0) {
      drop_to_loose_end(i);
    }
  }
  for (std::uint32_t i = 0; i < piece_count_; ++i) {
    if (!space_.junctions[space_.pieces[i].start_node].plain()) add_run(i);
  }
  // Adds the remaining runs, which are closed loops of nodes that leave no choice.
  for (std::uint32_t i = 0; i < piece_count_; ++i) add_run(i);
  return run_count_;
}

template <typename Scalar>
void RunFinder<Scalar>::connect() {
  for (std::uint32_t i = 0; i < nodes_.count(); ++i) space_.junctions[i] = {};
  for (std::uint32_t i = 0; i < piece_count_; ++i) {
    Piece& piece = space_.pieces[i];
    Junction& start = space_.junctions[piece.start_node];
    Junction& end = space_.junctions[piece.end_node];
    piece.next_out = start.first_out;
    piece.next_in = end.first_in;
    start.first_out = i;
    end.first_in = i;
    ++start.out;
    ++end.in;
  }
}

/// Drops a piece that coincides with another piece. If the two have opposite directions, both are
/// dropped: they are the sides of a slot that the offset uses up exactly. If they have the same
/// direction, one of them is dropped.
template <typename Scalar>
void RunFinder<Scalar>::cancel_if_double(std::uint32_t piece) {
  const Piece& one = space_.pieces[piece];
  if (one.dropped || space_.junctions[one.start_node].plain()) return;
  std::uint32_t other = space_.junctions[one.end_node].first_out;
  for (; other != kNone; other = space_.pieces[other].next_out) {
    const Piece& back = space_.pieces[other];
    if (back.dropped || back.end_node != one.start_node || !coincide(one, back)) continue;
    drop(piece);
    drop(other);
    return;
  }
  other = space_.junctions[one.start_node].first_out;
  for (; other != kNone; other = space_.pieces[other].next_out) {
    const Piece& twin = space_.pieces[other];
    if (other == piece || twin.dropped || twin.end_node != one.end_node) continue;
    if (!coincide(one, twin)) continue;
    drop(piece);
    return;
  }
}

template <typename Scalar>
bool RunFinder<Scalar>::coincide(const Piece& a, const Piece& b) const {
  const BasicVec2<Scalar> middle =
      space_.raw[a.raw].curve.middle_between(nodes_.place(a.start_node), nodes_.place(a.end_node));
  const Curve<Scalar>& other = space_.raw[b.raw].curve;
  return other.faces(middle, Scalar{0}) &&
         other.from_circle(middle) <= Scalar{4} * tolerance_.touch;
}

template <typename Scalar>
void RunFinder<Scalar>::drop(std::uint32_t piece) {
  space_.pieces[piece].dropped = true;
  --space_.junctions[space_.pieces[piece].start_node].out;
  --space_.junctions[space_.pieces[piece].end_node].in;
}

// Drops the pieces from a loose start on. A curve has a loose end only if its neighbour is nearer
// to the input at that end. From there the curve is too near to the input until it meets another
// curve.
template <typename Scalar>
void RunFinder<Scalar>::drop_from_loose_start(std::uint32_t piece) {
  while (piece != kNone) {
    const std::uint32_t next = following(piece);
    drop(piece);
    piece = next;
  }
}

template <typename Scalar>
void RunFinder<Scalar>::drop_to_loose_end(std::uint32_t piece) {
  while (piece != kNone) {
    const std::uint32_t node = space_.pieces[piece].start_node;
    const std::uint32_t next = space_.junctions[node].plain() ? only_in(node) : kNone;
    drop(piece);
    piece = next;
  }
}

/// Returns the piece after `piece` if no other piece meets at the node between them; kNone
/// otherwise.
template <typename Scalar>
std::uint32_t RunFinder<Scalar>::following(std::uint32_t piece) const {
  const Junction& end = space_.junctions[space_.pieces[piece].end_node];
  if (!end.plain()) return kNone;
  std::uint32_t next = end.first_out;
  while (space_.pieces[next].dropped) next = space_.pieces[next].next_out;
  return next;
}

template <typename Scalar>
std::uint32_t RunFinder<Scalar>::only_in(std::uint32_t node) const {
  std::uint32_t piece = space_.junctions[node].first_in;
  while (space_.pieces[piece].dropped) piece = space_.pieces[piece].next_in;
  return piece;
}

template <typename Scalar>
void RunFinder<Scalar>::add_run(std::uint32_t piece) {
  if (space_.pieces[piece].dropped || space_.pieces[piece].in_run) return;
  Run run;
  run.first_piece = piece;
  run.start_node = space_.pieces[piece].start_node;
  while (piece != kNone) {
    Piece& part = space_.pieces[piece];
    part.in_run = true;
    run.end_node = part.end_node;
    piece = following(piece);
    if (piece != kNone && space_.pieces[piece].in_run) piece = kNone;
    part.next = piece;
  }
  space_.runs[run_count_++] = run;
}

template class RunFinder<float>;
template class RunFinder<double>;

}  // namespace cnc::contour
