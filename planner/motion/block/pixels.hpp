#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "planner/base/contract.hpp"
#include "planner/motion/block/source_line.hpp"

namespace cnc::motion {

/// A stretch of a row on which the power is the same.
struct Pixel {
  float end_mm = 0.0F;  ///< From the start of its row, at most 100 mm; to 1e-5 mm.
  float duty = 0.0F;    ///< As in BeamCommand.
  SourceLine line{};
};

/// What an element drives of a row of pixels; nothing where its power is all the same.
struct RowPart {
  std::uint32_t first = 0;  ///< Number of the row's first pixel, see Pixels.
  float from_mm = 0.0F;     ///< From the start of the row…
  float to_mm = 0.0F;       ///< …up to here. 0: no row.

  [[nodiscard]] constexpr bool any() const { return to_mm > 0.0F; }
  /// A part of the part. @param from, to 0…1 of this one.
  [[nodiscard]] constexpr RowPart part(float from, float to) const {
    const float length = to_mm - from_mm;
    return {.first = first,
            .from_mm = from_mm + from * length,
            .to_mm = to < 1.0F ? from_mm + to * length : to_mm};
  }
};

/// The pixels of all rows that wait to be driven, in the order in which they are.
///
/// A row is one block however many powers it has: blocks say where their pixels
/// begin, and the look-ahead need not know of them. Pixels are numbered as they
/// come; numbers run on when all are forgotten. When it is full, rows wait before
/// it until some are driven. Driven pixels are kept until newer ones take their place.
///
/// Main loop only.
class Pixels {
 public:
  /// At 20,000 per second what 5000 mm/s² need to brake from 300 mm/s, and 8 ms more.
  static constexpr std::size_t kMost = 1536;

  /// Driven pixels that are kept at least: those of 25 ms at 20,000 per second, and of two rows.
  static constexpr std::size_t kKept = 640;

  [[nodiscard]] std::size_t room() const { return size() < kMost ? kMost - size() : 0; }
  [[nodiscard]] bool empty() const { return end_ == first_; }
  /// Of the oldest pixel, and the one that the next will get.
  [[nodiscard]] std::uint32_t first() const { return first_; }
  [[nodiscard]] std::uint32_t next() const { return end_; }

  /// @pre room() > 0; the two pixels of a row that is held may be pushed after take_back(), too
  void push(const Pixel& pixel) {
    CNC_ASSERT(size() < kStored);
    kept_ = std::min(kept_, kStored - 1 - size());
    pixels_[slot_of(size())] = pixel;
    ++end_;
  }
  /// The oldest. @pre !empty()
  [[nodiscard]] const Pixel& front() const {
    CNC_ASSERT(!empty());
    return pixels_[slot_];
  }
  /// @pre !empty()
  void pop() {
    CNC_ASSERT(!empty());
    ++first_;
    ++kept_;
    slot_ = slot_of(1);
  }
  /// @param number of a pixel that is there, or the next one's
  void drop_before(std::uint32_t number) {
    while (!empty() && static_cast<std::int32_t>(number - first_) > 0) pop();
  }
  /// Makes a driven pixel the oldest again. Returns false if it is not kept any more.
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
  /// Pixels that a row may push although there is no room: it was begun when there was.
  static constexpr std::uint32_t kHeldBack = 2;
  static constexpr std::uint32_t kStored = kMost + kKept + kHeldBack;

  [[nodiscard]] std::uint32_t size() const { return end_ - first_; }
  [[nodiscard]] std::uint32_t slot_of(std::uint32_t index) const {
    const std::uint32_t slot = slot_ + index;
    return slot < kStored ? slot : slot - kStored;
  }

  std::array<Pixel, kStored> pixels_{};
  std::uint32_t first_ = 0;
  std::uint32_t end_ = 0;
  std::uint32_t slot_ = 0;  ///< Of the oldest pixel that is not driven.
  std::uint32_t kept_ = 0;  ///< Driven ones before it.
};

}  // namespace cnc::motion
