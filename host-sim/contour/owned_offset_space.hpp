#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "planner/contour/offset_space.hpp"

namespace sim {

/// Returns a slice of a whole vector, for code that works in the storage of its caller.
template <typename Item>
[[nodiscard]] cnc::contour::Slice<Item> slice_of(std::vector<Item>& items) {
  return {items.data(), items.size()};
}

/// Working storage of an offset, which can grow. Initially it is large enough for no elements.
class OwnedOffsetSpace {
 public:
  OwnedOffsetSpace() { grow(0, 0); }

  [[nodiscard]] std::size_t elements() const { return elements_; }
  [[nodiscard]] std::size_t cuts() const { return cut_count_; }
  /// Returns the greatest number of items that a result of the offset needs.
  [[nodiscard]] std::size_t pieces() const { return pieces_.size(); }

  /// Makes the storage as large as `cnc::contour::OffsetSizes{elements, cuts}`.
  void grow(std::size_t elements, std::size_t cuts);
  /// Returns the storage as the offset takes it; valid until the storage grows again.
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
