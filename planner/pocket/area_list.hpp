#pragma once

#include <cstddef>
#include <cstdint>

#include "planner/contour/contour.hpp"

namespace cnc::pocket {

/// Index of the first vertex and of the first loop of a connected area in the storage of an
/// AreaList.
struct AreaRange {
  std::uint32_t first_vertex = 0;
  std::uint32_t first_loop = 0;
};

/// Connected areas in storage that the caller owns. Each area is a separate contour: first an
/// outline, which runs counter-clockwise, then the holes in it.
template <typename Scalar>
class AreaList {
 public:
  AreaList() = default;
  AreaList(contour::Slice<contour::Vertex<Scalar>> vertices,
           contour::Slice<std::uint32_t> loop_ends,
           contour::Slice<AreaRange> ranges)
      : vertices_{vertices}, loop_ends_{loop_ends}, ranges_{ranges} {}

  void clear() { vertex_count_ = loop_count_ = area_count_ = 0; }
  [[nodiscard]] std::size_t size() const { return area_count_; }

  /// Returns the contour of an area. @pre area < size()
  [[nodiscard]] contour::ContourView<Scalar> operator[](std::size_t area) const {
    const AreaRange& range = ranges_[area];
    const bool last = area + 1 == area_count_;
    const std::size_t vertex_end = last ? vertex_count_ : ranges_[area + 1].first_vertex;
    const std::size_t loop_end = last ? loop_count_ : ranges_[area + 1].first_loop;
    return {{vertices_.begin() + range.first_vertex, vertex_end - range.first_vertex},
            {loop_ends_.begin() + range.first_loop, loop_end - range.first_loop}};
  }

  /// Begins an area. The loops that are added next belong to it. Returns false if the storage is
  /// full.
  [[nodiscard]] bool begin_area() {
    if (area_count_ == ranges_.size()) return false;
    ranges_[area_count_++] = {static_cast<std::uint32_t>(vertex_count_),
                              static_cast<std::uint32_t>(loop_count_)};
    return true;
  }
  /// Appends a loop of a contour to the last area. Returns false if the storage is full.
  /// @pre an area has begun
  [[nodiscard]] bool add_loop(const contour::ContourView<Scalar>& contour, std::size_t loop) {
    const std::uint32_t begin = contour.loop_begin(loop);
    const std::uint32_t end = contour.loop_ends[loop];
    if (end - begin > vertices_.size() - vertex_count_) return false;
    if (loop_count_ == loop_ends_.size()) return false;
    for (std::uint32_t i = begin; i < end; ++i) vertices_[vertex_count_++] = contour.vertices[i];
    const std::uint32_t first = ranges_[area_count_ - 1].first_vertex;
    loop_ends_[loop_count_++] = static_cast<std::uint32_t>(vertex_count_) - first;
    return true;
  }

 private:
  contour::Slice<contour::Vertex<Scalar>> vertices_;
  /// End of each loop, counted from the first vertex of its area.
  contour::Slice<std::uint32_t> loop_ends_;
  contour::Slice<AreaRange> ranges_;
  std::size_t vertex_count_ = 0;
  std::size_t loop_count_ = 0;
  std::size_t area_count_ = 0;
};

}  // namespace cnc::pocket
