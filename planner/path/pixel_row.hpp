#pragma once

#include <cstddef>

#include "planner/motion/block/pixels.hpp"
#include "planner/path/path_item.hpp"

namespace cnc::path {

/// Gathers short lines that go on in one direction and differ in nothing but
/// power into one element: a row, with a pixel for each power.
///
/// No end of a line is farther from the row than kMostAsideMm on any axis, and where the
/// power stays the same, or corners are exact stops, than the rounding of
/// places: so curves of even power stay what they are, and rows in any direction
/// may be written with three decimals. A row goes from end to end of programmed
/// lines, so nothing adds up. It has at most kMostLines of them and is kMostRowMm long, so that
/// no row is waited for long; the next goes on where it ends.
///
/// Main loop only.
class PixelRow {
 public:
  static constexpr std::size_t kMostLines = 32;
  static constexpr float kMostAsideMm = 0.0015F;  ///< Ends of 0.001 mm, at each of two places.
  /// Longer lines are no pixels.
  static constexpr float kLongestLineMm = 20.0F;
  static constexpr float kMostRowMm = 100.0F;
  /// Lines with fewer powers are gathered, so that they make no more blocks than single ones.
  static constexpr std::size_t kFewestOfARow = 16;

  /// @param pixels where they go; null to gather nothing. Must outlive this.
  explicit PixelRow(motion::Pixels* pixels) : pixels_{pixels} {}

  [[nodiscard]] bool empty() const { return !held_; }
  /// Nothing more will be gathered: item() is what it will be.
  [[nodiscard]] bool closed() const { return closed_; }
  /// There is room for the pixels that the next line may need.
  [[nodiscard]] bool has_room() const {
    return pixels_ == nullptr || pixels_->room() >= kPixelsOfALine;
  }

  /// Takes a line if it goes on with what is held. @pre has_room()
  [[nodiscard]] bool add(const PathItem& item);
  /// Begins with this, a line or anything else. @pre empty()
  void begin(const PathItem& item);

  /// Returns whether a line can be a row by itself: from kFewestOfARow to its length in pixels.
  [[nodiscard]] static bool can_be_row(const PathElement& line, std::size_t pixels);
  /// Returns whether the pixels of such a line and of the one held have room.
  [[nodiscard]] bool has_room_for(std::size_t pixels) const {
    return pixels_ != nullptr && pixels_->room() >= pixels + kPixelsOfALine;
  }
  /// Makes a line a row by itself, which nothing is gathered with. What is held is closed.
  /// @pre can_be_row(), has_room_for()
  void become_row(PathItem& item, const RowPowers& powers);
  void close();
  /// What was held has been taken over.
  void let_go() { held_ = closed_ = false; }
  /// Forgets all that is held; its pixels are forgotten by their owner.
  void clear();

  /// How many have been gathered that wait for more.
  [[nodiscard]] std::size_t lines() const { return held_ && !closed_ ? lines_ : 0; }
  /// What is held. @pre !empty()
  [[nodiscard]] const PathItem& item() const { return item_; }

 private:
  /// Travel from the start of the row.
  struct Way {
    AxisArray<float> travel{};
    float length = 0.0F;
  };
  /// The slopes over the leading axis with which a straight row passes all ends.
  struct SlopeRange {
    float least = 0.0F;
    float most = 0.0F;
  };

  [[nodiscard]] bool may_go_on(const motion::MotionRequest& next, bool same_power) const;
  [[nodiscard]] bool straight_on(const Way& way) const;
  void limit_slopes(float aside_mm);
  void give_pixel();
  [[nodiscard]] Way way_to(const Position& place) const;

  /// That of the line before it, and its own when the row ends.
  static constexpr std::size_t kPixelsOfALine = 2;

  motion::Pixels* pixels_;
  PathItem item_{};
  bool held_ = false;
  bool closed_ = false;
  bool full_ = false;  ///< Closed with nothing to tell but its length.

  std::size_t lines_ = 0;
  bool graded_ = false;  ///< More than one power.
  bool slopes_known_ = false;
  Way way_{};  ///< To its end.
  std::size_t leading_ = 0;
  AxisArray<SlopeRange> slopes_{};
  bool has_pixels_ = false;
  motion::Pixel pixel_{};  ///< The last, which may still grow.
};

}  // namespace cnc::path
