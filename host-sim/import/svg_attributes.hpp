#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "host-sim/import/place.hpp"

namespace sim::drawing {

/// What percentages and lengths in em are of, in user units.
struct SvgViewport {
  double width = 100.0;
  double height = 100.0;
  double em = 16.0;  ///< Size of the font.
};

enum class SvgDirection : std::uint8_t { kAcross, kUpright, kOther };

/// A length in user units, of which a px is one; nothing where it is none.
[[nodiscard]] std::optional<double> svg_length(std::string_view text,
                                               const SvgViewport& viewport,
                                               SvgDirection direction);

/// A list of transforms, of attributes or with the units of style sheets; nothing where one of
/// them is none.
[[nodiscard]] std::optional<Transform> svg_transform(std::string_view text);

struct SvgViewBox {
  Place origin;
  Place size;
};

/// Nothing where it is no box with a size.
[[nodiscard]] std::optional<SvgViewBox> svg_view_box(std::string_view text);

/// Maps the box into a viewport at the origin, as preserveAspectRatio says.
[[nodiscard]] Transform svg_fit(const SvgViewBox& box,
                                const SvgViewport& viewport,
                                std::string_view aspect);

/// The point that `transform-origin` names in a viewport; nothing where it is none.
[[nodiscard]] std::optional<Place> svg_origin(std::string_view text, const SvgViewport& viewport);

}  // namespace sim::drawing
