#include "host-sim/cut/late_cuts.hpp"

#include <fmt/format.h>

#include <map>
#include <string>
#include <utility>

namespace sim::cut {
namespace {

using drawing::Drawing;
using drawing::Fault;
using drawing::FaultKind;

/// Contours that are cut too late: the number of the first one, and the count of all of them.
struct LateContours {
  std::size_t contour = 0;
  std::size_t count = 0;
};
/// Late contours by two numbers: the layer (or part) that the required order puts first, and the
/// layer (or part) inside it.
using LateByPair = std::map<std::pair<std::size_t, std::size_t>, LateContours>;

void note(LateByPair& late, std::size_t first, std::size_t inner, std::size_t contour) {
  LateContours& found = late[{first, inner}];
  if (found.count == 0) found.contour = contour;
  ++found.count;
}

std::string others(const LateContours& late) {
  if (late.count == 1) return "";
  return fmt::format(" (and {} more contour{})", late.count - 1, late.count == 2 ? "" : "s");
}

std::string name_of_layer(const Drawing& drawn, std::size_t layer) {
  const drawing::Layer& named = drawn.layers[layer];
  return named.name.empty() ? named.colour : fmt::format("\"{}\"", named.name);
}

Fault fault_of_layers(const Drawing& drawn, std::size_t inner, const LateContours& late) {
  const drawing::DrawnContour& contour = drawn.contours[late.contour];
  return {FaultKind::kIgnored,
          contour.entity,
          drawing::start_of(contour.shapes.front()),
          fmt::format("is cut after the layer {}, of a later rank, because it encloses contours of "
                      "that layer{}",
                      name_of_layer(drawn, inner),
                      others(late)),
          "give the outer layer no lower rank than the layer inside it"};
}

Fault fault_of_parts(const Drawing& drawn, std::size_t inner, const LateContours& late) {
  const drawing::DrawnContour& contour = drawn.contours[late.contour];
  const bool is_wish = drawn.turns.is_order_of_file;
  return {
      is_wish ? FaultKind::kIgnored : FaultKind::kBadEntity,
      contour.entity,
      drawing::start_of(contour.shapes.front()),
      fmt::format("{} is inside it and is to be cut later, but inner parts come first{}",
                  drawn.parts[inner],
                  others(late)),
      is_wish ? "list parts inside of another part first" : "mend the \"after\" of these parts"};
}

}  // namespace

std::vector<Fault> late_cuts(const Drawing& drawn,
                             const std::vector<Cut>& cuts,
                             const std::vector<UnbegunCut>& unbegun) {
  LateByPair layers;
  LateByPair parts;
  for (std::size_t i = 0; i < unbegun.size(); ++i) {
    const CutTurn turn = wished_turn(unbegun[i], Grouping::kNone);
    const std::size_t contour = cuts[i].contour;
    for (const std::size_t before : unbegun[i].after) {
      const CutTurn inner = wished_turn(unbegun[before], Grouping::kNone);
      if (inner <= turn) continue;
      if (inner.rank > turn.rank) {
        note(layers, unbegun[i].layer, unbegun[before].layer, contour);
      } else {
        const drawing::Entity& within = drawn.contours[cuts[before].contour].entity;
        note(parts, drawn.contours[contour].entity.part, within.part, contour);
      }
    }
  }
  std::vector<Fault> faults;
  for (const auto& [pair, late] : layers) {
    faults.push_back(fault_of_layers(drawn, pair.second, late));
  }
  for (const auto& [pair, late] : parts) {
    faults.push_back(fault_of_parts(drawn, pair.second, late));
  }
  return faults;
}

}  // namespace sim::cut
