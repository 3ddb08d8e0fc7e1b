#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "planner/contour/offset.hpp"

namespace sim {

using ContourVertex = cnc::contour::Vertex<double>;

/// Closed loops of lines and arcs on the host; mm, as cnc::contour::ContourView.
struct Contour {
  std::vector<ContourVertex> vertices;
  std::vector<std::uint32_t> loop_ends;

  [[nodiscard]] cnc::contour::ContourView<double> view() const {
    return {{vertices.data(), vertices.size()}, {loop_ends.data(), loop_ends.size()}};
  }
  void end_loop() { loop_ends.push_back(static_cast<std::uint32_t>(vertices.size())); }
};

/// What is left of a contour does not lead back to its start.
class OpenContour : public std::runtime_error {
 public:
  OpenContour();
};

/// The planner's offset with storage that grows until it is enough, and is used
/// again for the next contour.
class ContourOffset {
 public:
  /// Throws std::invalid_argument for numbers that are not finite, and
  /// OpenContour. The view lasts until the next call.
  cnc::contour::ContourView<double> offset(const cnc::contour::ContourView<double>& input,
                                           double distance_mm);

 private:
  void grow(std::size_t elements, std::size_t cuts);

  std::size_t elements_ = 0;
  std::size_t cut_count_ = 0;
  std::vector<ContourVertex> vertices_;
  std::vector<cnc::contour::Curve<double>> curves_;
  std::vector<cnc::contour::FlatBox<double>> element_boxes_;
  std::vector<cnc::contour::RawCurve<double>> raw_;
  std::vector<cnc::contour::FlatBox<double>> raw_boxes_;
  std::vector<cnc::contour::Node<double>> nodes_;
  std::vector<cnc::contour::Cut<double>> cuts_;
  std::vector<cnc::contour::Cut<double>> sorted_cuts_;
  std::vector<std::uint32_t> first_cuts_;
  std::vector<cnc::contour::Piece> pieces_;
  std::vector<cnc::contour::Run> runs_;
  std::vector<cnc::contour::Junction> junctions_;
  std::vector<std::uint32_t> queue_;
  std::vector<ContourVertex> result_;
  std::vector<std::uint32_t> result_ends_;
};

}  // namespace sim
