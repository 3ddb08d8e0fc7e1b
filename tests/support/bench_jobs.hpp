#pragma once

#include <string>

namespace cnc::test {

/// The two programs that all benchmarks use. Their text is the same on every machine.

/// Returns `lines` G1 of 0.1 mm along a smooth closed curve, at F6000.
[[nodiscard]] std::string freeform_job(int lines);

/// Returns `arcs` tangent quarter circles of radius 2…5 mm in a meander, at F6000.
[[nodiscard]] std::string arc_job(int arcs);

}  // namespace cnc::test
