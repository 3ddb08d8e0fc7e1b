#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <string>

#include "host-sim/machine/simulator.hpp"

namespace proof {

/// Returns a word of G-code with a resolution of a nanometre.
inline std::string word(char letter, double value) {
  char text[40];
  std::snprintf(text, sizeof text, " %c%.6f", letter, value);
  return text;
}

/// Changes a setting, and expects that the simulator accepts it.
inline void change(sim::Simulator& simulator, std::size_t number, double value) {
  EXPECT_EQ(simulator.change_setting(static_cast<std::uint16_t>(number), static_cast<float>(value)),
            "")
      << "$" << number << "=" << value;
}

}  // namespace proof
