#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "hal/interface/can_port.hpp"

namespace hal::host {

/// Byte that ends a line of a serial adapter, and byte by which the adapter reports a refused line.
inline constexpr char kSlcanDone = '\r';
inline constexpr char kSlcanRefused = '\a';
/// Capacity for the longest line of a frame (`T` with eight bytes), with some reserve, in bytes.
inline constexpr std::size_t kLongestSlcanLine = 32;

/// Returns the frame of a line such as `t12320A0B` (without line end); nothing if the line is not a
/// frame.
[[nodiscard]] std::optional<CanFrame> read_slcan(std::string_view line);

/// Returns the line for a frame, with its line end.
/// @pre `frame.length` is at most 8
[[nodiscard]] std::string slcan_line(const CanFrame& frame);

}  // namespace hal::host
