#include "planner/path/path_stage.hpp"

#include "planner/base/contract.hpp"

namespace cnc::path {

void PathStage::put(const PathItem& item) {
  CNC_ASSERT(has_room());
  flushing_ = false;
  waiting_ = item;
  static_cast<void>(move_on());
}

void PathStage::clear() {
  welder_.clear();
  rounder_.clear();
  waiting_.reset();
  flushing_ = false;
}

void PathStage::hurry(bool stands) {
  if (stands || rounder_.goes_on()) welder_.hurry();
}

std::uint32_t PathStage::line() const {
  if (!rounder_.empty()) return rounder_.line();
  if (!welder_.empty()) return welder_.line();
  return waiting_ ? waiting_->request.line : 0;
}

/// One item from where it waits to where it goes next; false when none can go.
bool PathStage::move_on() {
  PathItem item;
  if (rounder_.has_room() && welder_.next(item)) {
    rounder_.put(item);
    return true;
  }
  if (waiting_ && welder_.takes(*waiting_) && welder_.has_room() && rounder_.has_room()) {
    if (welder_.empty()) rounder_.expect(*waiting_);
    welder_.put(*waiting_);
    waiting_.reset();
    return true;
  }
  if (!welder_.empty()) {
    const bool other = waiting_ && !welder_.takes(*waiting_);
    return (other || flushing_) && welder_.close();
  }
  if (!waiting_ || !rounder_.has_room()) return false;
  rounder_.put(*waiting_);
  waiting_.reset();
  return true;
}

bool PathStage::next(PathPiece& piece) {
  // As many as one item may need to go all the way.
  constexpr int kMostMoves = 4;
  for (int i = 0; i < kMostMoves; ++i) {
    if (rounder_.next(piece)) return true;
    if (!move_on()) break;
  }
  const bool all = flushing_ && !waiting_ && welder_.empty() && rounder_.has_room();
  if (all) rounder_.flush();
  if (rounder_.empty()) flushing_ = flushing_ && !empty();
  return rounder_.next(piece);
}

}  // namespace cnc::path
