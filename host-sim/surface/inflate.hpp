#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace sim::surface {

/// Returns the `size` bytes that a stream in the format of zlib (RFC 1950) decompresses to; nothing
/// where it is damaged or of another size. Compressed bytes become a thousand times as many at
/// most, so a short stream of a great size is refused before memory is reserved.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> inflated(std::string_view stream,
                                                                std::size_t size);

}  // namespace sim::surface
