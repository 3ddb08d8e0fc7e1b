#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace machine {

/// A classic CAN frame.
struct CanFrame {
  std::uint32_t id = 0;
  bool extended = false;
  bool remote = false;
  std::uint8_t length = 0;  // 0…8
  std::array<std::uint8_t, 8> data{};
};

/// Returns the number of bits on the wire, from start of frame to the end of the three bits of
/// intermission, including stuff bits (ISO 11898-1, 10.4 and 10.5).
[[nodiscard]] unsigned bits_on_wire(const CanFrame& frame);

/// Returns the priority; the lower value wins: identifier, then data before remote frames, then
/// base before extended format.
[[nodiscard]] std::uint64_t arbitration(const CanFrame& frame);

/// Converts from and to the text of candump and cansend of can-utils: `123#1122`, `12345678#`,
/// `123#R2`.
[[nodiscard]] std::string text_of(const CanFrame& frame);
[[nodiscard]] std::optional<CanFrame> frame_of(std::string_view text);

struct TimedFrame {
  std::int64_t at_ns = 0;
  CanFrame frame;
};
/// Reads lines `NS FRAME` in order of time; returns false with a message if a line is not valid.
[[nodiscard]] bool read_frames(const std::string& path, std::vector<TimedFrame>& frames);

}  // namespace machine
