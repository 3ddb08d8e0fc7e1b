#pragma once

#include <optional>
#include <string>

#include "host-sim/serve/conversation.hpp"

namespace sim {

/// Has the conversation again with a fresh controller in virtual time: it hears
/// the same bytes at the same times, and what it says is the result. The same
/// in every run. Throws std::invalid_argument for a setting that is refused.
[[nodiscard]] Conversation replay(const Conversation& recorded);

/// Where two controllers said different things.
struct Difference {
  std::size_t line = 0;  ///< Of the recording.
  std::string expected;  ///< The line in which it differs; empty when it said nothing more.
  std::string said;

  bool operator==(const Difference&) const = default;
};

/// The first difference in what was said, byte for byte. Times count only when
/// they are asked for: an answer a millisecond later is no other answer. The version in `$I`
/// never counts: recordings outlive commits.
[[nodiscard]] std::optional<Difference> first_difference(const Conversation& expected,
                                                         const Conversation& said,
                                                         bool with_times);

}  // namespace sim
