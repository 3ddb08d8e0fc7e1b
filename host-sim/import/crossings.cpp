#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "host-sim/import/piece.hpp"

namespace sim::drawing {
namespace {

// Pairs of chords looked at; some seconds.
constexpr std::size_t kMostChordPairs = 200'000'000;
// Pairs of contours that cross: nobody mends so many, nor asks for the rest.
constexpr std::size_t kMostCrossings = 10'000;
// Chords of one curve differ from it by more than this; true crossings do not.
constexpr double kTouchMm = 1.0e-7;

/// A chord of a piece, from its place `index` to the next.
struct Chord {
  std::uint32_t piece = 0;
  std::uint32_t index = 0;
};

/// How an outline passes through a place: the ways back and on.
struct Passage {
  Place back;
  Place on;
};

/// Turned left from `from`, 0…4 and growing with the angle.
double turn(const Place& from, const Place& way) {
  const double along = dot(from, way) / (from.norm() * way.norm());
  return cross(from, way) >= 0.0 ? 1.0 - along : 3.0 + along;
}

/// Whether the second passage has one arm on each side of the first.
bool parts(const Passage& first, const Passage& second) {
  constexpr double kSameWay = 1.0e-9;
  const double on = turn(first.back, first.on);
  const auto side = [&](const Place& way) {
    const double at = turn(first.back, way);
    if (at < kSameWay || at > 4.0 - kSameWay || std::abs(at - on) < kSameWay) return 0;
    return at < on ? 1 : -1;
  };
  return side(second.back) * side(second.on) < 0;
}

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
    cell_ = std::max({length / static_cast<double>(chords_.size() + 1), 1.0e-3, farthest * 1.0e-9});
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
    const std::int32_t last = index_of(high.y() + kTouchMm);
    for (std::int32_t row = index_of(low.y() - kTouchMm); row <= last; ++row) {
      const double bottom = static_cast<double>(row) * cell_ - kTouchMm;
      const double first = x_at(low, high, bottom);
      const double second = x_at(low, high, bottom + cell_ + 2.0 * kTouchMm);
      const std::int32_t right = index_of(std::max(first, second) + kTouchMm);
      for (std::int32_t x = index_of(std::min(first, second) - kTouchMm); x <= right; ++x) {
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

class CrossingFinder {
 public:
  CrossingFinder(Sketch& sketch, const std::vector<Piece>& pieces)
      : sketch_{sketch},
        pieces_{pieces},
        crossed_(pieces.size(), false),
        budget_{sketch.share_of(kMostChordPairs)} {}

  /// False when there is no time for more.
  bool look(const Chord& a, const Chord& b) {
    if (!budget_.spend(1)) {
      ended_at_ = a;
      return false;
    }
    if (layer(a) != layer(b) || adjacent(a, b)) return true;
    const auto pair = std::minmax(a.piece, b.piece);
    if (reported_.contains(pair)) return true;
    if (const auto place = meeting(a, b); place && parts(passage(a, *place), passage(b, *place))) {
      reported_.insert(pair);
      report(pair, *place);
    }
    return reported_.size() < kMostCrossings;
  }

  /// Why and where it was given up.
  void report_rest() {
    if (reported_.size() >= kMostCrossings) {
      sketch_.report({FaultKind::kUnchecked,
                      {},
                      {},
                      fmt::format("{} contours cross; more were not looked for", reported_.size()),
                      "take the crossings apart"});
    }
    if (!budget_.exhausted()) return;
    sketch_.report({FaultKind::kUnchecked,
                    pieces_[ended_at_.piece].contour.entity,
                    start(ended_at_),
                    fmt::format("too many curves lie close together to look for crossings "
                                "everywhere: {} pairs of them were looked at",
                                sketch_.share_of(kMostChordPairs)),
                    "simplify the drawing here, or cut it in parts"});
  }
  [[nodiscard]] std::vector<bool> crossed() && { return std::move(crossed_); }

 private:
  [[nodiscard]] const std::vector<Place>& outline(const Chord& c) const {
    return pieces_[c.piece].outline;
  }
  [[nodiscard]] const Place& start(const Chord& c) const { return outline(c)[c.index]; }
  [[nodiscard]] const Place& end(const Chord& c) const { return outline(c)[c.index + 1]; }
  [[nodiscard]] std::size_t layer(const Chord& c) const {
    return pieces_[c.piece].contour.entity.layer;
  }

  [[nodiscard]] bool adjacent(const Chord& a, const Chord& b) const {
    if (a.piece != b.piece) return false;
    const std::size_t count = outline(a).size() - 1;
    return a.index == b.index || (a.index + 1) % count == b.index ||
           (b.index + 1) % count == a.index;
  }

  /// Where two chords that are not parallel meet, ends included.
  [[nodiscard]] std::optional<Place> meeting(const Chord& a, const Chord& b) const {
    const Place way_a = end(a) - start(a);
    const Place way_b = end(b) - start(b);
    const Place between = start(b) - start(a);
    const double size = cross(way_a, way_b);
    const double lengths = way_a.norm() * way_b.norm();
    if (std::abs(size) <= 1.0e-12 * lengths) return {};
    const double along_a = cross(between, way_b) / size;
    const double along_b = cross(between, way_a) / size;
    const double slack_a = kTouchMm / way_a.norm();
    const double slack_b = kTouchMm / way_b.norm();
    if (along_a < -slack_a || along_a > 1.0 + slack_a) return {};
    if (along_b < -slack_b || along_b > 1.0 + slack_b) return {};
    return Place{start(a) + way_a * along_a};
  }

  /// At an end of a chord the outline goes on with the next one.
  [[nodiscard]] Passage passage(const Chord& c, const Place& at) const {
    const std::vector<Place>& places = outline(c);
    const std::size_t count = places.size() - 1;
    if (distance(at, start(c)) <= kTouchMm) {
      const Place& before = places[(c.index + count - 1) % count];
      return {before - start(c), end(c) - start(c)};
    }
    if (distance(at, end(c)) <= kTouchMm) {
      const Place& after = places[(c.index + 2) % count];
      return {start(c) - end(c), after - end(c)};
    }
    return {start(c) - end(c), end(c) - start(c)};
  }

  void report(const std::pair<std::size_t, std::size_t>& pair, const Place& place) {
    const Entity& first = pieces_[pair.first].contour.entity;
    const Entity& second = pieces_[pair.second].contour.entity;
    crossed_[pair.first] = crossed_[pair.second] = true;
    sketch_.report(
        {FaultKind::kCrossing,
         first,
         place,
         pair.first == pair.second
             ? std::string{"the contour crosses itself"}
             : fmt::format("the contour crosses that of {} of line {}", second.name, second.line),
         "take the crossing apart; what is inside is not certain"});
  }

  Sketch& sketch_;
  const std::vector<Piece>& pieces_;
  std::vector<bool> crossed_;
  std::set<std::pair<std::size_t, std::size_t>> reported_;
  Budget budget_;
  Chord ended_at_{};
};

}  // namespace

std::vector<bool> find_crossings(Sketch& sketch, const std::vector<Piece>& pieces) {
  const ChordGrid grid{pieces};
  CrossingFinder finder{sketch, pieces};
  grid.for_each_pair([&](const Chord& a, const Chord& b) { return finder.look(a, b); });
  finder.report_rest();
  return std::move(finder).crossed();
}

}  // namespace sim::drawing
