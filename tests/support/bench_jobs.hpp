#pragma once

#include <string>

namespace cnc::test {

/// The two files every benchmark speaks of; the same text on every machine.

/// `lines` G1 of 0.1 mm along a smooth closed curve, F6000.
[[nodiscard]] std::string freeform_job(int lines);

/// `arcs` tangent quarter circles of radius 2…5 mm in a meander, F6000.
[[nodiscard]] std::string arc_job(int arcs);

}  // namespace cnc::test
