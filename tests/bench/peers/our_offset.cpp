/// The planner's offset behind plain functions, so that JavaScript can call it as it calls the
/// peer. Cases are added once, then offset any number of times. See README.md.

#include <cmath>
#include <cstdlib>
#include <vector>

#include "planner/contour/offset.hpp"

namespace {

using namespace cnc::contour;
using cnc::Result;

struct Case {
  std::vector<Vertex<double>> vertices;
  std::vector<std::uint32_t> loop_ends;

  [[nodiscard]] ContourView<double> view() const {
    return {{vertices.data(), vertices.size()}, {loop_ends.data(), loop_ends.size()}};
  }
};

template <typename Item>
Slice<Item> all_of(std::vector<Item>& items) {
  return {items.data(), items.size()};
}

/// Storage that is reused and only grows, as in sim::ContourOffset. That class throws exceptions,
/// and cannot be compiled here.
class Offsetter {
 public:
  Result<ContourView<double>, OffsetError> offset(const ContourView<double>& input,
                                                  double distance_mm) {
    const std::size_t most = input.vertices.size() + 8;
    if (vertices_.size() < most) grow(most, 4 * most);
    for (;;) {
      const OffsetSpace<double> space{all_of(vertices_),
                                      all_of(elements_),
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
      ContourWriter<double> out{all_of(result_), all_of(result_ends_)};
      const auto result = cnc::contour::offset<double>(input, distance_mm, space, out);
      if (result.ok() || result.error().fault == OffsetFault::kNotANumber ||
          result.error().fault == OffsetFault::kNotClosed) {
        return result;
      }
      grow(2 * vertices_.size(), 4 * cuts_.size());
    }
  }

 private:
  void grow(std::size_t elements, std::size_t cuts) {
    const OffsetSizes sizes{elements, cuts};
    vertices_.resize(elements);
    elements_.resize(elements);
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

  std::vector<Vertex<double>> vertices_;
  std::vector<Curve<double>> elements_;
  std::vector<FlatBox<double>> element_boxes_;
  std::vector<RawCurve<double>> raw_;
  std::vector<FlatBox<double>> raw_boxes_;
  std::vector<Node<double>> nodes_;
  std::vector<Cut<double>> cuts_;
  std::vector<Cut<double>> sorted_cuts_;
  std::vector<std::uint32_t> first_cuts_;
  std::vector<Piece> pieces_;
  std::vector<Run> runs_;
  std::vector<Junction> junctions_;
  std::vector<std::uint32_t> queue_;
  std::vector<Vertex<double>> result_;
  std::vector<std::uint32_t> result_ends_;
};

// Cases that were added remain until the program ends.
std::vector<Case>& cases() {
  static std::vector<Case> kept;
  return kept;
}

ContourView<double> last_result;

/// Returns the area between an arc and its chord, positive to the right of the chord.
double segment_area(const Vertex<double>& from, const Vertex<double>& to) {
  const double quarter = std::atan(from.bulge);
  if (quarter == 0.0) return 0.0;
  const double square = (to.point() - from.point()).squaredNorm();
  const double sine = std::sin(2.0 * quarter);
  return square / (8.0 * sine * sine) * (4.0 * quarter - std::sin(4.0 * quarter));
}

}  // namespace

void cnc::contract_failed(const char*, const char*, int) { std::abort(); }

extern "C" {

/// Adds a case of one loop with space for `vertices` vertices, and returns its number.
int our_add(std::uint32_t vertices) {
  cases().push_back({std::vector<Vertex<double>>(vertices), {vertices}});
  return static_cast<int>(cases().size()) - 1;
}

/// Returns the address at which the case's vertices are to be written: x, y and bulge of each.
Vertex<double>* our_vertices(int number) {
  return cases()[static_cast<std::size_t>(number)].vertices.data();
}

/// Returns the number of loops of the offset, or a negative number if the offset failed.
int our_offset(int number, double distance_mm) {
  static Offsetter offsetter;
  const Case& one = cases()[static_cast<std::size_t>(number)];
  const auto result = offsetter.offset(one.view(), distance_mm);
  last_result = result.ok() ? result.value() : ContourView<double>{};
  return result.ok() ? static_cast<int>(last_result.loop_ends.size()) : -1;
}

/// Returns the area that the last offset encloses, mm².
double our_area() {
  double area = 0.0;
  for (std::size_t loop = 0; loop < last_result.loop_ends.size(); ++loop) {
    const std::uint32_t first = last_result.loop_begin(loop);
    const std::uint32_t end = last_result.loop_ends[loop];
    for (std::uint32_t i = first; i < end; ++i) {
      const Vertex<double>& from = last_result.vertices[i];
      const Vertex<double>& to = last_result.vertices[i + 1 < end ? i + 1 : first];
      area += 0.5 * (from.x * to.y - from.y * to.x) + segment_area(from, to);
    }
  }
  return area;
}

/// Does nothing; measures the cost of a call from outside.
int our_nothing(int number) { return number; }

}  // extern "C"
