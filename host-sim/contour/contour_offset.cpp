#include "host-sim/contour/contour_offset.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "host-sim/contour/filled_loops.hpp"
#include "planner/pocket/loop_measures.hpp"

namespace sim {
namespace {

/// The most crowded square of a contour, whose side is the offset distance: one of its vertices,
/// and the number of vertices in it.
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
                               std::size_t max_meetings) {
  const double side_mm = std::abs(distance_mm);
  const Crowd crowd = densest(input, side_mm);
  throw NoOffset{crowd.place,
                 fmt::format("offset by {:g} mm, its elements cross each other more than {} times; "
                             "most elements are here, {} in a square of {:g} mm",
                             distance_mm,
                             max_meetings,
                             crowd.vertices,
                             side_mm),
                 "simplify the contour here, or leave out details that the tool does not reach"};
}

/// Measures of loops, which together bound the area that an offset adds or removes.
struct Measures {
  double area_mm2 = 0.0;
  double length_mm = 0.0;
  double turn = 0.0;  ///< Sum of the absolute angles by which arcs and corners turn, radians.
};

Measures measures_of(const cnc::contour::ContourView<double>& view) {
  Measures measures;
  for (std::size_t loop = 0; loop < view.loop_ends.size(); ++loop) {
    measures.area_mm2 += cnc::pocket::signed_area(view, loop);
    const std::uint32_t first = view.loop_begin(loop);
    const std::uint32_t count = view.loop_ends[loop] - first;
    const auto heading = [&](std::uint32_t index, double side) {
      const auto element = cnc::pocket::element_at(view, loop, index);
      const drawing::Place chord = element.end - element.start;
      return std::atan2(chord.y(), chord.x()) + side * 2.0 * std::atan(element.bulge);
    };
    double before = count == 0 ? 0.0 : heading(first + count - 1, 1.0);
    for (std::uint32_t i = first; i < first + count; ++i) {
      const auto element = cnc::pocket::element_at(view, loop, i);
      measures.length_mm += cnc::pocket::length_of(element);
      measures.turn += std::abs(4.0 * std::atan(element.bulge)) +
                       std::abs(std::remainder(heading(i, -1.0) - before, drawing::kFullTurn));
      before = heading(i, 1.0);
    }
  }
  return measures;
}

constexpr double kRoundingMm2 = 1.0e-6;

/// Returns whether the result of an offset is plausible. The material must have grown for a
/// positive distance, and shrunk for a negative one. The area must not have changed by more than
/// the area of strips along all elements and sectors at all corners. This check detects a loop that
/// was lost or reversed.
bool is_possible(const Measures& input,
                 const cnc::contour::ContourView<double>& result,
                 double distance_mm) {
  double area = 0.0;
  for (std::size_t loop = 0; loop < result.loop_ends.size(); ++loop) {
    area += cnc::pocket::signed_area(result, loop);
  }
  const double distance = std::abs(distance_mm);
  const double changed = (distance_mm > 0.0 ? 1.0 : -1.0) * (area - input.area_mm2);
  const double most = distance * (input.length_mm + 0.5 * input.turn * distance);
  const double rounding = kRoundingMm2 + 1.0e-9 * std::abs(input.area_mm2);
  return changed >= -rounding && changed <= most + rounding;
}

/// Returns the outlines of the area that loops fill. Returns nothing if filled_loops() fails, or if
/// it loses all of the area.
std::optional<Contour> outlines_of(const cnc::contour::ContourView<double>& input) {
  std::optional<Contour> outlines = filled_loops(input);
  const bool is_lost =
      outlines && outlines->loop_ends.empty() && measures_of(input).area_mm2 > kRoundingMm2;
  return is_lost ? std::nullopt : std::move(outlines);
}

}  // namespace

Contour copy_of(const cnc::contour::ContourView<double>& view) {
  return {{view.vertices.begin(), view.vertices.end()},
          {view.loop_ends.begin(), view.loop_ends.end()}};
}

NoOffset::NoOffset(const drawing::Place& place, std::string reason, std::string remedy)
    : std::runtime_error{fmt::format(
          "at {:.3f} {:.3f}: {}; {}", place.x(), place.y(), reason, remedy)},
      place_{place},
      reason_{std::move(reason)},
      remedy_{std::move(remedy)} {}

void ContourOffset::grow(std::size_t elements, std::size_t cuts) {
  space_.grow(elements, cuts);
  result_.resize(space_.pieces());
  result_ends_.resize(space_.pieces());
}

cnc::contour::ContourView<double> ContourOffset::offset(
    const cnc::contour::ContourView<double>& input, double distance_mm) {
  return offset_once_filled(input, distance_mm, false);
}

/// Returns the offset. If the offset does not close or is not plausible, the loops touch or cross.
/// The loops are then replaced by the outlines of the area that they fill, and the offset is
/// computed once more.
// Recurses at most once. NOLINTNEXTLINE(misc-no-recursion)
cnc::contour::ContourView<double> ContourOffset::offset_once_filled(
    const cnc::contour::ContourView<double>& input, double distance_mm, bool is_filled) {
  using cnc::contour::OffsetFault;
  if (space_.elements() < input.vertices.size()) {
    constexpr std::size_t kMaxAtFirst = 400'000;
    const std::size_t cuts = std::min(4 * input.vertices.size(), kMaxAtFirst);
    grow(input.vertices.size(), std::max(space_.cuts(), std::min(cuts, max_meetings_)));
  }
  for (;;) {
    cnc::contour::ContourWriter<double> out{slice_of(result_), slice_of(result_ends_)};
    const auto result = cnc::contour::offset<double>(input, distance_mm, space_.space(), out);
    if (result.ok() && is_possible(measures_of(input), result.value(), distance_mm)) {
      return result.value();
    }
    switch (result.ok() ? OffsetFault::kNotClosed : result.error().fault) {
      case OffsetFault::kNotANumber:
        throw std::invalid_argument{"a coordinate, a bulge or the distance is not finite"};
      case OffsetFault::kNotClosed:
        if (auto outlines = is_filled ? std::nullopt : outlines_of(input)) {
          filled_ = std::move(*outlines);
          return offset_once_filled(filled_.view(), distance_mm, true);
        }
        throw NoOffset{
            input.vertices[0].point(),
            "the offset of the contour that begins here, or of another contour, does not close",
            "separate loops that cross each other"};
      case OffsetFault::kTooManyElements:
      case OffsetFault::kResultTooLong:
        grow(2 * space_.elements() + 8, space_.cuts() + 16);
        break;
      case OffsetFault::kTooManyMeetings:
        if (space_.cuts() >= max_meetings_) refuse_crowd(input, distance_mm, max_meetings_);
        grow(space_.elements(), std::min(4 * space_.cuts() + 16, max_meetings_));
        break;
    }
  }
}

}  // namespace sim
