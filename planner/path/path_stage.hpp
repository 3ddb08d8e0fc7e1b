#pragma once

#include <cstdint>
#include <optional>

#include "planner/path/corner_rounder.hpp"
#include "planner/path/pixel_row.hpp"
#include "planner/path/short_lines.hpp"
#include "planner/path/welder.hpp"

namespace cnc::path {

/// From the programmed path to the one that is driven: lines too short for a step are taken by the
/// next, lines that go straight on are gathered, short ones welded, corners rounded or made stops;
/// elements in, elements out. Some are held back until those after them are known.
///
/// Main loop only. No call does more than a bounded amount of work.
class PathStage {
 public:
  /// @param limits must outlive this.
  /// @param pixels of rows that are gathered; null to gather none. Must outlive this.
  explicit PathStage(const motion::Limits& limits, motion::Pixels* pixels = nullptr)
      : short_{limits}, row_{pixels}, rounder_{limits} {}

  [[nodiscard]] bool has_room() const { return short_.has_room() && row_takes(); }
  /// Takes an element that moves. @pre has_room(), and it begins where the one
  /// before ended
  void put(const PathItem& item);
  /// Lets what is held go on as far as it is known. Returns whether put_row() may be called: more
  /// of it is known, and goes on, with time.
  /// @param pixels of the row
  [[nodiscard]] bool takes_row(std::size_t pixels);
  /// Takes a line with several powers. @pre takes_row(), PixelRow::can_be_row(), and it begins
  /// where the one before ended
  void put_row(const PathItem& item, const RowPowers& powers);
  /// The next piece to be driven, until the next call of anything else; null when there is
  /// none yet.
  [[nodiscard]] const PathPiece* next();

  /// How many lines wait to be gathered with more of them.
  [[nodiscard]] std::size_t gathered() const { return row_.lines(); }
  /// They are not to wait any longer.
  void end_row() { row_.close(); }
  /// Nothing will come for a while: next() gives out all that is held.
  void flush() { flushing_ = true; }
  /// What has been welded so far is given out: the machine stands, or would have to brake
  /// and does not stop there anyway.
  void hurry(bool stands);
  /// Forgets all that is held.
  void clear();

  [[nodiscard]] bool empty() const {
    return short_.empty() && row_.empty() && welder_.empty() && rounder_.empty();
  }
  /// Source line of the oldest element held; 0 for none.
  [[nodiscard]] motion::SourceLine line() const;

 private:
  [[nodiscard]] bool row_takes() const { return !next_ && !row_.closed() && row_.has_room(); }
  void put_in_row(const PathItem& item);
  [[nodiscard]] bool move_on();
  void row_left();

  ShortLines short_;
  PixelRow row_;
  std::optional<PathItem> next_{};  ///< Does not go on with the row.
  Welder welder_{};
  CornerRounder rounder_;
  bool flushing_ = false;
};

}  // namespace cnc::path
