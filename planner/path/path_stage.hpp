#pragma once

#include <cstdint>
#include <optional>

#include "planner/path/corner_rounder.hpp"
#include "planner/path/pixel_row.hpp"
#include "planner/path/short_lines.hpp"
#include "planner/path/welder.hpp"

namespace cnc::path {

/// Turns the programmed path into the path that is driven. A line too short for a step is taken
/// over by the next element; lines that continue in one direction are gathered; short lines are
/// welded; corners are rounded or become stops. Elements come in and elements go out. Some elements
/// are held back until those after them are known.
///
/// Main loop only. No call does more than a bounded amount of work.
class PathStage {
 public:
  /// @param limits must outlive this.
  /// @param pixels storage for pixels of rows that are gathered; null to gather none. Must outlive
  /// this.
  explicit PathStage(const motion::Limits& limits, motion::Pixels* pixels = nullptr)
      : short_{limits}, row_{pixels}, rounder_{limits} {}

  [[nodiscard]] bool has_room() const { return short_.has_room() && row_takes(); }
  /// Takes an element that moves. @pre has_room(), and the element begins where the one before
  /// ended
  void put(const PathItem& item);
  /// Passes held elements on as far as they are settled. Returns whether put_row() may be called.
  /// False may become true later, when more of the held elements have been passed on.
  /// @param pixels number of pixels of the row
  [[nodiscard]] bool takes_row(std::size_t pixels);
  /// Takes a line with several powers. @pre takes_row(), PixelRow::can_be_row(), and the line
  /// begins where the element before ended
  void put_row(const PathItem& item, const RowPowers& powers);
  /// Returns the next piece to be driven; null when there is none yet. The piece is valid until the
  /// next call of any member.
  [[nodiscard]] const PathPiece* next();

  /// Returns how many lines wait to be gathered with more lines.
  [[nodiscard]] std::size_t gathered() const { return row_.lines(); }
  /// Ends the waiting of gathered lines for more lines.
  void end_row() { row_.close(); }
  /// Reports that no element will come for a while: next() gives out all that is held.
  void flush() { flushing_ = true; }
  /// Releases what has been welded so far, if the machine is at rest or if the path continues there
  /// without a stop. Call this when the machine is at rest or would have to brake.
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
  std::optional<PathItem> next_{};  ///< An item that does not continue the row.
  Welder welder_{};
  CornerRounder rounder_;
  bool flushing_ = false;
};

}  // namespace cnc::path
