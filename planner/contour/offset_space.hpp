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

/// What counts as the same, in mm: everything follows from the resolution of a
/// number as large as the coordinates.
template <typename Scalar>
struct Tolerance {
  Scalar touch{};    ///< Places closer than this are one place.
  Scalar shallow{};  ///< How much too near to the input a curve may lie where nothing else fits.
  Scalar brief{};    ///< A stretch shorter than this proves nothing by its middle.

  [[nodiscard]] static Tolerance for_coordinates_up_to(Scalar most);
};

/// An element of the input moved aside, or the round join at a corner.
template <typename Scalar>
struct RawCurve {
  Curve<Scalar> curve;
  std::uint32_t start_node = kNone;
  std::uint32_t end_node = kNone;
};

/// A place where curves end, join, cross or touch. Nodes found to be the same
/// place point to the one with the least number, which keeps its own place.
template <typename Scalar>
struct Node {
  BasicVec2<Scalar> place{Scalar{0}, Scalar{0}};
  std::uint32_t same_as = kNone;
};

/// Where a node divides a raw curve.
template <typename Scalar>
struct Cut {
  Scalar order{};  ///< As Curve::order_of.
  std::uint32_t raw = kNone;
  std::uint32_t node = kNone;
};

/// A raw curve, or a part of it, between two nodes.
struct Piece {
  std::uint32_t raw = kNone;
  std::uint32_t start_node = kNone;
  std::uint32_t end_node = kNone;
  std::uint32_t next_out = kNone;  ///< Another piece that leaves the same node.
  std::uint32_t next_in = kNone;   ///< Another piece that reaches the same node.
  std::uint32_t next = kNone;      ///< The piece that follows in its run.
  bool dropped = false;
  bool in_run = false;
};

/// Whether a run belongs to the result.
enum class Standing : std::uint8_t {
  kKept,      ///< At the distance.
  kOptional,  ///< Within tolerance: where it is needed to close a loop.
  kDropped,   ///< Too near to the input.
};

/// Pieces in a row with nothing else at the nodes between: kept or dropped as one.
struct Run {
  std::uint32_t first_piece = kNone;
  std::uint32_t start_node = kNone;
  std::uint32_t end_node = kNone;
  std::uint32_t next_out = kNone;  ///< Another run that leaves the same start node.
  Standing standing = Standing::kDropped;
  bool written = false;
};

/// What meets at a node: pieces, and once those are known, runs that are kept.
struct Junction {
  std::uint32_t in = 0;
  std::uint32_t out = 0;
  std::uint32_t first_out = kNone;
  std::uint32_t first_in = kNone;
  std::uint32_t reached_by = kNone;  ///< The run by which a search came here.

  /// One way in and one way out: nothing is decided here.
  [[nodiscard]] bool plain() const { return in == 1 && out == 1; }
};

/// How much room the offset of so many elements needs, `cuts` of them where
/// moved elements cross or touch.
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

/// Working storage of an offset; nothing in it outlives the call.
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

/// Working storage with its capacity in the type.
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
