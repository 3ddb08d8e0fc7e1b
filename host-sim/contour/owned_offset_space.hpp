#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "planner/contour/offset_space.hpp"

namespace sim {

/// Returns a slice over all items of a vector, for code that works in the storage of its caller.
template <typename Item>
[[nodiscard]] cnc::contour::Slice<Item> slice_of(std::vector<Item>& items) {
  return {items.data(), items.size()};
}

/// Working storage for the computation of offsets. It is initially empty, and can grow.
class OwnedOffsetSpace {
 public:
  OwnedOffsetSpace() { grow(0, 0); }

  [[nodiscard]] std::size_t elements() const { return elements_; }
  [[nodiscard]] std::size_t cuts() const { return cut_count_; }
  /// Returns the greatest number of vertices or loops of an offset that is computed in this
  /// storage.
  [[nodiscard]] std::size_t pieces() const { return pieces_.size(); }

  /// Enlarges the storage to the sizes of `cnc::contour::OffsetSizes{elements, cuts}`.
  void grow(std::size_t elements, std::size_t cuts);
  /// Returns the storage in the form that cnc::contour::offset() takes. The result is valid until
  /// the storage grows again.
  [[nodiscard]] cnc::contour::OffsetSpace<double> space();

 private:
  std::size_t elements_ = 0;
  std::size_t cut_count_ = 0;
  std::vector<cnc::contour::Vertex<double>> vertices_;
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
};

}  // namespace sim
