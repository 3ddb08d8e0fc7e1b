#pragma once

#include <cstdint>
#include <optional>

#include "planner/path/corner_rounder.hpp"
#include "planner/path/pixel_row.hpp"
#include "planner/path/short_lines.hpp"
#include "planner/path/welder.hpp"

namespace cnc::path {

/// Converts the programmed path to the driven path. It joins a line that is shorter than half a
/// step to the next element (ShortLines). It gathers lines in one direction (PixelRow), and welds
/// short lines (Welder). It rounds corners or stops at them (CornerRounder). Both paths are
/// sequences of elements. Some elements are held until the elements after them are known.
///
/// Main loop only. Each call does a bounded amount of work.
class PathStage {
 public:
  /// @param limits must outlive this object
  /// @param pixels storage for the pixels of gathered rows, which must outlive this object; null if
  /// nothing is to be gathered
  explicit PathStage(const motion::Limits& limits, motion::Pixels* pixels = nullptr)
      : short_{limits}, row_{pixels}, rounder_{limits} {}

  [[nodiscard]] bool has_room() const { return short_.has_room() && row_takes(); }
  /// Adds an element that moves. @pre has_room(), and the element begins at the end of the element
  /// before
  void put(const PathItem& item);
  /// Passes held elements to later stages if they are settled. Returns whether put_row() may be
  /// called. If not, a later call may return true, because it can pass on more held elements.
  /// @param pixels number of pixels of the row
  [[nodiscard]] bool takes_row(std::size_t pixels);
  /// Adds a line with several powers. @pre takes_row(), PixelRow::can_be_row(), and the line begins
  /// at the end of the element before
  void put_row(const PathItem& item, const RowPowers& powers);
  /// Returns the next piece of the driven path, or null if there is none yet. The piece is valid
  /// until the next call of any member.
  [[nodiscard]] const PathPiece* next();

  /// Returns the number of gathered lines that wait for further lines.
  [[nodiscard]] std::size_t gathered() const { return row_.lines(); }
  /// Ends the wait of the gathered lines for further lines.
  void end_row() { row_.close(); }
  /// Reports that no further element will come for some time. Then next() returns everything that
  /// is held.
  void flush() { flushing_ = true; }
  /// Releases the points that have been welded so far, if the machine is at rest or if the path
  /// continues into them without a stop. To be called if the machine is at rest or would have to
  /// brake.
  /// @param stands whether the machine is at rest
  void hurry(bool stands);
  /// Forgets all held elements.
  void clear();

  [[nodiscard]] bool empty() const {
    return short_.empty() && row_.empty() && welder_.empty() && rounder_.empty();
  }
  /// Returns the source line of the oldest held element; 0 if none is held.
  [[nodiscard]] motion::SourceLine line() const;

 private:
  [[nodiscard]] bool row_takes() const { return !next_ && !row_.closed() && row_.has_room(); }
  void put_in_row(const PathItem& item);
  [[nodiscard]] bool move_on();
  void row_left();

  ShortLines short_;
  PixelRow row_;
  std::optional<PathItem> next_{};  ///< The next item, which does not continue the row.
  Welder welder_{};
  CornerRounder rounder_;
  bool flushing_ = false;
};

}  // namespace cnc::path
