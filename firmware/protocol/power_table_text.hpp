#pragma once

#include <cstdint>
#include <string_view>

#include "firmware/protocol/reply.hpp"
#include "planner/motion/block/power_table.hpp"

namespace cnc {

/// Reason why a power table was refused.
struct PowerTableRefusal {
  std::uint32_t column = 0;  ///< Column of the text, from 0.
  std::string_view reason{};
};

/// Reads `10:0,50:18.5,100:40`: duty in percent, to the hundredth, and watts, to the thousandth, of
/// up to 16 points in rising order. An empty text is a table without points.
[[nodiscard]] Result<motion::PowerTable, PowerTableRefusal> read_power_table(std::string_view text);

/// Writes a table in the form that read_power_table() reads.
void put_power_table(Reply& reply, const motion::PowerTable& table);

}  // namespace cnc
