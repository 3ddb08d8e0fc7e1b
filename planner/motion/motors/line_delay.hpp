#pragma once

#include <cstdint>

#include "planner/motion/block/source_line.hpp"

namespace cnc::motion {

/// The source line that is driven, where motion goes out a number of cells of time after it was
/// planned. The result is that line, or one that came at most the same number of cells before it.
class LineDelay {
 public:
  /// Begins from rest. @param cells number of cells from planning to output
  void begin(SourceLine line, std::uint32_t cells) {
    older_ = newer_ = line;
    cells_ = cells;
    age_ = 0;
  }
  /// Adds a cell that was planned, with its line.
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
