#pragma once

#include <string>

#include "host-sim/import/sketch.hpp"

namespace sim::drawing {

/// Returns the lines of an ASCII DXF file in UTF-8 with `\U+XXXX` replaced by its character.
///
/// Text that is no UTF-8 is taken in the code page of $DWGCODEPAGE, or in ANSI_1252 where that is
/// missing or unknown. Notes in `sketch` that a code page was assumed and that characters were
/// replaced by `?`.
[[nodiscard]] std::string utf8_of_dxf(std::string text, Sketch& sketch);

}  // namespace sim::drawing
