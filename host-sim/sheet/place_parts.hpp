#pragma once

#include <functional>
#include <string>

#include "host-sim/import/drawing.hpp"
#include "host-sim/import/place.hpp"
#include "host-sim/sheet/sheet_file.hpp"

namespace sim::sheet {

/// Returns the text of the file, or throws an exception that names it. The argument is the name
/// that resolved() returns.
using ReadText = std::function<std::string(const std::string&)>;

/// Returns the name of a part's drawing for the current folder: names in a sheet file begin at the
/// folder of the file; those in a sheet from standard input at the current one.
[[nodiscard]] std::string resolved(const Sheet& sheet, const std::string& drawing);

/// Returns the map from the drawing to the sheet. Quarter turns are exact.
[[nodiscard]] drawing::Transform transform_of(const Placing& placing);

/// Draws the copies of all parts of a sheet as one drawing. Lines and arcs stay what they are;
/// layers of the same name and colour are one. Each copy is a part of its own (`Entity::part`,
/// named in `Drawing::parts`), and its contours are called `bracket #2: path "a"`. Faults are those
/// of the sheet, and those of each drawing once, with the name of its part.
/// @pre as of read_drawing()
[[nodiscard]] drawing::Drawing place_parts(const Sheet& sheet,
                                           const ReadText& read_text,
                                           const drawing::ImportOptions& options);

}  // namespace sim::sheet
