#pragma once

#include <cstdint>
#include <optional>

#include "planner/path/corner_rounder.hpp"
#include "planner/path/welder.hpp"

namespace cnc::path {

/// From the programmed path to the one that is driven: short lines are welded,
/// corners rounded or made stops; elements in, elements out. Some are held back
/// until those after them are known.
///
/// Main loop only. No call does more than a bounded amount of work.
class PathStage {
 public:
  /// @param limits must outlive this.
  explicit PathStage(const motion::Limits& limits) : rounder_{limits} {}

  [[nodiscard]] bool has_room() const { return !waiting_; }
  /// Takes an element that moves. @pre has_room(), and it begins where the one
  /// before ended
  void put(const PathItem& item);
  /// The next piece to be driven; false when there is none yet.
  [[nodiscard]] bool next(PathPiece& piece);

  /// Nothing will come for a while: next() gives out all that is held.
  void flush() { flushing_ = true; }
  /// What has been welded so far is given out: the machine stands, or would have to brake
  /// and does not stop there anyway.
  void hurry(bool stands);
  /// Forgets all that is held.
  void clear();

  [[nodiscard]] bool empty() const { return !waiting_ && welder_.empty() && rounder_.empty(); }
  /// Source line of the oldest element held; 0 for none.
  [[nodiscard]] std::uint32_t line() const;

 private:
  [[nodiscard]] bool move_on();

  Welder welder_{};
  CornerRounder rounder_;
  std::optional<PathItem> waiting_{};  ///< Cannot be welded to what the welder holds.
  bool flushing_ = false;
};

}  // namespace cnc::path
