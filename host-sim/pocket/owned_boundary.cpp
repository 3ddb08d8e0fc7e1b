#include "host-sim/pocket/owned_boundary.hpp"

#include <utility>

namespace sim::pocket {

OwnedBoundary::OwnedBoundary(Contour contour)
    : contour_{std::move(contour)},
      curves_(contour_.vertices.size()),
      boxes_(cnc::contour::BoxTree<double>::size_for(contour_.vertices.size())),
      nearest_{slice_of(curves_), slice_of(boxes_)} {
  const bool has_space = nearest_.read(contour_.view());
  CNC_ASSERT(has_space);
}

}  // namespace sim::pocket
