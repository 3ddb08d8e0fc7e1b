#include "host-sim/import/drawing_unit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace sim::drawing {
namespace {

constexpr double kSmallestUsualMm = 3.0;
constexpr double kLargestUsualMm = 3000.0;

struct NamedUnit {
  std::string_view name;
  double mm;
};

// The units, the most likely ones first. 72dpi is the typographic point, and 90dpi is the pixel of
// old drawing programs.
constexpr auto kDrawingUnits = std::to_array<NamedUnit>({{"mm", 1.0},
                                                         {"inch", 25.4},
                                                         {"cm", 10.0},
                                                         {"m", 1000.0},
                                                         {"mil", 0.0254},
                                                         {"um", 0.001},
                                                         {"foot", 304.8},
                                                         {"96dpi", 25.4 / 96.0},
                                                         {"90dpi", 25.4 / 90.0},
                                                         {"72dpi", 25.4 / 72.0}});

bool is_usual(double size_mm) { return size_mm >= kSmallestUsualMm && size_mm <= kLargestUsualMm; }

/// Returns the name of the most likely unit with which the drawing would have a usual size; empty
/// if there is none.
std::string_view likely_unit(double size_mm, double mm_per_unit) {
  for (const NamedUnit& unit : kDrawingUnits) {
    if (unit.name.ends_with("dpi")) continue;
    if (is_usual(size_mm / mm_per_unit * unit.mm)) return unit.name;
  }
  return {};
}

/// Returns a text such as `63.5 by 20 mm`.
std::string size_text(double width_mm, double height_mm) {
  const auto rounded = [](double size_mm) {
    return size_mm < 1000.0 ? fmt::format("{:.3g}", size_mm) : fmt::format("{:.0f}", size_mm);
  };
  return fmt::format("{} by {} mm", rounded(width_mm), rounded(height_mm));
}

}  // namespace

std::string drawing_unit_names() {
  std::string names;
  for (const NamedUnit& unit : kDrawingUnits) {
    names += fmt::format("{}{}", names.empty() ? "" : ", ", unit.name);
  }
  return names;
}

std::optional<double> drawing_unit_mm(std::string_view name) {
  const auto* const found = std::ranges::find(kDrawingUnits, name, &NamedUnit::name);
  if (found == kDrawingUnits.end()) return {};
  return found->mm;
}

void question_scale(Sketch& sketch, const OutlineBox& box, double mm_per_unit) {
  const double size_mm = std::max(box.width(), box.height());
  if (!(size_mm > 0.0) || !std::isfinite(size_mm) || is_usual(size_mm)) return;
  const std::string_view likely = likely_unit(size_mm, mm_per_unit);
  const double factor = likely.empty() ? 1.0 : *drawing_unit_mm(likely) / mm_per_unit;
  std::string remedy = "if its unit is a different one, set it with --drawing-unit";
  if (!likely.empty()) {
    remedy = fmt::format("if its unit is {}, its size is {}: set the unit with --drawing-unit {}",
                         likely,
                         size_text(box.width() * factor, box.height() * factor),
                         likely);
  }
  sketch.note(fmt::format("the drawing is {}, which is unusually {}",
                          size_text(box.width(), box.height()),
                          size_mm > kLargestUsualMm ? "large" : "small"),
              {},
              std::move(remedy));
}

}  // namespace sim::drawing
