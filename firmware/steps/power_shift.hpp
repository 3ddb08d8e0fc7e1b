#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "firmware/steps/power_stream.hpp"

namespace cnc {

/// How the light follows the output, in ticks of the step clock.
struct BeamTiming {
  static constexpr std::int32_t kLongest = motion::kTicksPerSecond / 200;  ///< 5 ms, of each.

  std::int32_t lag = 0;         ///< Light behind motors; negative: motors behind light.
  std::uint32_t on_delay = 0;   ///< More of it when the beam goes on…
  std::uint32_t off_delay = 0;  ///< …and when it goes off.
  constexpr bool operator==(const BeamTiming&) const = default;
};

/// Makes the steps of a segment later by `ticks`, at most BeamTiming::kLongest.
inline void delay(motion::Segment& segment, std::uint32_t ticks) {
  segment.ticks += ticks;
  for (motion::StepTrain& train : segment.trains) {
    train.first_q16 += static_cast<std::int32_t>(ticks << 16U);
  }
}

/// Commands the output earlier or later than the motion, so that the light falls
/// where it belongs: the main loop's end of a PowerStream.
///
/// From one planned standstill to the next both streams have the same length. With a
/// positive lag the output begins with the motion's first piece, its steps wait, and
/// the output ends before them. With a negative one it begins dark, and what
/// would outlast the motion is cut off. An edge from dark to lit or back is moved
/// forward by its delay, at the cost of the piece before it: a gap or a flash
/// that is shorter than the delays allow vanishes. The beam is never lit by a
/// delay before its motion, nor after it.
///
/// Keeps back the last pieces, as long as an edge may still move into them.
class PowerShift {
 public:
  /// Those of 5 ms at 20,000 pixels per second, and of a segment.
  static constexpr std::size_t kMostHeld = 128;

  /// Places in the stream for a segment, each of whose levels may move an edge, and for its end.
  static constexpr std::uint32_t kMostAtOnce = 5 + 2 * motion::Segment::kMostLevels;

  /// @pre settled()
  void configure(const BeamTiming& timing) { timing_ = timing; }

  /// Nothing kept back: whatever is added next begins a motion.
  [[nodiscard]] bool settled() const { return settled_; }
  /// How long the steps of a motion that begins have to wait.
  [[nodiscard]] std::uint32_t wait() const {
    return static_cast<std::uint32_t>(std::max<std::int32_t>(0, timing_.lag));
  }
  /// By how much further ahead motion has to be known.
  [[nodiscard]] std::uint32_t look_ahead() const { return wait() + held_ticks(); }
  /// How long after its command the light ends, as the motors see it.
  [[nodiscard]] std::int32_t light_behind() const {
    return timing_.lag + static_cast<std::int32_t>(timing_.off_delay);
  }
  /// Places in the stream that add() of all pieces of a segment and settle() may need together.
  [[nodiscard]] std::uint32_t room_needed() const {
    return static_cast<std::uint32_t>(count_) + kMostAtOnce;
  }

  /// What the output is to do next. @pre the stream has room_needed()
  template <typename Stream>
  void add(const PowerPiece& piece, Stream& stream) {
    if (settled_ && timing_.lag < 0) append({.ticks = delay()});
    settled_ = false;
    if (count_ == 0 && held_ticks() == 0) return stream.push(piece);
    const bool was_dark = count_ == 0 ? piece.course.dark() : back().course.dark();
    if (was_dark && !piece.course.dark()) move_edge(timing_.on_delay, piece.course.first);
    if (!was_dark && piece.course.dark()) move_edge(timing_.off_delay, 0);
    append(piece);
    release(held_ticks(), stream);
  }

  /// The motion ends in a standstill, and nothing more is known.
  template <typename Stream>
  [[gnu::cold]] void settle(Stream& stream) {
    cut(delay(), [](const PowerPiece&) { return true; });
    if (count_ > 0 && !back().course.dark()) move_edge(timing_.off_delay, 0);
    if (wait() > 0) append({.ticks = wait()});
    release(0, stream);
    settled_ = true;
  }

  /// The motion was cut off.
  void clear() {
    count_ = 0;
    ticks_ = 0;
    settled_ = true;
  }

 private:
  [[nodiscard]] std::uint32_t delay() const {
    return static_cast<std::uint32_t>(std::max<std::int32_t>(0, -timing_.lag));
  }
  [[nodiscard]] std::uint32_t held_ticks() const {
    return delay() + std::max(timing_.on_delay, timing_.off_delay);
  }

  [[nodiscard]] PowerPiece& back() { return pieces_[(first_ + count_ - 1) % kMostHeld]; }

  [[gnu::noinline]] void append(const PowerPiece& piece) {
    ++count_;
    back() = piece;
    ticks_ += piece.ticks;
  }

  /// Takes time off the end, as far as `may_go`; returns how much.
  template <typename Condition>
  std::uint32_t cut(std::uint32_t ticks, Condition may_go) {
    std::uint32_t left = ticks;
    while (left > 0 && count_ > 0 && may_go(back())) {
      const std::uint32_t taken = std::min(left, back().ticks);
      back().ticks -= taken;
      ticks_ -= taken;
      left -= taken;
      if (back().ticks == 0) --count_;
    }
    return ticks - left;
  }

  /// Lets the next piece begin `ticks` earlier, with this level. Out of line: only edges of light
  /// move, and it is long.
  [[gnu::noinline, gnu::cold]] void move_edge(std::uint32_t ticks, std::uint16_t level) {
    const bool dark = level != 0;
    const std::uint32_t moved =
        cut(ticks, [dark](const PowerPiece& piece) { return piece.course.dark() == dark; });
    if (moved > 0) append({.ticks = moved, .course = {.first = level}});
  }

  /// Hands out what is older than `keep`, and what there is no place for.
  template <typename Stream>
  void release(std::uint32_t keep, Stream& stream) {
    constexpr std::size_t kMostAppended = 3;
    while (count_ > 0) {
      const PowerPiece& oldest = pieces_[first_];
      if (ticks_ - oldest.ticks < keep && count_ + kMostAppended <= kMostHeld) return;
      stream.push(oldest);
      ticks_ -= oldest.ticks;
      first_ = (first_ + 1) % kMostHeld;
      --count_;
    }
  }

  BeamTiming timing_{};
  std::array<PowerPiece, kMostHeld> pieces_{};  ///< A ring.
  std::size_t first_ = 0;
  std::size_t count_ = 0;
  std::uint32_t ticks_ = 0;  ///< Of all of them.
  bool settled_ = true;
};

}  // namespace cnc
