#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "planner/contour/box_tree.hpp"
#include "planner/contour/contour.hpp"
#include "planner/contour/curve.hpp"
#include "planner/contour/slice.hpp"

namespace cnc::contour {

inline constexpr std::uint32_t kNone = 0xFFFFFFFF;

/// Distances in mm below which points or curves count as the same. They are multiples of the
/// floating-point resolution at the greatest coordinate.
template <typename Scalar>
struct Tolerance {
  Scalar touch{};  ///< Distance below which two points are one point.
  /// Greatest amount by which a curve that is used may be nearer to the input than |distance|. A
  /// curve that is too near by more than `touch` is used only if a loop cannot close without it.
  Scalar shallow{};
  /// Length of a run below which the distance of its middle does not prove that the complete run is
  /// at |distance|.
  Scalar brief{};

  [[nodiscard]] static Tolerance for_coordinates_up_to(Scalar most);
};

/// An element of the input after it was moved, or the round join at a corner.
template <typename Scalar>
struct RawCurve {
  Curve<Scalar> curve;
  std::uint32_t start_node = kNone;
  std::uint32_t end_node = kNone;
};

/// A point where curves end, join, cross or touch. Several nodes may be the same point. Then
/// `same_as` leads to the one of them with the smallest number, and `place` of that node is the
/// point. See NodeSet.
template <typename Scalar>
struct Node {
  BasicVec2<Scalar> place{Scalar{0}, Scalar{0}};
  std::uint32_t same_as = kNone;
};

/// A division of a raw curve at a node.
template <typename Scalar>
struct Cut {
  Scalar order{};  ///< Position along the raw curve, as Curve::order_of() computes it.
  std::uint32_t raw = kNone;
  std::uint32_t node = kNone;
};

/// A raw curve, or a part of a raw curve, between two nodes.
struct Piece {
  std::uint32_t raw = kNone;
  std::uint32_t start_node = kNone;
  std::uint32_t end_node = kNone;
  std::uint32_t next_out = kNone;  ///< Index of another piece that leaves the same node.
  std::uint32_t next_in = kNone;   ///< Index of another piece that arrives at the same node.
  std::uint32_t next = kNone;      ///< Index of the next piece in the same run.
  bool dropped = false;
  bool in_run = false;
};

/// Whether a run belongs to the result.
enum class Standing : std::uint8_t {
  kKept,  ///< The run is at |distance| from the input.
  /// The run is too near to the input by less than the tolerance. It is kept if a loop needs it to
  /// close.
  kOptional,
  kDropped,  ///< The run is too near to the input.
};

/// Consecutive pieces. No other piece begins or ends at the nodes between them. They are kept or
/// dropped together.
struct Run {
  std::uint32_t first_piece = kNone;
  std::uint32_t start_node = kNone;
  std::uint32_t end_node = kNone;
  std::uint32_t next_out = kNone;  ///< Index of another run that leaves the same start node.
  Standing standing = Standing::kDropped;
  bool written = false;
};

/// Lists and numbers of the pieces that meet at a node. Once the runs are known: list of the runs
/// that leave the node, and numbers of the kept runs.
struct Junction {
  std::uint32_t in = 0;
  std::uint32_t out = 0;
  std::uint32_t first_out = kNone;
  std::uint32_t first_in = kNone;
  std::uint32_t reached_by = kNone;  ///< Index of the run by which a search arrived at the node.

  /// Returns whether exactly one piece arrives and one leaves, so that the node leaves no choice.
  [[nodiscard]] bool plain() const { return in == 1 && out == 1; }
};

/// Sizes of the storage that the offset of `elements` elements needs. `cuts` is the number of cuts
/// at which moved elements cross or touch.
struct OffsetSizes {
  std::size_t elements;
  std::size_t cuts;

  [[nodiscard]] constexpr std::size_t raw() const { return 2 * elements; }
  [[nodiscard]] constexpr std::size_t nodes() const { return 2 * raw() + cuts; }
  [[nodiscard]] constexpr std::size_t pieces() const { return raw() + cuts; }
  [[nodiscard]] constexpr std::size_t element_boxes() const {
    return BoxTree<float>::size_for(elements);
  }
  [[nodiscard]] constexpr std::size_t raw_boxes() const { return BoxTree<float>::size_for(raw()); }
};

/// Working storage of an offset. Its content does not outlive the call. The comment of each span
/// names the member of OffsetSizes that gives its size.
template <typename Scalar>
struct OffsetSpace {
  Slice<Vertex<Scalar>> vertices;        ///< elements
  Slice<Curve<Scalar>> elements;         ///< elements
  Slice<FlatBox<Scalar>> element_boxes;  ///< element_boxes()
  Slice<RawCurve<Scalar>> raw;           ///< raw()
  Slice<FlatBox<Scalar>> raw_boxes;      ///< raw_boxes()
  Slice<Node<Scalar>> nodes;             ///< nodes()
  Slice<Cut<Scalar>> cuts;               ///< cuts
  Slice<Cut<Scalar>> sorted_cuts;        ///< cuts
  Slice<std::uint32_t> first_cuts;       ///< raw() + 1
  Slice<Piece> pieces;                   ///< pieces()
  Slice<Run> runs;                       ///< pieces()
  Slice<Junction> junctions;             ///< nodes()
  Slice<std::uint32_t> queue;            ///< nodes()
};

/// Working storage of an offset, with its capacity in the type.
template <typename Scalar, std::size_t kElements, std::size_t kCuts>
class BoundedOffsetSpace {
 public:
  [[nodiscard]] OffsetSpace<Scalar> space() {
    return {vertices_,
            elements_,
            element_boxes_,
            raw_,
            raw_boxes_,
            nodes_,
            cuts_,
            sorted_cuts_,
            first_cuts_,
            pieces_,
            runs_,
            junctions_,
            queue_};
  }

 private:
  // NOLINTNEXTLINE(bugprone-dynamic-static-initializers): constant in each instantiation.
  static constexpr OffsetSizes kSizes{kElements, kCuts};
  std::array<Vertex<Scalar>, kElements> vertices_{};
  std::array<Curve<Scalar>, kElements> elements_{};
  std::array<FlatBox<Scalar>, kSizes.element_boxes()> element_boxes_{};
  std::array<RawCurve<Scalar>, kSizes.raw()> raw_{};
  std::array<FlatBox<Scalar>, kSizes.raw_boxes()> raw_boxes_{};
  std::array<Node<Scalar>, kSizes.nodes()> nodes_{};
  std::array<Cut<Scalar>, kCuts> cuts_{};
  std::array<Cut<Scalar>, kCuts> sorted_cuts_{};
  std::array<std::uint32_t, kSizes.raw() + 1> first_cuts_{};
  std::array<Piece, kSizes.pieces()> pieces_{};
  std::array<Run, kSizes.pieces()> runs_{};
  std::array<Junction, kSizes.nodes()> junctions_{};
  std::array<std::uint32_t, kSizes.nodes()> queue_{};
};

}  // namespace cnc::contour
