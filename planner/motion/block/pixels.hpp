#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "planner/base/contract.hpp"
#include "planner/motion/block/source_line.hpp"

namespace cnc::motion {

/// A part of a row (see Pixels) that is driven with one power.
struct Pixel {
  /// Distance of the pixel's end from the start of the row, at most 100 mm, accurate to 1e-5 mm.
  float end_mm = 0.0F;
  float duty = 0.0F;  ///< Output during the pixel, see BeamCommand::duty.
  SourceLine line{};
};

/// The part of a row of pixels that a path element drives. A path element with a single power
/// drives no row.
struct RowPart {
  std::uint32_t first = 0;  ///< Number of the row's first pixel, see Pixels.
  float from_mm = 0.0F;     ///< Distance of the part's start from the start of the row.
  /// Distance of the part's end from the start of the row; 0 without a row.
  float to_mm = 0.0F;

  [[nodiscard]] constexpr bool any() const { return to_mm > 0.0F; }
  /// Returns a part of this part. @param from, to ends of the result as shares of this part, 0…1
  [[nodiscard]] constexpr RowPart part(float from, float to) const {
    const float length = to_mm - from_mm;
    return {.first = first,
            .from_mm = from_mm + from * length,
            .to_mm = to < 1.0F ? from_mm + to * length : to_mm};
  }
};

/// The pixels of all rows that wait to be driven, in the order of driving.
///
/// A row is one block, even if it has many powers. The block has only the number of the row's first
/// pixel, so the look-ahead does not need the pixels. Pixels are numbered in the order of arrival,
/// and the numbers continue after clear(). When the store is full, further rows wait until some
/// pixels have been driven. Driven pixels are kept until newer pixels overwrite them.
///
/// Main loop only.
class Pixels {
 public:
  /// Greatest number of waiting pixels. At 20,000 pixels per second, they last longer than 68 ms:
  /// the 60 ms of braking from 300 mm/s at 5000 mm/s², and 8 ms more.
  static constexpr std::size_t kMax = 1536;

  /// Least number of driven pixels that are kept. It covers the pixels of 25 ms, at 20,000 pixels
  /// per second, and of two rows.
  static constexpr std::size_t kKept = 640;

  [[nodiscard]] std::size_t room() const { return size() < kMax ? kMax - size() : 0; }
  [[nodiscard]] bool empty() const { return end_ == first_; }
  /// Return the number of the oldest waiting pixel, and the number of the next pixel to be pushed.
  [[nodiscard]] std::uint32_t first() const { return first_; }
  [[nodiscard]] std::uint32_t next() const { return end_; }

  /// Adds a pixel.
  /// @pre room() > 0. A row that began while room() > 0 may still push its last two pixels after
  /// take_back() has used up the free space.
  void push(const Pixel& pixel) {
    CNC_ASSERT(size() < kStored);
    kept_ = std::min(kept_, kStored - 1 - size());
    pixels_[slot_of(size())] = pixel;
    ++end_;
  }
  /// Returns the oldest waiting pixel. @pre !empty()
  [[nodiscard]] const Pixel& front() const {
    CNC_ASSERT(!empty());
    return pixels_[slot_];
  }
  /// Marks the oldest waiting pixel as driven. The pixel is kept for take_back(). @pre !empty()
  void pop() {
    CNC_ASSERT(!empty());
    ++first_;
    ++kept_;
    slot_ = slot_of(1);
  }
  /// Marks all waiting pixels before the pixel `number` as driven. The pixels are kept for
  /// take_back().
  /// @param number number of a waiting pixel, or next()
  void drop_before(std::uint32_t number) {
    while (!empty() && static_cast<std::int32_t>(number - first_) > 0) pop();
  }
  /// Makes the driven pixel `number` the oldest waiting one. Returns false if this pixel is no
  /// longer kept, or if there would be no free space for the last two pixels of a row, see push().
  [[nodiscard]] bool take_back(std::uint32_t number) {
    const std::uint32_t count = first_ - number;
    if (static_cast<std::int32_t>(count) <= 0) return true;
    if (count > kept_ || size() + count > kStored - kHeldBack) return false;
    kept_ -= count;
    first_ = number;
    slot_ = slot_of(kStored - count);
    return true;
  }
  void clear() {
    slot_ = slot_of(size());
    first_ = end_;
    kept_ = 0;
  }

 private:
  /// Number of pixels that a row may push without free space if there was free space when it began.
  static constexpr std::uint32_t kHeldBack = 2;
  static constexpr std::uint32_t kStored = kMax + kKept + kHeldBack;

  [[nodiscard]] std::uint32_t size() const { return end_ - first_; }
  [[nodiscard]] std::uint32_t slot_of(std::uint32_t index) const {
    const std::uint32_t slot = slot_ + index;
    return slot < kStored ? slot : slot - kStored;
  }

  std::array<Pixel, kStored> pixels_{};
  std::uint32_t first_ = 0;
  std::uint32_t end_ = 0;
  std::uint32_t slot_ = 0;  ///< Index of the oldest waiting pixel in pixels_.
  std::uint32_t kept_ = 0;  ///< Number of driven pixels before the oldest waiting one.
};

}  // namespace cnc::motion
