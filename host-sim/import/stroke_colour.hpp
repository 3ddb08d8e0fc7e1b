#pragma once

#include <string_view>

namespace sim::drawing {

/// The colour of letters that are single strokes, whatever theirs is, so that rules can name them.
inline constexpr std::string_view kStrokeTextColour = "text";
/// The colour of pictures, which have none of their own.
inline constexpr std::string_view kPictureColour = "image";

}  // namespace sim::drawing
