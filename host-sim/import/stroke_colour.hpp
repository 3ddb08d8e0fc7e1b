#pragma once

#include <string_view>

namespace sim::drawing {

/// The colour of letters that are single strokes, whatever theirs is, so that rules can name them.
inline constexpr std::string_view kStrokeTextColour = "text";

}  // namespace sim::drawing
