#include "host-sim/contour/contour_offset.hpp"

#include <algorithm>
namespace sim {
namespace {

template <typename Item>
cnc::contour::Slice<Item> all_of(std::vector<Item>& items) {
  return {items.data(), items.size()};
}

}  // namespace

OpenContour::OpenContour()
    : std::runtime_error{"the offset does not close; do loops of the input cross each other?"} {}

void ContourOffset::grow(std::size_t elements, std::size_t cuts) {
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
  result_.resize(sizes.pieces());
  result_ends_.resize(sizes.pieces());
}

cnc::contour::ContourView<double> ContourOffset::offset(
    const cnc::contour::ContourView<double>& input, double distance_mm) {
  using cnc::contour::OffsetFault;
  if (elements_ < input.vertices.size()) {
    grow(input.vertices.size(), std::max(cut_count_, 4 * input.vertices.size()));
  }
  for (;;) {
    const cnc::contour::OffsetSpace<double> space{all_of(vertices_),
                                                  all_of(curves_),
                                                  all_of(element_boxes_),
                                                  all_of(raw_),
                                                  all_of(raw_boxes_),
                                                  all_of(nodes_),
                                                  all_of(cuts_),
                                                  all_of(sorted_cuts_),
                                                  all_of(first_cuts_),
                                                  all_of(pieces_),
                                                  all_of(runs_),
                                                  all_of(junctions_),
                                                  all_of(queue_)};
    cnc::contour::ContourWriter<double> out{all_of(result_), all_of(result_ends_)};
    const auto result = cnc::contour::offset<double>(input, distance_mm, space, out);
    if (result.ok()) return result.value();
    switch (result.error().fault) {
      case OffsetFault::kNotANumber:
        throw std::invalid_argument{"a coordinate, a bulge or the distance is not finite"};
      case OffsetFault::kNotClosed:
        throw OpenContour{};
      case OffsetFault::kTooManyElements:
      case OffsetFault::kResultTooLong:
        grow(2 * elements_ + 8, cut_count_ + 16);
        break;
      case OffsetFault::kTooManyMeetings:
        grow(elements_, 2 * cut_count_ + 16);
        break;
    }
  }
}

}  // namespace sim
