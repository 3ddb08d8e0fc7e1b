#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace sim::drawing {

/// Returns whether bytes begin as gzip does: an SVGZ is an SVG in it.
[[nodiscard]] bool is_gzip(std::string_view bytes);

/// Unpacks gzip. Nothing where it is damaged, cut off, or longer than `most_bytes`.
[[nodiscard]] std::optional<std::string> gunzip(std::string_view bytes, std::size_t most_bytes);

}  // namespace sim::drawing
