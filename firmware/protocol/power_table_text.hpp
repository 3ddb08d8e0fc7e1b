#pragma once

#include <cstdint>
#include <string_view>

#include "firmware/protocol/reply.hpp"
#include "planner/motion/block/power_table.hpp"

namespace cnc {

/// Reason for refusing a power table.
struct PowerTableRefusal {
  std::uint32_t column = 0;  ///< Index of the wrong character in the text, from 0.
  std::string_view reason{};
};

/// Reads a power table such as `10:0,50:18.5,100:40`: up to 16 points in rising order, each with
/// duty in percent (two decimals) and power in watts (three decimals). An empty text means a table
/// without points.
[[nodiscard]] Result<motion::PowerTable, PowerTableRefusal> read_power_table(std::string_view text);

/// Writes a table in the form that read_power_table() reads.
void put_power_table(Reply& reply, const motion::PowerTable& table);

}  // namespace cnc
