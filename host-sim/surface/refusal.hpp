#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace sim::surface {

/// Throws std::invalid_argument: `name:line: reason; remedy`. `line` is 0 for the whole file.
[[noreturn]] void refuse(const std::string& name,
                         std::size_t line,
                         std::string_view reason,
                         std::string_view remedy);

/// Returns `text` with control characters as `?`, at most 40 characters: a word of a file that is
/// safe in a message.
[[nodiscard]] std::string shown(std::string_view text);

}  // namespace sim::surface
