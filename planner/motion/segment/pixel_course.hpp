#pragma once

#include "planner/motion/block/block.hpp"
#include "planner/motion/block/path_units.hpp"
#include "planner/motion/block/pixels.hpp"

namespace cnc::motion {

/// The power along the block that is being driven. It is the power of the block or, if the block
/// drives a part of a row, the power of the row's pixels. Pixels that the motion has passed are
/// removed from the waiting ones.
class PixelCourse {
 public:
  /// @param pixels pixels of the rows of all blocks; null if no block has a row
  explicit PixelCourse(Pixels* pixels) : pixels_{pixels} {}

  /// Begins a block. @param length length of the block
  void begin(const Block& block, PathUnits length);
  /// Sets the present position on the block, and marks the pixels before it as driven.
  void pass(PathUnits place);
  /// Returns the position of the next change of power, or the end of the block.
  [[nodiscard]] PathUnits next_change() const { return change_; }
  /// Returns whether the power changes within the block and before `place`.
  [[nodiscard]] bool changes_before(PathUnits place) const {
    return change_ < place && change_ < length_;
  }
  /// Returns the duty of the beam at the present position, see BeamCommand.
  [[nodiscard]] float duty() const { return duty_; }
  /// Returns the source line of the present position.
  [[nodiscard]] SourceLine line() const { return line_; }

 private:
  void take_front();

  Pixels* pixels_;
  RowPart row_{};
  float scale_ = 1.0F;    ///< mm of the block per mm of the row.
  PathUnits length_ = 0;  ///< Length of the block.
  PathUnits change_ = 0;
  float duty_ = 0.0F;
  SourceLine line_{};
};

/// Returns the source line that is being driven or will be driven next. It is the line of the next
/// pixel if this pixel belongs to the row of `block`, otherwise the line of `block`.
/// @param block the oldest block of the queue
[[nodiscard]] SourceLine line_of(const Block& block, const Pixels& pixels);

}  // namespace cnc::motion
