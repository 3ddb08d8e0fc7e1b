#pragma once

#include <random>
#include <vector>

#include "host-sim/trace/trace_row.hpp"

namespace sim {

/// Returns rows as a machine generates them. Time increases, motors make single steps in either
/// direction, sometimes several motors at the same time, and the output changes at times.
inline std::vector<TraceRow> random_rows(unsigned seed, std::size_t count) {
  std::mt19937 random{seed};
  std::uniform_int_distribution<std::uint64_t> wait_ns{2, 6'000};
  std::uniform_int_distribution<int> step{-1, 1};
  std::uniform_real_distribution<float> duty{0.0F, 1.0F};
  std::vector<TraceRow> rows;
  TraceRow row;
  for (std::size_t i = 0; i < count; ++i) {
    row.time_ns += wait_ns(random);
    for (std::int32_t& position : row.position) position += step(random);
    if (i % 7 == 0) row.duty = duty(random);
    rows.push_back(row);
  }
  return rows;
}

}  // namespace sim
