#include "host-sim/contour/free_form_row.hpp"

#include <algorithm>

#include "planner/base/contract.hpp"

namespace sim {

FreeFormRow::FreeFormRow(std::span<const drawing::Shape> shapes) : shapes_{shapes} {
  CNC_ASSERT(!shapes.empty());
  std::size_t spans = 0;
  for (const drawing::Shape& shape : shapes) ends_.push_back(spans += drawing::span_count(shape));
}

cnc::contour::CurveJet FreeFormRow::at(std::size_t span, double share) const {
  const auto end = std::ranges::upper_bound(ends_, span);
  CNC_ASSERT(end != ends_.end());
  const auto index = static_cast<std::size_t>(end - ends_.begin());
  const std::size_t first = index == 0 ? 0 : ends_[index - 1];
  return jet(shapes_[index], span - first, share);
}

}  // namespace sim
