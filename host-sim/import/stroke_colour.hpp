#pragma once

#include <string_view>

namespace sim::drawing {

/// Colour that replaces the colour of letters of single strokes, so that rules can name such
/// letters.
inline constexpr std::string_view kStrokeTextColour = "text";
/// Colour of the layers of pictures, because pictures have no colour in the drawing.
inline constexpr std::string_view kPictureColour = "image";

}  // namespace sim::drawing
