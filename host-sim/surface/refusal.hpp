#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace sim::surface {

/// Throws std::invalid_argument with `name:line: reason; remedy`. `line` is 0 if the fault is not
/// at a line; the message then has no line.
[[noreturn]] void refuse(const std::string& name,
                         std::size_t line,
                         std::string_view reason,
                         std::string_view remedy);

/// Returns at most 40 characters of `text` with `?` for control characters, so that a word from a
/// file cannot disturb a message.
[[nodiscard]] std::string shown(std::string_view text);

}  // namespace sim::surface
