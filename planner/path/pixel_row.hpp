#pragma once

#include <cstddef>

#include "planner/motion/block/pixels.hpp"
#include "planner/path/path_item.hpp"

namespace cnc::path {

/// Joins short lines into one element if they continue in one direction and differ only in power.
/// This element is a row, which has one pixel for each power.
///
/// On each axis, the end of a line is at most kMaxAsideMm away from the row, so rows in any
/// direction may be written with three decimals. If the power stays constant or if corners are
/// exact stops, this distance is no more than the rounding of positions. So curves of constant
/// power keep their shape. A row begins and ends at ends of programmed lines, so deviations do not
/// accumulate.
///
/// A row has at most kMaxLines lines and is at most kMaxRowMm long, so that the wait for its end is
/// short. The next row begins at its end.
class PixelRow {
 public:
  static constexpr std::size_t kMaxLines = 32;
  /// Greatest distance of an end from the row on an axis, mm. It covers the rounding of two
  /// positions to 0.001 mm.
  static constexpr float kMaxAsideMm = 0.0015F;
  /// Greatest length of a line that may become a pixel, mm.
  static constexpr float kLongestLineMm = 20.0F;
  static constexpr float kMaxRowMm = 100.0F;
  /// Least number of powers of a line that is a row by itself. A line with fewer powers is gathered
  /// with other lines, so that it does not make more blocks than single lines do.
  static constexpr std::size_t kFewestOfARow = 16;

  /// @param pixels storage for the pixels, which must outlive this object; null if nothing is to be
  /// gathered
  explicit PixelRow(motion::Pixels* pixels) : pixels_{pixels} {}

  [[nodiscard]] bool empty() const { return !held_; }
  /// Returns whether the row is complete, so that item() is final.
  [[nodiscard]] bool closed() const { return closed_; }
  /// Returns whether there is capacity for the pixels that the next line may require.
  [[nodiscard]] bool has_room() const {
    return pixels_ == nullptr || pixels_->room() >= kPixelsOfALine;
  }

  /// Adds a line if it continues the held row. Returns whether it does. @pre has_room()
  [[nodiscard]] bool add(const PathItem& item);
  /// Begins with an item, which need not be a line. @pre empty()
  void begin(const PathItem& item);

  /// Returns whether a line can be a row by itself: it must have at least kFewestOfARow pixels and
  /// be at most kMaxRowMm long.
  [[nodiscard]] static bool can_be_row(const PathElement& line, std::size_t pixels);
  /// Returns whether there is capacity for `pixels` pixels and for those of the held row.
  [[nodiscard]] bool has_room_for(std::size_t pixels) const {
    return pixels_ != nullptr && pixels_->room() >= pixels + kPixelsOfALine;
  }
  /// Makes a line a row by itself, with which no other line is gathered. Closes the held row.
  /// @pre can_be_row(), has_room_for()
  void become_row(PathItem& item, const RowPowers& powers);
  void close();
  /// Forgets the held item, because the next stage has taken it.
  void let_go() { held_ = closed_ = false; }
  /// Forgets the held item. The owner of the pixels forgets its pixels.
  void clear();

  /// Returns the number of gathered lines that wait for more lines.
  [[nodiscard]] std::size_t lines() const { return held_ && !closed_ ? lines_ : 0; }
  /// Returns the held item. @pre !empty()
  [[nodiscard]] const PathItem& item() const { return item_; }

 private:
  /// Travel from the start of the row to a position.
  struct Way {
    AxisArray<float> travel{};
    float length = 0.0F;
  };
  /// Range of the slopes with which a straight row passes all ends. The slope of an axis is its
  /// travel divided by the travel of the leading axis.
  struct SlopeRange {
    float least = 0.0F;
    float most = 0.0F;
  };

  [[nodiscard]] bool may_go_on(const motion::MotionRequest& next, bool same_power) const;
  [[nodiscard]] bool straight_on(const Way& way) const;
  void limit_slopes(float aside_mm);
  void give_pixel();
  [[nodiscard]] Way way_to(const Position& place) const;

  /// Greatest number of pixels that one line completes: the pixel of the line before and, if the
  /// row ends, its own pixel.
  static constexpr std::size_t kPixelsOfALine = 2;

  motion::Pixels* pixels_;
  PathItem item_{};
  bool held_ = false;
  bool closed_ = false;
  /// True if the row was closed only because it has its greatest number of lines.
  bool full_ = false;

  std::size_t lines_ = 0;
  /// True if the row has more than one power, or continues a full row that has.
  bool graded_ = false;
  bool slopes_known_ = false;
  Way way_{};  ///< Travel from the start to the end of the row.
  std::size_t leading_ = 0;
  AxisArray<SlopeRange> slopes_{};
  bool has_pixels_ = false;
  motion::Pixel pixel_{};  ///< The last pixel, which may still become longer.
};

}  // namespace cnc::path
