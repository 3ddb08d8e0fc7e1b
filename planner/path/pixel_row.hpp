#pragma once

#include <cstddef>

#include "planner/motion/block/pixels.hpp"
#include "planner/path/path_item.hpp"

namespace cnc::path {

/// Gathers short lines that continue in one direction and differ in nothing but power into one
/// element: a row, with a pixel for each power.
///
/// No end of a line is farther from the row than kMaxAsideMm on any axis. Where the power stays
/// the same, or corners are exact stops, no end is farther from it than the rounding of positions.
/// So curves of constant power keep their shape, and rows in any direction may be written with
/// three decimals. A row goes from end to end of programmed lines, so deviations do not accumulate.
/// It has at most kMaxLines lines and is at most kMaxRowMm long, so that no row is waited for
/// long. The next row begins where it ends.
class PixelRow {
 public:
  static constexpr std::size_t kMaxLines = 32;
  /// Ends are rounded to 0.001 mm, at each of two positions.
  static constexpr float kMaxAsideMm = 0.0015F;
  /// Greatest length of a line that may be a pixel.
  static constexpr float kLongestLineMm = 20.0F;
  static constexpr float kMaxRowMm = 100.0F;
  /// A line with fewer powers is gathered with others, so that it makes no more blocks than single
  /// lines do.
  static constexpr std::size_t kFewestOfARow = 16;

  /// @param pixels storage for the pixels; null to gather nothing. Must outlive this.
  explicit PixelRow(motion::Pixels* pixels) : pixels_{pixels} {}

  [[nodiscard]] bool empty() const { return !held_; }
  /// Returns whether nothing more will be gathered: item() is final.
  [[nodiscard]] bool closed() const { return closed_; }
  /// Returns whether there is capacity for the pixels that the next line may need.
  [[nodiscard]] bool has_room() const {
    return pixels_ == nullptr || pixels_->room() >= kPixelsOfALine;
  }

  /// Adds a line if it continues what is held. Returns whether it did. @pre has_room()
  [[nodiscard]] bool add(const PathItem& item);
  /// Begins with an item, a line or anything else. @pre empty()
  void begin(const PathItem& item);

  /// Returns whether a line can be a row by itself: it has at least kFewestOfARow pixels and is at
  /// most kMaxRowMm long.
  [[nodiscard]] static bool can_be_row(const PathElement& line, std::size_t pixels);
  /// Returns whether there is capacity for the pixels of such a line and of the one held.
  [[nodiscard]] bool has_room_for(std::size_t pixels) const {
    return pixels_ != nullptr && pixels_->room() >= pixels + kPixelsOfALine;
  }
  /// Makes a line a row by itself, with which nothing is gathered. What is held is closed.
  /// @pre can_be_row(), has_room_for()
  void become_row(PathItem& item, const RowPowers& powers);
  void close();
  /// Drops what is held, because the next stage has taken it.
  void let_go() { held_ = closed_ = false; }
  /// Forgets what is held. The owner of its pixels forgets them.
  void clear();

  /// Returns how many lines have been gathered and wait for more lines.
  [[nodiscard]] std::size_t lines() const { return held_ && !closed_ ? lines_ : 0; }
  /// Returns what is held. @pre !empty()
  [[nodiscard]] const PathItem& item() const { return item_; }

 private:
  /// Travel from the start of the row.
  struct Way {
    AxisArray<float> travel{};
    float length = 0.0F;
  };
  /// Range of the slopes, relative to the leading axis, with which a straight row passes all ends.
  struct SlopeRange {
    float least = 0.0F;
    float most = 0.0F;
  };

  [[nodiscard]] bool may_go_on(const motion::MotionRequest& next, bool same_power) const;
  [[nodiscard]] bool straight_on(const Way& way) const;
  void limit_slopes(float aside_mm);
  void give_pixel();
  [[nodiscard]] Way way_to(const Position& place) const;

  /// Greatest number of pixels that one line completes: the pixel of the line before, and its own
  /// when the row ends.
  static constexpr std::size_t kPixelsOfALine = 2;

  motion::Pixels* pixels_;
  PathItem item_{};
  bool held_ = false;
  bool closed_ = false;
  bool full_ = false;  ///< Closed only because it has its greatest number of lines.

  std::size_t lines_ = 0;
  bool graded_ = false;  ///< The row has more than one power.
  bool slopes_known_ = false;
  Way way_{};  ///< Travel to the end of the row.
  std::size_t leading_ = 0;
  AxisArray<SlopeRange> slopes_{};
  bool has_pixels_ = false;
  motion::Pixel pixel_{};  ///< The last pixel, which may still grow.
};

}  // namespace cnc::path
