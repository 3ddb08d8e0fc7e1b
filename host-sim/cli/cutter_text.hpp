#pragma once

#include <string>
#include <string_view>

#include "host-sim/stock/cutter.hpp"

namespace sim {

/// Form of a milling tool in a call: diameter in mm and kind, or kind and diameter.
inline constexpr const char* kCutterForm = "D[,ball|,bull,CORNER|,v,ANGLE[,TIP]]";

/// Reads a tool from the value of an option: `6`, `6,ball`, `6,bull,0.5`, `6,v,60,0.2`, or the kind
/// first with colons, such as `ball:6` or `bull:6:0.5`. Throws std::invalid_argument with the
/// option and the reason.
[[nodiscard]] stock::Cutter cutter_of(const char* option, const std::string& text);

/// Refuses an option: throws std::invalid_argument with the option, its text and the reason.
[[noreturn]] void refuse_option(const char* option,
                                const std::string& text,
                                std::string_view reason);

/// Returns the finite number that `word` of an option's value stands for. Throws
/// std::invalid_argument with option and reason.
[[nodiscard]] double number_of(const char* option, const std::string& text, std::string_view word);

}  // namespace sim
