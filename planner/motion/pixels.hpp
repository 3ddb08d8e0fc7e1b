#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "planner/base/contract.hpp"
#include "planner/motion/source_line.hpp"

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
/// it until some are driven.
///
/// Main loop only.
class Pixels {
 public:
  /// With 0.1 mm each what 500 mm/s² need to brake from 200 mm/s, and more than three
  /// times what 3000 mm/s² need from 300 mm/s.
  static constexpr std::size_t kMost = 512;

  [[nodiscard]] std::size_t room() const { return kMost - (end_ - first_); }
  [[nodiscard]] bool empty() const { return end_ == first_; }
  /// Of the oldest pixel, and the one that the next will get.
  [[nodiscard]] std::uint32_t first() const { return first_; }
  [[nodiscard]] std::uint32_t next() const { return end_; }

  /// @pre room() > 0
  void push(const Pixel& pixel) {
    CNC_ASSERT(room() > 0);
    pixels_[end_ % kMost] = pixel;
    ++end_;
  }
  /// The oldest. @pre !empty()
  [[nodiscard]] const Pixel& front() const {
    CNC_ASSERT(!empty());
    return pixels_[first_ % kMost];
  }
  /// @pre !empty()
  void pop() {
    CNC_ASSERT(!empty());
    ++first_;
  }
  /// @param number of a pixel that is there, or the next one's
  void drop_before(std::uint32_t number) {
    while (!empty() && static_cast<std::int32_t>(number - first_) > 0) ++first_;
  }
  void clear() { first_ = end_; }

 private:
  // A power of two, so that numbers may overflow.
  static_assert((kMost & (kMost - 1)) == 0);

  std::array<Pixel, kMost> pixels_{};
  std::uint32_t first_ = 0;
  std::uint32_t end_ = 0;
};

}  // namespace cnc::motion
