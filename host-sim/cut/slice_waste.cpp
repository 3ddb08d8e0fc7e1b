#include "host-sim/cut/slice_waste.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "host-sim/cut/drawn_strokes.hpp"
#include "host-sim/cut/freed_areas.hpp"
#include "host-sim/cut/lead.hpp"
#include "host-sim/cut/waste_map.hpp"

namespace sim::cut {
namespace {

/// Least length of a slice, mm. A shorter slice is not worth a pierce, because waste this narrow
/// breaks without a cut.
constexpr double kShortestSlice = 0.05;
constexpr double kReachInKerfs = 10.0;

/// Index of the areas inside closed lines that are cut. The waste of the sheet is outside of these
/// areas.
class InsideOfCuts {
 public:
  InsideOfCuts(const CutPlan& plan, const drawing::Drawing& drawn, double cell_mm)
      : areas_{cell_mm} {
    for (const Cut& cut : plan.cuts) {
      const auto number = static_cast<std::uint32_t>(cut.contour);
      if (cut.is_slice || areas_.has(number) || !drawn.contours[cut.contour].closed) continue;
      auto loop = strokes_of(drawn.contours[cut.contour], plan.curves).strokes;
      if (length_of(loop) <= kShortestSlice) continue;
      areas_.add(number, std::make_shared<LoopArea>(std::move(loop)));
    }
  }

  [[nodiscard]] bool has(const Place& place) const {
    return areas_.visit_near(
        box_between(place, place),
        [&place](std::uint32_t, const LoopArea& area) { return area.contains(place); });
  }

 private:
  FreedAreas areas_;
};

LoopArea::Box sheet_of(const CutPlan& plan, const SliceRules& rules) {
  if (rules.stock) return *rules.stock;
  LoopArea::Box box = box_around(plan.cuts.front().strokes.front());
  for (const Cut& cut : plan.cuts) {
    for (const Stroke& stroke : cut.strokes) box.include(box_around(stroke));
  }
  const LoopArea::Box sheet = grown(box, rules.margin_mm);
  return {box.x0 >= 0.0 ? std::max(sheet.x0, 0.0) : sheet.x0,
          box.y0 >= 0.0 ? std::max(sheet.y0, 0.0) : sheet.y0,
          sheet.x1,
          sheet.y1};
}

/// Returns the layer whose settings slices have. It is the layer of the last cut at an offset from
/// its line, or if there is none, of the last cut.
std::size_t layer_of_slices(const CutPlan& plan) {
  for (auto cut = plan.cuts.rbegin(); cut != plan.cuts.rend(); ++cut) {
    if (plan.plan_of(*cut).settings.side == Side::kWaste) return cut->layer;
  }
  return plan.cuts.back().layer;
}

/// Appends slices along straight lines across the sheet.
class Slicing {
 public:
  Slicing(CutPlan& plan, const drawing::Drawing& drawn, double piece_mm)
      : plan_{plan},
        layer_{layer_of_slices(plan)},
        kerf_mm_{plan.layers[layer_].condition.kerf_mm},
        waste_{plan, drawn, kReachInKerfs * kerf_mm_},
        inside_{plan, drawn, piece_mm} {}

  void slice(const Place& from, const Place& to) {
    const double length = drawing::distance(from, to);
    for (const auto& [begin, end] : waste_.clear_stretches(from, to, kerf_mm_)) {
      const auto at = [&](double mm) -> Place { return from + mm / length * (to - from); };
      if (end - begin < kShortestSlice || inside_.has(at(0.5 * (begin + end)))) continue;
      add({at(begin), at(end), 0.0, Purpose::kSlice});
    }
  }

 private:
  void add(const Stroke& line) {
    Cut cut{.contour = kNoContour, .layer = layer_};
    cut.is_slice = true;
    cut.after = {plan_.cuts.size() - 1};
    const double length = length_of(line);
    if (plan_.layers[layer_].settings.pierce_s > 0.0 && length > 2.0 * kPierceWayMm) {
      Stroke pierce = part_of(line, 0.0, kPierceWayMm / length);
      pierce.purpose = Purpose::kPierce;
      cut.strokes = {pierce, {pierce.to, line.to, 0.0, Purpose::kSlice}};
    } else {
      cut.strokes = {line};
    }
    ++plan_.safety.slices;
    plan_.safety.slices_mm += length;
    plan_.cuts.push_back(std::move(cut));
  }

  CutPlan& plan_;
  std::size_t layer_;
  double kerf_mm_;
  WasteMap waste_;
  InsideOfCuts inside_;
};

}  // namespace

void slice_waste(CutPlan& plan, const drawing::Drawing& drawn, const SliceRules& rules) {
  plan.safety.slices_waste = true;
  if (plan.cuts.empty()) return;
  const LoopArea::Box sheet = sheet_of(plan, rules);
  const double width = sheet.x1 - sheet.x0;
  const double height = sheet.y1 - sheet.y0;
  Slicing slicing{plan, drawn, rules.piece_mm};
  bool is_back = false;
  const auto slice = [&](const Place& from, const Place& to) {
    is_back ? slicing.slice(to, from) : slicing.slice(from, to);
    is_back = !is_back;
  };
  const double columns = std::ceil(width / rules.piece_mm);
  for (double i = 1.0; i < columns; i += 1.0) {
    const double x = sheet.x0 + i / columns * width;
    slice({x, sheet.y0}, {x, sheet.y1});
  }
  const double rows = std::ceil(height / rules.piece_mm);
  for (double i = 1.0; i < rows; i += 1.0) {
    const double y = sheet.y0 + i / rows * height;
    slice({sheet.x0, y}, {sheet.x1, y});
  }
}

}  // namespace sim::cut
