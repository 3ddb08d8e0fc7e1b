#pragma once

namespace cnc {

/// Switches that the operator toggles by realtime bytes and `$B`; they stay until toggled back.
struct OperatorSwitches {
  bool optional_stop = false;        ///< M1 pauses.
  bool single_block = false;         ///< The machine pauses after each line.
  bool block_delete_turned = false;  ///< Block delete is the opposite of $890.

  void toggle_optional_stop() { optional_stop = !optional_stop; }
  void toggle_single_block() { single_block = !single_block; }
};

}  // namespace cnc
