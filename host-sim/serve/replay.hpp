#pragma once

#include <optional>
#include <string>

#include "host-sim/serve/conversation.hpp"

namespace sim {

/// Repeats a conversation with a fresh controller in virtual time, and returns the repeated
/// conversation. The controller receives the same bytes at the same times as the recorded
/// controller. Its output is the same in every run. Throws std::invalid_argument for a setting that
/// is refused.
[[nodiscard]] Conversation replay(const Conversation& recorded);

/// First difference between the output of two controllers.
struct Difference {
  std::size_t line = 0;  ///< Line in the recording's file.
  /// Line of the recorded output that differs; empty if the recorded controller wrote nothing more.
  std::string expected;
  std::string said;

  bool operator==(const Difference&) const = default;
};

/// Returns the first difference between two outputs, byte for byte; nothing if there is none. The
/// version in `$I` is never compared, because recordings outlive commits.
/// @param with_times whether times are compared, too; otherwise only the bytes are compared
[[nodiscard]] std::optional<Difference> first_difference(const Conversation& expected,
                                                         const Conversation& said,
                                                         bool with_times);

}  // namespace sim
