#include "host-sim/sheet/sheet_check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host-sim/import/curve_measure.hpp"
#include "host-sim/import/outline_box.hpp"
#include "planner/base/contract.hpp"

namespace sim::sheet {
namespace {

using drawing::Drawing;
using drawing::Fault;
using drawing::FaultKind;
using drawing::OutlineBox;
using drawing::Place;

/// Distance by which a part may reach beyond the stock without a fault, mm. It covers the rounding
/// of positions and chords.
constexpr double kStockSlackMm = 1.0e-3;

/// Greatest distance by which a part reaches beyond the stock, with its point and edge.
struct Excess {
  double mm = kStockSlackMm;
  Place place{0.0, 0.0};
  const char* edge = "";

  void look(double excess_mm, const Place& at, const char* name) {
    if (excess_mm <= mm) return;
    mm = excess_mm;
    place = at;
    edge = name;
  }
};

Fault beyond_stock(const Drawing& placed, std::size_t part, const Excess& excess) {
  const drawing::Stock& stock = *placed.stock;
  const std::string margin =
      stock.margin_mm > 0.0 ? fmt::format(" less its margin of {:g} mm", stock.margin_mm) : "";
  return {FaultKind::kTooMuch,
          {.name = placed.parts[part], .part = part},
          excess.place,
          fmt::format("is {:.3f} mm beyond the {} edge of the stock, {:g} by {:g} mm{}",
                      excess.mm,
                      excess.edge,
                      stock.width_mm,
                      stock.height_mm,
                      margin),
          "move the part, or take larger stock"};
}

std::vector<Fault> parts_beyond_stock(const Drawing& placed, std::span<const ContourUse> uses) {
  std::vector<Excess> excesses(placed.parts.size());
  const drawing::Stock& stock = *placed.stock;
  for (std::size_t i = 0; i < placed.contours.size(); ++i) {
    if (!uses[i].is_cut) continue;
    Excess& excess = excesses[placed.contours[i].entity.part];
    for (const Place& at : drawing::outline_of(placed.contours[i].shapes, kSheetChordMm)) {
      excess.look(stock.margin_mm - at.x(), at, "left");
      excess.look(at.x() - (stock.width_mm - stock.margin_mm), at, "right");
      excess.look(stock.margin_mm - at.y(), at, "lower");
      excess.look(at.y() - (stock.height_mm - stock.margin_mm), at, "upper");
    }
  }
  std::vector<Fault> faults;
  for (std::size_t part = 0; part < excesses.size(); ++part) {
    if (*excesses[part].edge != '\0') faults.push_back(beyond_stock(placed, part, excesses[part]));
  }
  return faults;
}

Fault fault_of(const Drawing& placed, const PartPair& pair, double kerf_mm) {
  Fault fault{FaultKind::kCrossing,
              {.name = placed.parts[pair.parts.second], .part = pair.parts.second},
              pair.place,
              {},
              "move one of them"};
  const std::string& other = placed.parts[pair.parts.first];
  if (pair.overlap) {
    fault.reason = fmt::format("overlaps {}", other);
  } else {
    fault.reason = fmt::format("is {:.3f} mm from {}, nearer than the kerf of {:.3f} mm",
                               pair.distance_mm,
                               other,
                               kerf_mm);
  }
  return fault;
}

}  // namespace

std::vector<Fault> check_places(const Drawing& placed, std::span<const ContourUse> uses) {
  CNC_ASSERT(uses.size() == placed.contours.size());
  std::vector<Fault> faults;
  if (placed.stock) faults = parts_beyond_stock(placed, uses);
  double kerf_mm = 0.0;
  for (const ContourUse& use : uses) {
    if (use.is_edge) kerf_mm = std::max(kerf_mm, use.kerf_mm);
  }
  for (const PartPair& pair : near_parts(placed, uses, drawing::kMaxFaults)) {
    faults.push_back(fault_of(placed, pair, kerf_mm));
  }
  if (faults.size() > drawing::kMaxFaults) faults.resize(drawing::kMaxFaults);
  return faults;
}

}  // namespace sim::sheet
