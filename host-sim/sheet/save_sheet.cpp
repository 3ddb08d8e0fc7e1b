#include "host-sim/sheet/save_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "host-sim/import/curve_measure.hpp"
#include "host-sim/import/outline_box.hpp"
#include "host-sim/sheet/place_parts.hpp"

namespace sim::sheet {
namespace {

std::string named_from(const std::string& target, const std::string& file) {
  const std::filesystem::path folder =
      std::filesystem::absolute(target).lexically_normal().parent_path();
  return std::filesystem::absolute(file).lexically_normal().lexically_proximate(folder).string();
}

/// Returns a length that users read, rounded up to hundredths of a millimetre.
double rounded_up(double mm) { return std::ceil(100.0 * mm - 1.0e-6) / 100.0; }

}  // namespace

Sheet sheet_of(const drawing::Drawing& drawn, const std::string& target, double margin_mm) {
  drawing::OutlineBox box;
  for (const drawing::DrawnContour& contour : drawn.contours) {
    for (const Place& place : drawing::outline_of(contour.shapes, drawing::kChordToleranceMm)) {
      box.include(place);
    }
  }
  if (drawn.contours.empty()) box.include({0.0, 0.0});
  Placing placing;
  placing.at_mm = {rounded_up(std::max(0.0, margin_mm - box.least.x())),
                   rounded_up(std::max(0.0, margin_mm - box.least.y()))};
  const Place far = box.most + placing.at_mm + Place{margin_mm, margin_mm};
  SheetPart part{.name = std::filesystem::path{drawn.file}.stem().string(),
                 .drawing = named_from(target, drawn.file),
                 .places = {placing}};
  return {.file = target,
          .stock = Stock{.width_mm = std::max(rounded_up(far.x()), 0.1),
                         .height_mm = std::max(rounded_up(far.y()), 0.1),
                         .margin_mm = margin_mm},
          .parts = {std::move(part)}};
}

Sheet moved_to(const Sheet& sheet, const std::string& target) {
  Sheet moved = sheet;
  moved.file = target;
  for (SheetPart& part : moved.parts) {
    part.drawing = named_from(target, resolved(sheet, part.drawing));
  }
  return moved;
}

}  // namespace sim::sheet
