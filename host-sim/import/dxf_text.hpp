#pragma once

#include <string>

#include "host-sim/import/sketch.hpp"

namespace sim::drawing {

/// Returns the lines of an ASCII DXF file in UTF-8, with each `\U+XXXX` replaced by its character.
///
/// Text that is not UTF-8 is decoded with the code page of $DWGCODEPAGE. If $DWGCODEPAGE is missing
/// or unknown, ANSI_1252 is used. Adds notes to `sketch` if a code page was assumed, and if
/// characters were replaced by `?`.
[[nodiscard]] std::string utf8_of_dxf(std::string text, Sketch& sketch);

}  // namespace sim::drawing
