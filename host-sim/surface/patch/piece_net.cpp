#include "host-sim/surface/patch/piece_net.hpp"

#include <algorithm>
#include <array>
#include <compare>
#include <limits>
#include <map>
#include <utility>

namespace sim::surface::patch {
namespace {

using Eigen::Vector3d;

constexpr std::uint32_t kNoEdge = std::numeric_limits<std::uint32_t>::max();

BezierCurve curve_of(const BezierPatch& shape, std::size_t side) {
  switch (side) {
    case 0:
      return shape.rows[0];
    case 1:
      return shape.transposed().rows[3];
    case 2:
      return shape.rows[3];
    default:
      return shape.transposed().rows[0];
  }
}

}  // namespace

/// Builds the edges of a net: divides each side of a piece at all corners of pieces on this side.
class PieceNet::Builder {
 public:
  explicit Builder(PieceNet& net) : net_{net} {
    stops_.reserve(8 * net.pieces_.size());
    for (const GridPatch& piece : net.pieces_) {
      for (const Side& side : sides_of(piece)) {
        stops_.push_back(side.from());
        stops_.push_back(side.to());
      }
    }
    std::sort(stops_.begin(), stops_.end());
    stops_.erase(std::unique(stops_.begin(), stops_.end()), stops_.end());
    edge_from_.assign(stops_.size(), kNoEdge);
  }

  void build() {
    net_.edges_.reserve(3 * net_.pieces_.size());
    net_.borders_.reserve(5 * net_.pieces_.size());
    for (const GridPatch& piece : net_.pieces_) {
      net_.first_edge_.push_back(net_.borders_.size());
      const std::array<Side, 4> sides = sides_of(piece);
      for (std::size_t i = 0; i < 4; ++i) add_side(sides[i], curve_of(piece.shape, i));
    }
    net_.first_edge_.push_back(net_.borders_.size());
  }

 private:
  /// A corner of a piece. It is given by a line of constant u or constant v through the corner, and
  /// by the value of the other parameter.
  struct Stop {
    bool is_at_u = false;  ///< Whether u is constant on the line; otherwise v is constant.
    double line = 0.0;
    double along = 0.0;

    auto operator<=>(const Stop&) const = default;
  };

  /// A side of a piece, as a part of a line of constant u or constant v.
  struct Side {
    bool is_at_u = false;
    double line = 0.0;
    Interval along;
    /// Whether the piece's border passes the side from the end to the start of `along`.
    bool is_reversed = false;

    [[nodiscard]] Stop from() const { return {is_at_u, line, along.from}; }
    [[nodiscard]] Stop to() const { return {is_at_u, line, along.to}; }
  };

  /// Returns the sides of a piece in the order of its border.
  static std::array<Side, 4> sides_of(const GridPatch& piece) {
    return {Side{true, piece.u.from, piece.v, false},
            Side{false, piece.v.to, piece.u, false},
            Side{true, piece.u.to, piece.v, true},
            Side{false, piece.v.from, piece.u, true}};
  }

  [[nodiscard]] std::size_t place_of(const Stop& stop) const {
    return static_cast<std::size_t>(std::lower_bound(stops_.begin(), stops_.end(), stop) -
                                    stops_.begin());
  }

  void add_side(const Side& side, const BezierCurve& curve) {
    const std::size_t first = place_of(side.from());
    const std::size_t last = place_of(side.to());
    for (std::size_t i = first; i < last; ++i) {
      if (edge_from_[i] == kNoEdge) edge_from_[i] = new_edge(side, curve, i);
    }
    for (std::size_t i = 0; i < last - first; ++i) {
      const std::size_t stop = side.is_reversed ? last - 1 - i : first + i;
      net_.borders_.push_back({edge_from_[stop], side.is_reversed});
    }
  }

  std::uint32_t new_edge(const Side& side, const BezierCurve& curve, std::size_t stop) {
    const double length = side.along.to - side.along.from;
    const Interval share{(stops_[stop].along - side.along.from) / length,
                         (stops_[stop + 1].along - side.along.from) / length};
    BezierCurve edge = curve.part(share);
    edge.controls[0] = corner(stops_[stop], edge.controls[0]);
    edge.controls[3] = corner(stops_[stop + 1], edge.controls[3]);
    net_.edges_.push_back(edge);
    return static_cast<std::uint32_t>(net_.edges_.size() - 1);
  }

  /// Returns the stored point of a corner. If none is stored, stores and returns `point`. So all
  /// edges at a corner have the same point.
  const Vector3d& corner(const Stop& stop, const Vector3d& point) {
    const std::pair place{stop.is_at_u ? stop.line : stop.along,
                          stop.is_at_u ? stop.along : stop.line};
    return corners_.try_emplace(place, point).first->second;
  }

  PieceNet& net_;
  std::vector<Stop> stops_;  ///< All stops, sorted, without duplicates.
  /// Number of the edge from each stop to the next stop on the same line.
  std::vector<std::uint32_t> edge_from_;
  std::map<std::pair<double, double>, Vector3d> corners_;
};

PieceNet::PieceNet(std::vector<GridPatch> pieces) : pieces_{std::move(pieces)} {
  Builder{*this}.build();
}

}  // namespace sim::surface::patch
