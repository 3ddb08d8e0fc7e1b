#pragma once

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "host-sim/import/curve_measure.hpp"
#include "host-sim/import/drawing.hpp"

namespace fuzz {

inline void require_drawn(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "violated: %s\n", what);
  std::abort();
}

/// Requires that a refusal names the file and gives a reason.
inline void require_refusal(const std::invalid_argument& refusal) {
  require_drawn(std::string{refusal.what()}.size() > 10, "a refusal has a reason");
}

inline void judge_contour(const sim::drawing::Drawing& drawn,
                          const sim::drawing::DrawnContour& contour) {
  using namespace sim::drawing;
  require_drawn(!contour.shapes.empty(), "a contour has curves");
  require_drawn(contour.entity.layer < drawn.layers.size(), "and a layer");
  require_drawn(!contour.parent || *contour.parent < drawn.contours.size(), "and a parent that is");
  require_drawn((contour.depth != 0) == contour.parent.has_value(), "where it is within others");
  require_drawn(std::isfinite(contour.length_mm) && contour.length_mm > 0.0, "it has a length");
  require_drawn(std::isfinite(contour.area_mm2), "its area is a number");
  const std::size_t count = contour.shapes.size();
  for (std::size_t i = 0; i < count; ++i) {
    require_drawn(finite(contour.shapes[i]), "every place is a number");
    if (i + 1 == count && !contour.closed) break;
    const Place end = end_of(contour.shapes[i]);
    const Place start = start_of(contour.shapes[(i + 1) % count]);
    const double size = 1.0 + end.cwiseAbs().maxCoeff();
    require_drawn(distance(end, start) <= 2.0e-6 + 1.0e-9 * size,
                  "each begins where the last ends");
  }
}

/// Reads any bytes as a drawing: nothing may crash, and a drawing that is read must be sound.
inline int judge_drawing(const std::uint8_t* data, std::size_t size) {
  const std::string text{reinterpret_cast<const char*>(data), size};
  // Poppler draws PDF pages. It has its own fuzzers, and is not instrumented here.
  if (text.find("%PDF") != std::string::npos) return 0;
  // Sanitizers make reading about twenty times slower, so the effort is small.
  const sim::drawing::ImportOptions options{.effort = 0.02,
                                            .text = static_cast<sim::drawing::TextMode>(size % 3)};
  const sim::drawing::Drawing drawn = sim::drawing::read_drawing("fuzz", text, options);
  for (const auto& contour : drawn.contours) judge_contour(drawn, contour);
  for (const auto& fault : drawn.faults) {
    require_drawn(!fault.place_mm || sim::drawing::is_finite(*fault.place_mm),
                  "faults have places");
    require_drawn(!to_string(fault, "fuzz").empty() && !fault.reason.empty(), "and reasons");
  }
  return 0;
}

}  // namespace fuzz
