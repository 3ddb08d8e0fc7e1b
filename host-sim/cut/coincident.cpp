#include "host-sim/cut/coincident.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <map>

namespace sim::cut {

int depth_of(Side side) {
  switch (side) {
    case Side::kWaste:
      return 3;
    case Side::kOn:
      return 2;
    case Side::kMark:
      return 1;
    case Side::kFill:  // A filled area is engraved even if its outline is also cut.
    case Side::kImage:
    case Side::kSkip:
    case Side::kStart:
      break;
  }
  return 0;
}

std::vector<drawing::Fault> skip_coincident(const drawing::Drawing& drawn,
                                            std::vector<Side>& sides) {
  // Map from the first drawn contour of a group of coincident contours to the contour that is
  // selected from this group.
  std::map<std::size_t, std::size_t> deepest;
  for (std::size_t i = 0; i < drawn.contours.size(); ++i) {
    const auto& lies_on = drawn.contours[i].lies_on;
    if (!lies_on) continue;
    std::size_t& best = deepest.try_emplace(*lies_on, *lies_on).first->second;
    if (depth_of(sides[i]) > depth_of(sides[best])) best = i;
  }
  std::vector<drawing::Fault> warnings;
  for (std::size_t i = 0; i < drawn.contours.size(); ++i) {
    const auto found = deepest.find(drawn.contours[i].lies_on.value_or(i));
    if (found == deepest.end() || found->second == i || depth_of(sides[i]) == 0) continue;
    const drawing::Entity& kept = drawn.contours[found->second].entity;
    const drawing::Layer& layer = drawn.layers[kept.layer];
    sides[i] = Side::kSkip;
    warnings.push_back({drawing::FaultKind::kDuplicate,
                        drawn.contours[i].entity,
                        start_of(drawn.contours[i].shapes.front()),
                        fmt::format("lies on {} of line {}, layer \"{}\" {}",
                                    kept.name,
                                    kept.line,
                                    layer.name,
                                    layer.colour),
                        "it is left out, and the other contour is cut or engraved"});
  }
  return warnings;
}

}  // namespace sim::cut
