#include "host-sim/import/touching.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "host-sim/import/curve_measure.hpp"

namespace sim::drawing {
namespace {

// Pairs of chords looked at; some seconds.
constexpr std::size_t kMostChordPairs = 200'000'000;
// Chords of curves that touch are apart by their tolerance, twice, and by a rounding.
constexpr double kNearMm = 2.5 * kChordToleranceMm;
constexpr double kLeastCellMm = 2.0 * kNearMm;
// Chords of one contour with less path from the start of one to the end of the other enclose
// nothing that could be cut, mm: closely drawn curves have many.
constexpr double kShortPathMm = 0.01;

/// A chord of a piece, from its place `index` to the next.
struct Chord {
  std::uint32_t piece = 0;
  std::uint32_t index = 0;
};

/// A grid whose cells hold about as many chords as there are.
class ChordGrid {
 public:
  explicit ChordGrid(const std::vector<Piece>& pieces) : pieces_{pieces} {
    double length = 0.0;
    double farthest = 0.0;
    for (std::size_t piece = 0; piece < pieces.size(); ++piece) {
      if (!pieces[piece].contour.closed) continue;
      const std::vector<Place>& outline = pieces[piece].outline;
      for (std::size_t i = 0; i + 1 < outline.size(); ++i) {
        chords_.push_back({static_cast<std::uint32_t>(piece), static_cast<std::uint32_t>(i)});
        length += distance(outline[i], outline[i + 1]);
        farthest = std::max(farthest, outline[i].cwiseAbs().maxCoeff());
      }
    }
    cell_ = std::max(
        {length / static_cast<double>(chords_.size() + 1), kLeastCellMm, farthest * 1.0e-9});
    for (std::uint32_t chord = 0; chord < chords_.size(); ++chord) enter(chord);
    std::ranges::sort(entries_);
  }

  /// Calls `look(first, second)` for chords that share a cell, until it is false.
  template <typename Look>
  void for_each_pair(const Look& look) const {
    for (std::size_t from = 0; from < entries_.size();) {
      std::size_t to = from;
      while (to < entries_.size() && entries_[to].first == entries_[from].first) ++to;
      for (std::size_t i = from; i < to; ++i) {
        for (std::size_t j = i + 1; j < to; ++j) {
          if (!look(chords_[entries_[i].second], chords_[entries_[j].second])) return;
        }
      }
      from = to;
    }
  }

 private:
  using Cell = std::pair<std::int32_t, std::int32_t>;

  /// Row by row: the cells that the chord's part in a row of cells covers.
  void enter(std::uint32_t chord) {
    const std::vector<Place>& outline = pieces_[chords_[chord].piece].outline;
    Place low = outline[chords_[chord].index];
    Place high = outline[chords_[chord].index + 1];
    if (low.y() > high.y()) std::swap(low, high);
    const std::int32_t last = index_of(high.y() + kNearMm);
    for (std::int32_t row = index_of(low.y() - kNearMm); row <= last; ++row) {
      const double bottom = static_cast<double>(row) * cell_ - kNearMm;
      const double first = x_at(low, high, bottom);
      const double second = x_at(low, high, bottom + cell_ + 2.0 * kNearMm);
      const std::int32_t right = index_of(std::max(first, second) + kNearMm);
      for (std::int32_t x = index_of(std::min(first, second) - kNearMm); x <= right; ++x) {
        entries_.push_back({{row, x}, chord});
      }
    }
  }

  /// Where the chord is at a height, or at its nearer end.
  static double x_at(const Place& low, const Place& high, double y) {
    const double rise = high.y() - low.y();
    if (rise <= 0.0) return y <= low.y() ? low.x() : high.x();
    const double share = std::clamp((y - low.y()) / rise, 0.0, 1.0);
    return low.x() + share * (high.x() - low.x());
  }

  [[nodiscard]] std::int32_t index_of(double value) const {
    return static_cast<std::int32_t>(std::floor(value / cell_));
  }

  const std::vector<Piece>& pieces_;
  std::vector<Chord> chords_;
  double cell_ = 1.0;
  std::vector<std::pair<Cell, std::uint32_t>> entries_;
};

class TouchFinder {
 public:
  TouchFinder(Sketch& sketch, const std::vector<Piece>& pieces)
      : sketch_{sketch},
        pieces_{pieces},
        touching_{PieceSets{pieces.size()}, std::vector<bool>(pieces.size(), false)},
        along_mm_(pieces.size()),
        budget_{sketch.share_of(kMostChordPairs)} {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (!pieces[i].contour.closed) continue;
      double along = 0.0;
      along_mm_[i].push_back(along);
      const std::vector<Place>& outline = pieces[i].outline;
      for (std::size_t k = 1; k < outline.size(); ++k) {
        along_mm_[i].push_back(along += distance(outline[k - 1], outline[k]));
      }
    }
  }

