#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "host-sim/import/place.hpp"

namespace sim::drawing {

/// The sizes, in user units, to which percentages and lengths in em refer.
struct SvgViewport {
  double width = 100.0;
  double height = 100.0;
  double em = 16.0;  ///< Size of the font, in user units.
};

enum class SvgDirection : std::uint8_t { kAcross, kUpright, kOther };

/// Returns a length in user units, which are px; nothing if the text is no length.
[[nodiscard]] std::optional<double> svg_length(std::string_view text,
                                               const SvgViewport& viewport,
                                               SvgDirection direction);

/// Returns the product of a list of transforms, with or without the units of style sheets; nothing
/// if one of them cannot be read.
[[nodiscard]] std::optional<Transform> svg_transform(std::string_view text);

struct SvgViewBox {
  Place origin;
  Place size;
};

/// Returns the box that a `viewBox` gives; nothing if it is no box with a size.
[[nodiscard]] std::optional<SvgViewBox> svg_view_box(std::string_view text);

/// Returns the map of the box into a viewport at the origin, as `preserveAspectRatio` requires.
[[nodiscard]] Transform svg_fit(const SvgViewBox& box,
                                const SvgViewport& viewport,
                                std::string_view aspect);

/// Returns the point that `transform-origin` gives in a viewport; nothing if the text is no point.
[[nodiscard]] std::optional<Place> svg_origin(std::string_view text, const SvgViewport& viewport);

}  // namespace sim::drawing
