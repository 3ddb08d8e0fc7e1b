#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace sim::drawing {

/// Returns whether bytes begin with the mark of gzip. An SVGZ file is an SVG that is packed by
/// gzip.
[[nodiscard]] bool is_gzip(std::string_view bytes);

/// Returns the unpacked content of gzip data; nothing if the data are damaged or cut off, or if the
/// content is longer than `max_bytes`.
[[nodiscard]] std::optional<std::string> gunzip(std::string_view bytes, std::size_t max_bytes);

}  // namespace sim::drawing
