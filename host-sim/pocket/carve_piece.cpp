#include "host-sim/pocket/carve_piece.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "planner/pocket/moving_disc.hpp"

namespace sim::pocket {
namespace {

using cnc::WideVec2;

/// Share of the tolerance for each of three errors: the distance from the axis, the difference from
/// the radii of the axis, and the reduction of radii.
constexpr double kShare = 1.0 / 3.0;

/// The part of the axis that is kept, by its radius.
enum class KeptPart : std::uint8_t { kNarrow, kWide };

/// Splits chains at the points where their radius crosses a limit.
class AxisClipper {
 public:
  AxisClipper(const MedialAxis& axis, const OwnedArea& area, double limit_mm, KeptPart part)
      : axis_{axis}, area_{area}, limit_mm_{limit_mm}, part_{part} {
    graph_.nodes = axis.nodes;
  }

  CarveGraph clip() {
    for (const AxisChain& chain : axis_.chains) clip_chain(chain);
    return std::move(graph_);
  }

 private:
  void clip_chain(const AxisChain& chain) {
    CarvePiece piece{.from = chain.from, .to = chain.to, .points = {}};
    for (std::size_t i = 0; i < chain.points.size(); ++i) {
      const AxisPoint& point = chain.points[i];
      const bool fits = is_kept(point);
      if (i > 0 && fits != is_kept(chain.points[i - 1])) {
        const AxisPoint crossing = crossing_between(chain.points[i - 1], point);
        const auto node = static_cast<std::uint32_t>(graph_.nodes.size());
        graph_.nodes.push_back(crossing);
        piece.points.push_back(crossing);
        if (fits) {
          piece.from = node;
        } else {
          finish(piece, node);
        }
      }
      if (fits) piece.points.push_back(point);
    }
    if (!piece.points.empty()) finish(piece, chain.to);
  }

  void finish(CarvePiece& piece, std::uint32_t to) {
    piece.to = to;
    if (piece.points.size() > 1) graph_.pieces.push_back(piece);
    piece.points.clear();
  }

  [[nodiscard]] bool is_kept(const AxisPoint& point) const {
    constexpr double kRounding = 1.0e-9;  // Rounding error of a radius, mm.
    return is_within(point.radius - (part_ == KeptPart::kNarrow ? kRounding : -kRounding));
  }

  [[nodiscard]] bool is_within(double radius) const {
    return part_ == KeptPart::kNarrow ? radius <= limit_mm_ : radius >= limit_mm_;
  }

  /// Returns the point between two points where the radius crosses the limit.
  /// @pre one of the two points is kept
  [[nodiscard]] AxisPoint crossing_between(AxisPoint kept, AxisPoint dropped) const {
    if (!is_kept(kept)) std::swap(kept, dropped);
    constexpr int kHalvings = 40;
    for (int i = 0; i < kHalvings; ++i) {
      const WideVec2 place = 0.5 * (kept.place + dropped.place);
      const AxisPoint middle{place, std::max(0.0, area_->depth(place))};
      (is_within(middle.radius) ? kept : dropped) = middle;
    }
    return kept;
  }

  const MedialAxis& axis_;
  const OwnedArea& area_;
  double limit_mm_;
  KeptPart part_;
  CarveGraph graph_;
};

/// Replaces the points of one piece by as few lines as possible.
class LineFitter {
 public:
  LineFitter(const OwnedArea& area, double tolerance_mm)
      : area_{area}, share_mm_{kShare * tolerance_mm} {}

  void fit(std::vector<AxisPoint>& points) {
    std::vector<AxisPoint> kept{points.front()};
    // For each line, the distance by which the tool would cut into the wall, mm.
    std::vector<double> excesses;
    for (std::size_t i = 0; i + 1 < points.size();) {
      const std::size_t end = farthest(points, i);
      excesses.push_back(excess_between(points[i], points[end]));
      kept.push_back(points[end]);
      i = end;
    }
    for (std::size_t i = 0; i < kept.size(); ++i) {
      const double before = i > 0 ? excesses[i - 1] : 0.0;
      const double after = i < excesses.size() ? excesses[i] : 0.0;
      kept[i].radius -= std::max(before, after);
    }
    points = std::move(kept);
  }

 private:
  /// Returns the last point to which a straight line from `from` stays within the tolerance.
  /// Searches by doubling, then by halving.
  [[nodiscard]] std::size_t farthest(const std::vector<AxisPoint>& points, std::size_t from) const {
    const std::size_t last = points.size() - 1;
    std::size_t good = from + 1;
    std::size_t bad = last + 1;
    for (std::size_t step = 2; good < last; step *= 2) {
      const std::size_t end = std::min(from + step, last);
      if (!fits(points, from, end)) {
        bad = end;
        break;
      }
      good = end;
    }
    while (good + 1 < bad) {
      const std::size_t end = good + (bad - good) / 2;
      (fits(points, from, end) ? good : bad) = end;
    }
    return good;
  }

  [[nodiscard]] bool fits(const std::vector<AxisPoint>& points,
                          std::size_t from,
                          std::size_t end) const {
    const AxisPoint& a = points[from];
    const AxisPoint& b = points[end];
    const WideVec2 chord = b.place - a.place;
    const double square = chord.squaredNorm();
    double min_share = 0.0;
    for (std::size_t i = from + 1; i < end; ++i) {
      const WideVec2 q = points[i].place - a.place;
      const double share = square > 0.0 ? chord.dot(q) / square : 0.0;
      // The axis turns back at this point: the projections of the points onto the line would go
      // backwards.
      if (share < min_share || share > 1.0) return false;
      min_share = share;
      const double radius = a.radius + share * (b.radius - a.radius);
      const double aside = (q - share * chord).norm();
      if (aside > share_mm_ || std::abs(points[i].radius - radius) > share_mm_) return false;
    }
    return excess_between(a, b) <= share_mm_;
  }

  [[nodiscard]] double excess_between(const AxisPoint& a, const AxisPoint& b) const {
    return excess_of({a.place, b.place, a.radius, b.radius}, *area_);
  }

  const OwnedArea& area_;
  double share_mm_;
};

/// Gives all pieces the same radius at the node at which they meet: the least of their radii at
/// this node.
void share_nodes(CarveGraph& graph) {
  for (CarvePiece& piece : graph.pieces) {
    for (const auto& [node, end] : {std::pair{piece.from, &piece.points.front()},
                                    std::pair{piece.to, &piece.points.back()}}) {
      graph.nodes[node].radius = std::min(graph.nodes[node].radius, end->radius);
    }
  }
  for (CarvePiece& piece : graph.pieces) {
    piece.points.front().radius = graph.nodes[piece.from].radius;
    piece.points.back().radius = graph.nodes[piece.to].radius;
  }
}

}  // namespace

CarveGraph narrow_part(const MedialAxis& axis, const OwnedArea& area, double greatest_radius_mm) {
  return AxisClipper{axis, area, greatest_radius_mm, KeptPart::kNarrow}.clip();
}

CarveGraph wide_part(const MedialAxis& axis, const OwnedArea& area, double min_radius_mm) {
  return AxisClipper{axis, area, min_radius_mm, KeptPart::kWide}.clip();
}

void fit_lines(CarveGraph& graph, const OwnedArea& area, double tolerance_mm) {
  LineFitter fitter{area, tolerance_mm};
  for (CarvePiece& piece : graph.pieces) fitter.fit(piece.points);
  share_nodes(graph);
}

}  // namespace sim::pocket
