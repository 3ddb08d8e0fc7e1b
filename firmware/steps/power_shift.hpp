#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "firmware/steps/power_stream.hpp"

namespace cnc {

/// Delays between the output and the light, in ticks of the step clock.
struct BeamTiming {
  /// Upper bound of each delay, ticks: 5 ms.
  static constexpr std::int32_t kLongest = motion::kTicksPerSecond / 200;

  std::int32_t lag = 0;  ///< Delay of the light after the motors; negative if the light is earlier.
  std::uint32_t on_delay = 0;   ///< Additional delay of the light when the beam is switched on.
  std::uint32_t off_delay = 0;  ///< Additional delay of the light when the beam is switched off.
  constexpr bool operator==(const BeamTiming&) const = default;
};

/// Delays the steps of a segment by `ticks`, at most BeamTiming::kLongest.
inline void delay(motion::Segment& segment, std::uint32_t ticks) {
  segment.ticks += ticks;
  for (motion::StepTrain& train : segment.trains) {
    train.first_q16 += static_cast<std::int32_t>(ticks << 16U);
  }
}

/// Shifts the output in time against the motion, so that the light falls on the correct part of the
/// path. It runs in the main loop and writes to a PowerStream.
///
/// From one planned standstill to the next, the stream of the output and the stream of the steps
/// have the same length. With a positive lag the output begins with the motion's first piece, the
/// steps wait for the time of the lag, and the output ends before the steps. With a negative lag
/// the output begins with the beam off, and its part after the end of the motion is cut off. Each
/// edge of the beam, at which the beam goes on or off, is moved to an earlier time by its delay.
/// This shortens the piece before the edge. So a gap or a flash that is shorter than the delay of
/// its end vanishes. A delay never switches the beam on before the motion begins or after it ends.
///
/// The latest pieces are kept back until no later edge can move into them.
class PowerShift {
 public:
  /// Maximum number of kept pieces: the pieces of 5 ms at 20,000 pixels per second, and the pieces
  /// of a segment.
  static constexpr std::size_t kMaxHeld = 128;

  /// Maximum number of pieces that a segment and the end of its motion add to the stream. Each
  /// level of the segment may move an edge, which adds a piece.
  static constexpr std::uint32_t kMaxAtOnce = 5 + 2 * motion::Segment::kMaxLevels;

  /// Sets the delays.
  /// @pre settled()
  void configure(const BeamTiming& timing) { timing_ = timing; }

  /// Returns whether the output has ended with a motion, so that the next piece begins a motion.
  [[nodiscard]] bool settled() const { return settled_; }
  /// Returns the delay of the steps at the beginning of a motion, in ticks.
  [[nodiscard]] std::uint32_t wait() const {
    return static_cast<std::uint32_t>(std::max<std::int32_t>(0, timing_.lag));
  }
  /// Returns the additional length of motion, in ticks, that must be known ahead because of the
  /// shift.
  [[nodiscard]] std::uint32_t look_ahead() const { return wait() + held_ticks(); }
  /// Returns the delay, in ticks, from the command that switches the output off to the end of the
  /// light, counted in the time of the motors.
  [[nodiscard]] std::int32_t light_behind() const {
    return timing_.lag + static_cast<std::int32_t>(timing_.off_delay);
  }
  /// Returns the maximum number of pieces that add(), for all pieces of a segment, and settle()
  /// together push to the stream.
  [[nodiscard]] std::uint32_t room_needed() const {
    return static_cast<std::uint32_t>(count_) + kMaxAtOnce;
  }

  /// Adds the next piece of the output.
  /// @pre the stream has free space for room_needed() pieces
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

  /// Ends the output, because the motion ends at rest and no further motion is known.
  template <typename Stream>
  [[gnu::cold]] void settle(Stream& stream) {
    cut(delay(), [](const PowerPiece&) { return true; });
    if (count_ > 0 && !back().course.dark()) move_edge(timing_.off_delay, 0);
    if (wait() > 0) append({.ticks = wait()});
    release(0, stream);
    settled_ = true;
  }

  /// Drops all pieces, because the motion was cut off.
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

  [[nodiscard]] PowerPiece& back() { return pieces_[(first_ + count_ - 1) % kMaxHeld]; }

  [[gnu::noinline]] void append(const PowerPiece& piece) {
    ++count_;
    back() = piece;
    ticks_ += piece.ticks;
  }

  /// Removes up to `ticks` ticks from the end of the kept pieces. Stops at a piece for which
  /// `may_go` returns false. Returns the number of removed ticks.
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

  /// Makes the edge of the beam between the kept pieces and the next piece up to `ticks` earlier.
  /// Removes this time from the last kept pieces, and appends a piece with `level` for it. Not
  /// inlined, because it is long and only edges of the beam need it.
  /// @param level level of the output after the edge; 0 if the beam goes off
  [[gnu::noinline, gnu::cold]] void move_edge(std::uint32_t ticks, std::uint16_t level) {
    const bool dark = level != 0;
    const std::uint32_t moved =
        cut(ticks, [dark](const PowerPiece& piece) { return piece.course.dark() == dark; });
    if (moved > 0) append({.ticks = moved, .course = {.first = level}});
  }

  /// Passes the oldest pieces to the stream. Stops if the remaining pieces would last less than
  /// `keep` ticks and there is free space for kMaxAppended more pieces.
  template <typename Stream>
  void release(std::uint32_t keep, Stream& stream) {
    constexpr std::size_t kMaxAppended = 3;
    while (count_ > 0) {
      const PowerPiece& oldest = pieces_[first_];
      if (ticks_ - oldest.ticks < keep && count_ + kMaxAppended <= kMaxHeld) return;
      stream.push(oldest);
      ticks_ -= oldest.ticks;
      first_ = (first_ + 1) % kMaxHeld;
      --count_;
    }
  }

  BeamTiming timing_{};
  std::array<PowerPiece, kMaxHeld> pieces_{};  ///< Ring of kept pieces.
  std::size_t first_ = 0;
  std::size_t count_ = 0;
  std::uint32_t ticks_ = 0;  ///< Length of all kept pieces.
  bool settled_ = true;
};

}  // namespace cnc
