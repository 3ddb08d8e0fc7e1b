#include "planner/motion/motors/output_delay.hpp"

#include "planner/base/contract.hpp"

namespace cnc::motion {
namespace {

std::uint16_t to_level(float duty) { return static_cast<std::uint16_t>(duty * kFullOutput + 0.5F); }

/// Returns twice the energy of a piece, in duty · ticks.
std::uint32_t doubled_energy(const OutputPiece& piece) {
  return (std::uint32_t{piece.start} + piece.end) * piece.ticks;
}

}  // namespace

void OutputDelay::clear(std::uint32_t cells_held) {
  oldest_ = 0;
  count_ = 0;
  in_cell_ = 0;
  max_joinable_ = kMaxPieces - cells_held;
  tick_ = 0;
  pending_ = {};
  rate_ = {};
}

void OutputDelay::add(const PlannedSlice& slice, std::uint32_t end_tick) {
  merge(pending_, slice.outputs);
  if (end_tick == tick_) return;
  const OutputPiece piece{.ticks = static_cast<std::uint16_t>(end_tick - tick_),
                          .start = to_level(slice.start_duty),
                          .end = to_level(slice.end_duty),
                          .outputs = pending_};
  tick_ = end_tick;
  pending_ = {};
  if (joins(piece)) {
    join(piece);
  } else {
    append(piece);
  }
  rate_.pass(piece.ticks);
}

void OutputDelay::close_cell() {
  in_cell_ = 0;
  tick_ = 0;
}

OutputPiece OutputDelay::take() {
  CNC_ASSERT(count_ > 0);
  const OutputPiece piece = pieces_[oldest_];
  oldest_ = (oldest_ + 1) % kMaxPieces;
  --count_;
  return piece;
}

void OutputDelay::append(const OutputPiece& piece) {
  CNC_ASSERT(count_ < kMaxPieces);
  ++count_;
  ++in_cell_;
  pieces_[newest()] = piece;
  rate_.begin();
}

bool OutputDelay::joins(const OutputPiece& piece) const {
  if (in_cell_ == 0) return false;
  if (count_ >= max_joinable_) return true;
  if (piece.outputs.any()) return false;
  const OutputPiece& before = pieces_[newest()];
  const bool is_even = before.constant() && piece.constant() && before.start == piece.start;
  return is_even || !rate_.allows_short();
}

void OutputDelay::join(const OutputPiece& piece) {
  OutputPiece& before = pieces_[newest()];
  const bool same = before.constant() && piece.constant() && before.start == piece.start;
  const std::uint32_t energy = doubled_energy(before) + doubled_energy(piece);
  before.ticks = static_cast<std::uint16_t>(before.ticks + piece.ticks);
  merge(before.outputs, piece.outputs);
  if (same) return;
  before.start = static_cast<std::uint16_t>((energy + before.ticks) / (2U * before.ticks));
  before.end = before.start;
}

}  // namespace cnc::motion
