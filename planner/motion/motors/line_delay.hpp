#pragma once

#include <cstdint>

#include "planner/motion/block/source_line.hpp"

namespace cnc::motion {

/// Delays the source line of a motion, because the motion is output some cells of time after it was
/// planned. line() returns the line of the motion that is being output, or of a motion that is
/// older by at most this delay.
class LineDelay {
 public:
  /// Begins a motion from rest with its source line. @param cells number of cells between planning
  /// and output
  void begin(SourceLine line, std::uint32_t cells) {
    older_ = newer_ = line;
    cells_ = cells;
    age_ = 0;
  }
  /// Adds the source line of a cell that was planned.
  void add(SourceLine line) {
    if (++age_ < cells_) return;
    older_ = newer_;
    newer_ = line;
    age_ = 0;
  }
  [[nodiscard]] SourceLine line() const { return older_; }

 private:
  SourceLine older_{};
  SourceLine newer_{};
  std::uint32_t cells_ = 0;
  std::uint32_t age_ = 0;  ///< Number of cells since newer_ was set.
};

}  // namespace cnc::motion
