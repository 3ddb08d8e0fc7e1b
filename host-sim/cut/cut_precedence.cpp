#include "host-sim/cut/cut_precedence.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace sim::cut {
namespace {

/// Returns the innermost contours around a contour whose cuts free the material inside them. An
/// open contour that runs through several contours may have several of them.
std::set<std::size_t> freed_around(const drawing::Drawing& drawn,
                                   const std::vector<Outline>& outlines,
                                   std::size_t contour) {
  std::set<std::size_t> found;
  const auto look = [&](std::optional<std::size_t> around) {
    while (around && !outlines[*around].is_beside) around = drawn.contours[*around].lies_in;
    if (around) found.insert(*around);
  };
  look(drawn.contours[contour].lies_in);
  for (const std::size_t around : drawn.contours[contour].runs_through) look(around);
  return found;
}

}  // namespace

void put_parts_last(const drawing::Drawing& drawn,
                    const std::vector<Outline>& outlines,
                    std::vector<Cut>& cuts) {
  std::vector<std::vector<std::size_t>> cuts_of(outlines.size());
  for (std::size_t i = 0; i < cuts.size(); ++i) cuts_of[cuts[i].contour].push_back(i);
  const auto frees_less = [&cuts](std::size_t a, std::size_t b) {
    return std::abs(cuts[a].area_mm2) < std::abs(cuts[b].area_mm2);
  };
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    if (!outlines[i].is_beside || cuts_of[i].empty()) continue;
    const std::size_t last = *std::ranges::max_element(cuts_of[i], frees_less);
    for (const std::size_t other : cuts_of[i]) {
      if (other != last) cuts[last].after.push_back(other);
    }
  }
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    for (const std::size_t around : freed_around(drawn, outlines, i)) {
      for (const std::size_t inner : cuts_of[i]) {
        for (const std::size_t outer : cuts_of[around]) cuts[outer].after.push_back(inner);
      }
    }
  }
}

std::size_t part_of(const drawing::Drawing& drawn,
                    const std::vector<Outline>& outlines,
                    std::size_t contour) {
  std::size_t part = contour;
  for (auto around = drawn.contours[contour].lies_in; around;
       around = drawn.contours[*around].lies_in) {
    if (outlines[*around].is_beside) part = *around;
  }
  return part;
}

}  // namespace sim::cut
