#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "host-sim/import/curve_measure.hpp"
#include "host-sim/import/piece.hpp"

namespace sim::drawing {
namespace {

// Distances of places to chords; some seconds.
constexpr std::size_t kMostComparisons = 300'000'000;
constexpr std::size_t kPlacesCompared = 256;

double distance_to_chord(const Place& place, const Place& start, const Place& end) {
  const Place chord = end - start;
  const double squared = chord.squaredNorm();
  const double share =
      squared == 0.0 ? 0.0 : std::clamp(dot(place - start, chord) / squared, 0.0, 1.0);
  return distance(place, start + chord * share);
}

/// Whether places of `outline`, all or evenly chosen, lie on `other`.
bool runs_along(const Piece& outline, const Piece& other, double tolerance, Budget& budget) {
  const std::vector<Place>& places = outline.outline;
  const std::size_t stride = places.size() / kPlacesCompared + 1;
  for (std::size_t i = 0; i < places.size(); i += stride) {
    if (!budget.spend(other.outline.size())) return false;
    bool found = false;
    for (std::size_t j = 1; j < other.outline.size() && !found; ++j) {
      found = distance_to_chord(places[i], other.outline[j - 1], other.outline[j]) <= tolerance;
    }
    if (!found) return false;
  }
  return true;
}

/// The same chords in the same order, as copies have them.
bool same_chords(const Piece& piece, const Piece& other, double tolerance, Budget& budget) {
  const auto near = [tolerance](const Place& a, const Place& b) {
    return distance(a, b) <= tolerance;
  };
  return budget.spend(piece.outline.size()) &&
         std::ranges::equal(piece.outline, other.outline, near);
}

/// Looks pieces up by the lower left corner of their boxes.
class PieceLookup {
 public:
  PieceLookup(double tolerance, std::size_t comparisons)
      : tolerance_{tolerance}, budget_{comparisons} {}

  /// The earlier piece that runs the same way, or nothing.
  const Piece* find(const Piece& piece, const std::vector<Piece>& kept) {
    if (budget_.exhausted()) return nullptr;
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        const auto cell = cells_.find(key_of(piece, dx, dy));
        if (cell == cells_.end()) continue;
        for (const std::size_t index : cell->second) {
          if (same(piece, kept[index])) return &kept[index];
        }
      }
    }
    return nullptr;
  }

  void add(const Piece& piece, std::size_t index) { cells_[key_of(piece, 0, 0)].push_back(index); }

  [[nodiscard]] bool exhausted() const { return budget_.exhausted(); }

 private:
  bool same(const Piece& piece, const Piece& other) {
    if (!budget_.spend(1)) return false;
    const DrawnContour& a = piece.contour;
    const DrawnContour& b = other.contour;
    return a.closed == b.closed && a.entity.layer == b.entity.layer &&
           (piece.box.least - other.box.least).cwiseAbs().maxCoeff() <= tolerance_ &&
           (piece.box.most - other.box.most).cwiseAbs().maxCoeff() <= tolerance_ &&
           std::abs(a.length_mm - b.length_mm) <= 4.0 * tolerance_ + 0.01 * a.length_mm &&
           (same_chords(piece, other, tolerance_, budget_) ||
            (runs_along(piece, other, tolerance_, budget_) &&
             // Both ways. NOLINTNEXTLINE(readability-suspicious-call-argument)
             runs_along(other, piece, tolerance_, budget_)));
  }

  [[nodiscard]] std::uint64_t key_of(const Piece& piece, int dx, int dy) const {
    const auto x = static_cast<std::int64_t>(std::floor(piece.box.least.x() / tolerance_)) + dx;
    const auto y = static_cast<std::int64_t>(std::floor(piece.box.least.y() / tolerance_)) + dy;
    return static_cast<std::uint64_t>(x) * 0x9E37'79B9'7F4A'7C15U ^ static_cast<std::uint64_t>(y);
  }

  double tolerance_;
  Budget budget_;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> cells_;
};

}  // namespace

void drop_duplicates(Sketch& sketch, std::vector<Piece>& pieces, double gap_mm) {
  // Chords of one curve cut differently are apart by their tolerance, twice.
  PieceLookup lookup{std::max(gap_mm, 3.0 * kChordToleranceMm), sketch.share_of(kMostComparisons)};
  std::vector<Piece> kept;
  kept.reserve(pieces.size());
  for (Piece& piece : pieces) {
    if (const Piece* const first = lookup.find(piece, kept)) {
      const Entity& entity = first->contour.entity;
      sketch.report({FaultKind::kDuplicate,
                     piece.contour.entity,
                     piece.outline.front(),
                     fmt::format("it lies on {} of line {}", entity.name, entity.line),
                     "it is left out; delete one of them"});
      continue;
    }
    lookup.add(piece, kept.size());
    kept.push_back(std::move(piece));
  }
  if (lookup.exhausted()) {
    sketch.report({FaultKind::kUnchecked,
                   {},
                   {},
                   "too many contours lie on each other to look at all of them",
                   "remove duplicates in the drawing"});
  }
  pieces = std::move(kept);
}

}  // namespace sim::drawing
