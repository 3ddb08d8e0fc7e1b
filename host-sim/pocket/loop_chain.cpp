#include "host-sim/pocket/loop_chain.hpp"

#include <algorithm>

#include "planner/contour/offset_space.hpp"
#include "planner/pocket/loop_measures.hpp"

namespace sim::pocket {
namespace {

using cnc::contour::kNone;

bool is_outline(const cnc::contour::ContourView<double>& area, std::size_t loop) {
  return cnc::pocket::signed_area(area, loop) > 0.0;
}

/// Returns the only loop of the area `around` that matches a loop of the area `inner`: an outline
/// around an outline, or a hole within a hole.
std::optional<std::size_t> match_of(const cnc::contour::ContourView<double>& inner,
                                    std::size_t loop,
                                    const cnc::contour::ContourView<double>& around) {
  const bool outline = is_outline(inner, loop);
  std::optional<std::size_t> match;
  for (std::size_t i = 0; i < around.loop_ends.size(); ++i) {
    if (is_outline(around, i) != outline) continue;
    const cnc::WideVec2 place = around.vertices[around.loop_begin(i)].point();
    if (!outline && cnc::pocket::turns_around(inner, loop, place) == 0) continue;
    if (match) return std::nullopt;
    match = i;
  }
  return match;
}

}  // namespace

PassTree::PassTree(const std::vector<Contour>& passes, const std::vector<std::uint32_t>& parents)
    : passes_{passes}, parents_{parents}, children_(passes.size()) {
  for (std::uint32_t i = 0; i < passes.size(); ++i) {
    if (parents[i] != kNone) children_[parents[i]].push_back(i);
  }
  for (auto i = static_cast<std::uint32_t>(passes.size()); i-- > 0;) {
    if (parents[i] != kNone) continue;
    const std::vector<std::uint32_t> all = within(i);
    inner_first_.insert(inner_first_.end(), all.begin(), all.end());
  }
  std::ranges::reverse(inner_first_);
}

std::optional<std::uint32_t> PassTree::only_child(std::uint32_t pass) const {
  if (children_[pass].size() != 1) return std::nullopt;
  return children_[pass].front();
}

std::vector<std::uint32_t> PassTree::within(std::uint32_t pass) const {
  std::vector<std::uint32_t> found;
  std::vector<std::uint32_t> left{pass};
  while (!left.empty()) {
    const std::uint32_t next = left.back();
    left.pop_back();
    found.push_back(next);
    left.insert(left.end(), children_[next].begin(), children_[next].end());
  }
  return found;
}

std::optional<PassLoop> PassTree::around(const PassLoop& inner) const {
  const std::uint32_t pass = parents_[inner.pass];
  if (pass == kNone || parents_[pass] == kNone || !only_child(pass)) return std::nullopt;
  const auto within = passes_[inner.pass].view();
  const auto around = passes_[pass].view();
  if (within.loop_ends.size() != around.loop_ends.size()) return std::nullopt;
  // Only if every loop has its own match, nothing except rings is between the passes.
  std::optional<std::size_t> match;
  for (std::size_t i = 0; i < within.loop_ends.size(); ++i) {
    const std::optional<std::size_t> of_this = match_of(within, i, around);
    if (!of_this) return std::nullopt;
    if (i == inner.loop) match = of_this;
  }
  return PassLoop{pass, *match};
}

}  // namespace sim::pocket
