#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "hal/interface/can_port.hpp"

namespace hal::host {

/// What ends a line of an adapter of the serial kind, and what says that it refused one.
inline constexpr char kSlcanDone = '\r';
inline constexpr char kSlcanRefused = '\a';
/// A frame's longest line, `T` with eight bytes, and some.
inline constexpr std::size_t kLongestSlcanLine = 32;

/// The frame of a line such as `t12320A0B`, without its end; nothing when it is none.
[[nodiscard]] std::optional<CanFrame> read_slcan(std::string_view line);

/// A frame's line, with its end. @pre it has at most eight bytes
[[nodiscard]] std::string slcan_line(const CanFrame& frame);

}  // namespace hal::host
