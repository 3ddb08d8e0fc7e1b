#pragma once

#include <cstdint>

#include "planner/motion/block/source_line.hpp"

namespace cnc::motion {

/// The line that is driven, where motion goes out a number of cells of time after it was planned:
/// that one, or one that came at most as many cells before it.
class LineDelay {
 public:
  /// From rest. @param cells from what is planned to what goes out
  void begin(SourceLine line, std::uint32_t cells) {
    older_ = newer_ = line;
    cells_ = cells;
    age_ = 0;
  }
  /// A cell of this line is planned.
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
  std::uint32_t age_ = 0;  ///< Cells since newer_.
};

}  // namespace cnc::motion
