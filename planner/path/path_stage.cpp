#include "planner/path/path_stage.hpp"

#include "planner/base/contract.hpp"

namespace cnc::path {

void PathStage::put(const PathItem& item) {
  CNC_ASSERT(has_room());
  flushing_ = false;
  short_.put(item);
  if (const PathItem* const settled = short_.next()) put_in_row(*settled);
  static_cast<void>(move_on());
}

bool PathStage::takes_row(std::size_t pixels) {
  if (!short_.empty()) {
    if (short_.has_room()) short_.flush();
    static_cast<void>(move_on());
  }
  return short_.empty() && row_takes() && row_.has_room_for(pixels);
}

void PathStage::put_row(const PathItem& item, const RowPowers& powers) {
  CNC_ASSERT(short_.empty() && row_takes());
  flushing_ = false;
  PathItem row = item;
  row_.become_row(row, powers);
  put_in_row(row);
  static_cast<void>(move_on());
}

/// Adds an item to the row, or begins a new row with it. @pre row_takes(), or the row was closed
/// for this item
void PathStage::put_in_row(const PathItem& item) {
  if (row_.empty()) {
    row_.begin(item);
  } else if (!row_.add(item)) {
    row_.close();
    next_ = item;
  }
}

void PathStage::clear() {
  short_.clear();
  row_.clear();
  next_.reset();
  welder_.clear();
  rounder_.clear();
  flushing_ = false;
}

void PathStage::hurry(bool stands) {
  if (stands || rounder_.goes_on()) welder_.hurry();
}

motion::SourceLine PathStage::line() const {
  if (!rounder_.empty()) return rounder_.line();
  if (!welder_.empty()) return welder_.line();
  return row_.empty() ? short_.line() : row_.item().request.line;
}

void PathStage::row_left() {
  row_.let_go();
  if (!next_) return;
  row_.begin(*next_);
  next_.reset();
}

/// Moves one item to the next stage. Returns whether anything changed.
bool PathStage::move_on() {
  if (flushing_ && short_.has_room()) short_.flush();
  if (row_takes()) {
    if (const PathItem* const settled = short_.next()) {
      put_in_row(*settled);
      return true;
    }
  }
  if (flushing_ && short_.empty()) row_.close();
  const PathItem* const waiting = row_.closed() ? &row_.item() : nullptr;
  if (rounder_.has_room()) {
    if (const PathItem* const item = welder_.next()) {
      rounder_.put(*item);
      return true;
    }
  }
  if (waiting != nullptr && welder_.takes(*waiting) && welder_.has_room() && rounder_.has_room()) {
    if (welder_.empty()) rounder_.expect(*waiting);
    welder_.put(*waiting);
    row_left();
    return true;
  }
  if (!welder_.empty()) {
    const bool other = waiting != nullptr && !welder_.takes(*waiting);
    return (other || flushing_) && welder_.close();
  }
  if (waiting == nullptr || !rounder_.has_room()) return false;
  rounder_.put(*waiting);
  row_left();
  return true;
}

const PathPiece* PathStage::next() {
  // Greatest number of moves that one item may need to pass all stages.
  constexpr int kMaxMoves = 5;
  for (int i = 0; i < kMaxMoves; ++i) {
    if (const PathPiece* const piece = rounder_.next()) return piece;
    if (!move_on()) break;
  }
  const bool all =
      flushing_ && short_.empty() && row_.empty() && welder_.empty() && rounder_.has_room();
  if (all) rounder_.flush();
  if (rounder_.empty()) flushing_ = flushing_ && !empty();
  return rounder_.next();
}

}  // namespace cnc::path
