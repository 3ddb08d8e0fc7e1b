#include "host-sim/contour/owned_offset_space.hpp"

namespace sim {

void OwnedOffsetSpace::grow(std::size_t elements, std::size_t cuts) {
  elements_ = elements;
  cut_count_ = cuts;
  const cnc::contour::OffsetSizes sizes{elements, cuts};
  vertices_.resize(elements);
  curves_.resize(elements);
  element_boxes_.resize(sizes.element_boxes());
  raw_.resize(sizes.raw());
  raw_boxes_.resize(sizes.raw_boxes());
  nodes_.resize(sizes.nodes());
  cuts_.resize(cuts);
  sorted_cuts_.resize(cuts);
  first_cuts_.resize(sizes.raw() + 1);
  pieces_.resize(sizes.pieces());
  runs_.resize(sizes.pieces());
  junctions_.resize(sizes.nodes());
  queue_.resize(sizes.nodes());
}

cnc::contour::OffsetSpace<double> OwnedOffsetSpace::space() {
  return {slice_of(vertices_),
          slice_of(curves_),
          slice_of(element_boxes_),
          slice_of(raw_),
          slice_of(raw_boxes_),
          slice_of(nodes_),
          slice_of(cuts_),
          slice_of(sorted_cuts_),
          slice_of(first_cuts_),
          slice_of(pieces_),
          slice_of(runs_),
          slice_of(junctions_),
          slice_of(queue_)};
}

}  // namespace sim
