#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace sim::drawing {

/// Returns whether bytes begin as gzip does. An SVGZ file is an SVG in gzip.
[[nodiscard]] bool is_gzip(std::string_view bytes);

/// Returns the content of gzip data; nothing if they are damaged or cut off, or if the content is
/// longer than `max_bytes`.
[[nodiscard]] std::optional<std::string> gunzip(std::string_view bytes, std::size_t max_bytes);

}  // namespace sim::drawing
