#include "host-sim/surface/box_tree.hpp"

#include <algorithm>
#include <numeric>

namespace sim::surface {
namespace {

using Box = Eigen::AlignedBox3d;

constexpr std::uint32_t kMaxInALeaf = 2;

/// A range of items, and the number of the node that will contain it.
struct Run {
  std::uint32_t node = 0;
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

Box bounds_of(const std::vector<Box>& boxes, const std::uint32_t* items, std::uint32_t count) {
  Box box;
  for (std::uint32_t i = 0; i < count; ++i) box.extend(boxes[items[i]]);
  return box;
}

}  // namespace

BoxTree::BoxTree(const std::vector<Box>& boxes) : items_(boxes.size()) {
  if (boxes.empty()) return;
  std::iota(items_.begin(), items_.end(), 0U);
  std::vector<Run> open{{0, 0, static_cast<std::uint32_t>(boxes.size())}};
  nodes_.emplace_back();
  while (!open.empty()) {
    const Run run = open.back();
    open.pop_back();
    std::uint32_t* items = items_.data() + run.first;
    const Box box = bounds_of(boxes, items, run.count);
    if (run.count <= kMaxInALeaf) {
      nodes_[run.node] = {box, run.first, run.count};
      continue;
    }
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    const std::uint32_t half = run.count / 2;
    std::nth_element(items, items + half, items + run.count, [&](std::uint32_t a, std::uint32_t b) {
      return boxes[a].center()[axis] < boxes[b].center()[axis];
    });
    const auto first = static_cast<std::uint32_t>(nodes_.size());
    nodes_[run.node] = {box, first, 0};
    nodes_.resize(nodes_.size() + 2);
    open.push_back({first, run.first, half});
    open.push_back({first + 1, run.first + half, run.count - half});
  }
}

}  // namespace sim::surface
