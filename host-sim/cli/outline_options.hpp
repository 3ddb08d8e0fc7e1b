#pragma once

#include "host-sim/contour/outline.hpp"
#include "host-sim/import/drawing.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name.
class App;
}

namespace sim {

/// Adds `--tolerance` and `--fit`, which set how curves of a drawing become arcs.
void add_outline_options(CLI::App& command, OutlineOptions& outline);

/// Adds `--text skip|outline|stroke`: leave letters out, or cut them by outline or by single lines.
void add_text_option(CLI::App& command, drawing::TextMode& text);

}  // namespace sim
