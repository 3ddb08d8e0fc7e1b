#include "host-sim/contour/contour_offset.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace sim {
namespace {

template <typename Item>
cnc::contour::Slice<Item> all_of(std::vector<Item>& items) {
  return {items.data(), items.size()};
}

/// Where most vertices lie in a square with the distance as its side, and how many.
struct Crowd {
  drawing::Place place{0.0, 0.0};
  std::size_t vertices = 0;
};

Crowd densest(const cnc::contour::ContourView<double>& input, double side_mm) {
  std::unordered_map<std::uint64_t, std::size_t> counts;
  Crowd crowd;
  for (const ContourVertex& vertex : input.vertices) {
    const double x = std::floor(vertex.x / side_mm);
    const double y = std::floor(vertex.y / side_mm);
    const auto column = static_cast<std::uint64_t>(static_cast<std::int64_t>(x));
    const auto row = static_cast<std::uint64_t>(static_cast<std::int64_t>(y));
    const std::size_t count = ++counts[column * 0x9E37'79B9'7F4A'7C15U ^ row];
    if (count > crowd.vertices) crowd = {vertex.point(), count};
  }
  return crowd;
}

[[noreturn]] void refuse_crowd(const cnc::contour::ContourView<double>& input,
                               double distance_mm,
                               std::size_t most_meetings) {
  const double side_mm = std::abs(distance_mm);
  const Crowd crowd = densest(input, side_mm);
  throw NoOffset{crowd.place,
                 fmt::format("offset by {:g} mm, its elements cross each other more than {} times; "
                             "most lie here, {} in a square of {:g} mm",
                             distance_mm,
                             most_meetings,
                             crowd.vertices,
                             side_mm),
                 "simplify it there, or leave out what the tool does not reach"};
}

}  // namespace

NoOffset::NoOffset(const drawing::Place& place, std::string reason, std::string remedy)
    : std::runtime_error{fmt::format(
          "at {:.3f} {:.3f}: {}; {}", place.x(), place.y(), reason, remedy)},
      place_{place},
      reason_{std::move(reason)},
      remedy_{std::move(remedy)} {}

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
    constexpr std::size_t kMostAtFirst = 400'000;
    const std::size_t cuts = std::min(4 * input.vertices.size(), kMostAtFirst);
    grow(input.vertices.size(), std::max(cut_count_, std::min(cuts, most_meetings_)));
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
        throw NoOffset{input.vertices[0].point(),
                       "the offset of the contour that begins here, or of one with it, does not "
                       "close",
                       "do loops of it cross each other? take them apart"};
      case OffsetFault::kTooManyElements:
      case OffsetFault::kResultTooLong:
        grow(2 * elements_ + 8, cut_count_ + 16);
        break;
      case OffsetFault::kTooManyMeetings:
        if (cut_count_ >= most_meetings_) refuse_crowd(input, distance_mm, most_meetings_);
        grow(elements_, std::min(4 * cut_count_ + 16, most_meetings_));
        break;
    }
  }
}

}  // namespace sim
