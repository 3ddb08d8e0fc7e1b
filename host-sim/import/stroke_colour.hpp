#pragma once

#include <string_view>

namespace sim::drawing {

/// Colour given to letters of single strokes in place of their own, so that rules can name them.
inline constexpr std::string_view kStrokeTextColour = "text";
/// Colour given to pictures, which have no colour of their own.
inline constexpr std::string_view kPictureColour = "image";

}  // namespace sim::drawing
