#pragma once

#include <algorithm>

#include "firmware/machine/machine_types.hpp"

namespace cnc {

/// State that the operator changes: switches, which realtime bytes and `$B` toggle, and overrides.
/// A switch keeps its state until it is toggled again. A reset or the end of the program resets the
/// overrides.
struct OperatorSwitches {
  bool optional_stop = false;        ///< Whether M1 pauses.
  bool single_block = false;         ///< Whether the machine pauses after each line.
  bool block_delete_turned = false;  ///< Whether block delete is the opposite of $890.

  OverridePercent overrides{};  ///< Overrides, within their ranges.

  void toggle_optional_stop() { optional_stop = !optional_stop; }
  void toggle_single_block() { single_block = !single_block; }
  /// Sets the overrides, each clamped to its range.
  void set_overrides(const OverridePercent& percent) {
    overrides = {.feed = std::clamp(percent.feed, 10, 200),
                 .rapid = std::clamp(percent.rapid, 5, 100),
                 .power = std::clamp(percent.power, 10, 200)};
  }
};

}  // namespace cnc
