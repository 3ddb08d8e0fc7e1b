#pragma once

#include "planner/motion/block/block.hpp"
#include "planner/motion/block/path_units.hpp"
#include "planner/motion/block/pixels.hpp"

namespace cnc::motion {

/// The power along the block that is being driven: of the whole block, or of the
/// pixels of a row, which it uses up as they are passed.
class PixelCourse {
 public:
  /// @param pixels of the blocks' rows; null where no block has any
  explicit PixelCourse(Pixels* pixels) : pixels_{pixels} {}

  /// The block begins. @param length of it
  void begin(const Block& block, PathUnits length);
  /// The place on the block is this now.
  void pass(PathUnits place);
  /// Where the power changes next, or the end of the block.
  [[nodiscard]] PathUnits next_change() const { return change_; }
  /// Returns whether that is within the block, and before `place`.
  [[nodiscard]] bool changes_before(PathUnits place) const {
    return change_ < place && change_ < length_;
  }
  /// Of the beam at the present place, see BeamCommand.
  [[nodiscard]] float duty() const { return duty_; }
  /// Where that comes from.
  [[nodiscard]] SourceLine line() const { return line_; }

 private:
  void take_front();

  Pixels* pixels_;
  RowPart row_{};
  float scale_ = 1.0F;    ///< mm of the block per mm of the row.
  PathUnits length_ = 0;  ///< Of the block.
  PathUnits change_ = 0;
  float duty_ = 0.0F;
  SourceLine line_{};
};

/// The source line that is being driven, or comes first. @param block the oldest
[[nodiscard]] SourceLine line_of(const Block& block, const Pixels& pixels);

}  // namespace cnc::motion
