#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "planner/contour/slice.hpp"
#include "planner/geometry/vector.hpp"

namespace cnc::contour {

/// The start of an element of a closed contour, and the bulge of the element. The element is the
/// arc from this vertex to the next vertex of the loop; the last element leads to the first vertex.
template <typename Scalar>
struct Vertex {
  Scalar x{};      ///< mm.
  Scalar y{};      ///< mm.
  Scalar bulge{};  ///< tan(sweep / 4) of any size: positive turns left, 0 is a line.

  [[nodiscard]] BasicVec2<Scalar> point() const { return {x, y}; }
};

/// Closed loops, one after the other, in storage that this view does not own. Material is on the
/// left of each loop: outlines run counter-clockwise, holes run clockwise.
template <typename Scalar>
struct ContourView {
  Slice<const Vertex<Scalar>> vertices;
  Slice<const std::uint32_t> loop_ends;  ///< End of each loop: the index after its last vertex.

  [[nodiscard]] std::uint32_t loop_begin(std::size_t loop) const {
    return loop == 0 ? 0 : loop_ends[loop - 1];
  }
};

/// Writes loops into storage that the caller owns.
template <typename Scalar>
class ContourWriter {
 public:
  ContourWriter(Slice<Vertex<Scalar>> vertices, Slice<std::uint32_t> loop_ends)
      : vertices_{vertices}, loop_ends_{loop_ends} {}

  void clear() { vertex_count_ = loop_count_ = 0; }
  /// Adds a vertex. Returns false and changes nothing if the storage is full.
  [[nodiscard]] bool add(const Vertex<Scalar>& vertex) {
    if (vertex_count_ == vertices_.size()) return false;
    vertices_[vertex_count_++] = vertex;
    return true;
  }
  [[nodiscard]] bool end_loop() {
    if (loop_count_ == loop_ends_.size()) return false;
    loop_ends_[loop_count_++] = static_cast<std::uint32_t>(vertex_count_);
    return true;
  }

  [[nodiscard]] std::size_t vertex_count() const { return vertex_count_; }
  [[nodiscard]] ContourView<Scalar> view() const {
    return {{vertices_.begin(), vertex_count_}, {loop_ends_.begin(), loop_count_}};
  }

 private:
  Slice<Vertex<Scalar>> vertices_;
  Slice<std::uint32_t> loop_ends_;
  std::size_t vertex_count_ = 0;
  std::size_t loop_count_ = 0;
};

/// Loops together with their storage, whose capacity is in the type.
template <typename Scalar, std::size_t kVertices, std::size_t kLoops>
class BoundedContour {
 public:
  [[nodiscard]] bool add(const Vertex<Scalar>& vertex) { return writer_.add(vertex); }
  [[nodiscard]] bool end_loop() { return writer_.end_loop(); }
  [[nodiscard]] ContourWriter<Scalar>& writer() { return writer_; }
  [[nodiscard]] ContourView<Scalar> view() const { return writer_.view(); }

  BoundedContour() = default;
  ~BoundedContour() = default;
  BoundedContour(const BoundedContour&) = delete;  // `writer_` points into this object.
  BoundedContour& operator=(const BoundedContour&) = delete;

 private:
  std::array<Vertex<Scalar>, kVertices> vertices_{};
  std::array<std::uint32_t, kLoops> loop_ends_{};
  ContourWriter<Scalar> writer_{vertices_, loop_ends_};
};

}  // namespace cnc::contour
