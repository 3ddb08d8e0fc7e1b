#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "host-sim/import/place.hpp"

namespace sim::drawing {

/// The sizes to which percentages and lengths in em refer, in user units.
struct SvgViewport {
  double width = 100.0;
  double height = 100.0;
  double em = 16.0;  ///< Size of the font, in user units.
};

enum class SvgDirection : std::uint8_t { kAcross, kUpright, kOther };

/// Returns a length in user units (px); nothing if the text is no length.
[[nodiscard]] std::optional<double> svg_length(std::string_view text,
                                               const SvgViewport& viewport,
                                               SvgDirection direction);

/// Returns the product of a list of transforms, whose numbers may have the units of style sheets;
/// nothing if one of the transforms cannot be read.
[[nodiscard]] std::optional<Transform> svg_transform(std::string_view text);

struct SvgViewBox {
  Place origin;
  Place size;
};

/// Returns the box that a `viewBox` gives; nothing if the text is no box with width and height.
[[nodiscard]] std::optional<SvgViewBox> svg_view_box(std::string_view text);

/// Returns the map from the box to a viewport at the origin, by the rules of `preserveAspectRatio`.
[[nodiscard]] Transform svg_fit(const SvgViewBox& box,
                                const SvgViewport& viewport,
                                std::string_view aspect);

/// Returns the point that `transform-origin` gives in a viewport; nothing if the text is no point.
[[nodiscard]] std::optional<Place> svg_origin(std::string_view text, const SvgViewport& viewport);

}  // namespace sim::drawing
