#pragma once

#include <functional>
#include <string>

#include "host-sim/import/drawing.hpp"
#include "host-sim/import/place.hpp"
#include "host-sim/sheet/sheet_file.hpp"

namespace sim::sheet {

/// Function that returns the text of a file, or throws an exception that names the file. Its
/// argument is a name that resolved() returned.
using ReadText = std::function<std::string(const std::string&)>;

/// Returns the path by which a part's drawing can be read from the current folder. Names in a sheet
/// file are relative to the folder of that file. Names in a sheet from standard input are relative
/// to the current folder.
[[nodiscard]] std::string resolved(const Sheet& sheet, const std::string& drawing);

/// Returns the transform from the drawing to the sheet. Quarter turns are exact.
[[nodiscard]] drawing::Transform transform_of(const Placing& placing);

/// Draws the copies of all parts of a sheet as one drawing. Lines and arcs stay lines and arcs.
/// Layers with the same name and colour become one layer. Each copy is a separate part
/// (`Entity::part`, named in `Drawing::parts`), and its contours have names such as `bracket #2:
/// path "a"`. The faults are those of the sheet, and those of each drawing. The faults of a drawing
/// are listed once, with the name of its part.
/// @pre options as read_drawing() requires
[[nodiscard]] drawing::Drawing place_parts(const Sheet& sheet,
                                           const ReadText& read_text,
                                           const drawing::ImportOptions& options);

}  // namespace sim::sheet