  /// False when there is no time for more.
  bool look(const Chord& a, const Chord& b) {
    if (!budget_.spend(1)) {
      ended_at_ = a;
      return false;
    }
    const Entity& first = pieces_[a.piece].contour.entity;
    const Entity& second = pieces_[b.piece].contour.entity;
    if (!sketch_.fill_together(first, second)) return true;
    if (touching_.touches[a.piece] && touching_.sets.are_one(a.piece, b.piece)) return true;
    if (!touch(a, b)) return true;
    touching_.touches[a.piece] = touching_.touches[b.piece] = true;
    touching_.sets.unite(a.piece, b.piece);
    return true;
  }

  /// Where it was given up.
  void report_rest() {
    if (!budget_.exhausted()) return;
    sketch_.report({FaultKind::kUnchecked,
                    pieces_[ended_at_.piece].contour.entity,
                    start(ended_at_),
                    fmt::format("too many curves lie close together to look for crossings "
                                "everywhere: {} pairs of them were looked at",
                                sketch_.share_of(kMostChordPairs)),
                    "simplify the drawing here, or cut it in parts"});
  }
  [[nodiscard]] TouchingPieces found() && { return std::move(touching_); }

 private:
  [[nodiscard]] const Place& start(const Chord& c) const {
    return pieces_[c.piece].outline[c.index];
  }
  [[nodiscard]] const Place& end(const Chord& c) const {
    return pieces_[c.piece].outline[c.index + 1];
  }

  /// Whether the second chord follows the first one on a contour.
  [[nodiscard]] bool follows(const Chord& first, const Chord& second) const {
    const std::size_t count = pieces_[first.piece].outline.size() - 1;
    return first.piece == second.piece && (first.index + 1) % count == second.index;
  }

  [[nodiscard]] bool are_on_a_short_path(const Chord& a, const Chord& b) const {
    if (a.piece != b.piece) return false;
    const std::vector<double>& along = along_mm_[a.piece];
    const auto [first, last] = std::minmax(a.index, b.index);
    const double ahead = along[last + 1] - along[first];
    const double round_the_seam = along.back() - along[last] + along[first + 1];
    return std::min(ahead, round_the_seam) < kShortPathMm;
  }

  [[nodiscard]] bool touch(const Chord& a, const Chord& b) const {
    if (a.piece == b.piece && a.index == b.index) return false;
    if (follows(a, b)) return turns_back(a, b);
    if (follows(b, a)) return turns_back(b, a);
    if (are_on_a_short_path(a, b)) return false;
    const Place low = start(a).cwiseMin(end(a)).cwiseMax(start(b).cwiseMin(end(b)));
    const Place high = start(a).cwiseMax(end(a)).cwiseMin(start(b).cwiseMax(end(b)));
    if ((low - high).maxCoeff() > kNearMm) return false;
    if (cross_each_other(a, b)) return true;
    return std::min({distance_to_chord(start(a), start(b), end(b)),
                     distance_to_chord(end(a), start(b), end(b)),
                     distance_to_chord(start(b), start(a), end(a)),
                     distance_to_chord(end(b), start(a), end(a))}) <= kNearMm;
  }

  [[nodiscard]] bool cross_each_other(const Chord& a, const Chord& b) const {
    const auto parts = [](const Place& from, const Place& to, const Place& p, const Place& q) {
      return (cross(to - from, p - from) > 0.0) != (cross(to - from, q - from) > 0.0);
    };
    return parts(start(a), end(a), start(b), end(b)) && parts(start(b), end(b), start(a), end(a));
  }

  /// Whether a chord runs back along the one before it.
  [[nodiscard]] bool turns_back(const Chord& a, const Chord& b) const {
    const Place in = end(a) - start(a);
    const Place out = end(b) - start(b);
    if (dot(in, out) >= 0.0) return false;
    return in.squaredNorm() < out.squaredNorm()
               ? distance_to_chord(start(a), start(b), end(b)) <= kNearMm
               : distance_to_chord(end(b), start(a), end(a)) <= kNearMm;
  }

  Sketch& sketch_;
  const std::vector<Piece>& pieces_;
  TouchingPieces touching_;
  std::vector<std::vector<double>> along_mm_;  ///< By piece: length of its path up to each place.
  Budget budget_;
  Chord ended_at_{};
};

}  // namespace

TouchingPieces find_touching(Sketch& sketch, const std::vector<Piece>& pieces) {
  const ChordGrid grid{pieces};
  TouchFinder finder{sketch, pieces};
  grid.for_each_pair([&](const Chord& a, const Chord& b) { return finder.look(a, b); });
  finder.report_rest();
  return std::move(finder).found();
}

}  // namespace sim::drawing
