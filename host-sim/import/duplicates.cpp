#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <unordered_map>

#include "host-sim/import/curve_measure.hpp"
#include "host-sim/import/piece.hpp"

namespace sim::drawing {
namespace {

// Greatest number of distances between points and chords to compute. This many take some seconds.
constexpr std::size_t kMaxComparisons = 300'000'000;
constexpr std::size_t kPlacesCompared = 256;

/// Returns whether points of `outline` lie on `other`. Checks all points of a short outline, and
/// evenly selected points of a long one.
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

/// Returns whether two pieces have the same chords in the same order, as copies of one contour
/// have.
bool same_chords(const Piece& piece, const Piece& other, double tolerance, Budget& budget) {
  const auto near = [tolerance](const Place& a, const Place& b) {
    return distance(a, b) <= tolerance;
  };
  return budget.spend(piece.outline.size()) &&
         std::ranges::equal(piece.outline, other.outline, near);
}

/// The pieces with which each piece is compared: the pieces of the same layer, or the pieces of all
/// layers.
enum class Among : std::uint8_t { kLayer, kAll };

/// Finds earlier pieces that run along the path of a piece. The pieces are sorted into cells by the
/// lower left corners of their boxes.
class PieceLookup {
 public:
  PieceLookup(Among among, double tolerance, std::size_t comparisons)
      : among_{among}, tolerance_{tolerance}, budget_{comparisons} {}

  /// Returns the index in `kept` of a piece that runs along the same path; nothing if there is
  /// none.
  std::optional<std::size_t> find(const Piece& piece, const std::vector<Piece>& kept) {
    if (budget_.exhausted()) return std::nullopt;
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        const auto cell = cells_.find(key_of(piece, dx, dy));
        if (cell == cells_.end()) continue;
        for (const std::size_t index : cell->second) {
          if (same(piece, kept[index])) return index;
        }
      }
    }
    return std::nullopt;
  }

  void add(const Piece& piece, std::size_t index) { cells_[key_of(piece, 0, 0)].push_back(index); }

  [[nodiscard]] bool exhausted() const { return budget_.exhausted(); }

 private:
  bool same(const Piece& piece, const Piece& other) {
    if (!budget_.spend(1)) return false;
    const DrawnContour& a = piece.contour;
    const DrawnContour& b = other.contour;
    return a.closed == b.closed && a.entity.part == b.entity.part &&
           (among_ == Among::kAll || a.entity.layer == b.entity.layer) &&
           (piece.box.least - other.box.least).cwiseAbs().maxCoeff() <= tolerance_ &&
           (piece.box.most - other.box.most).cwiseAbs().maxCoeff() <= tolerance_ &&
           std::abs(a.length_mm - b.length_mm) <= 4.0 * tolerance_ + 0.01 * a.length_mm &&
           (same_chords(piece, other, tolerance_, budget_) ||
            (runs_along(piece, other, tolerance_, budget_) &&
             // Both directions are checked: each piece must run along the other one.
             // NOLINTNEXTLINE(readability-suspicious-call-argument)
             runs_along(other, piece, tolerance_, budget_)));
  }

  [[nodiscard]] std::uint64_t key_of(const Piece& piece, int dx, int dy) const {
    const auto x = static_cast<std::int64_t>(std::floor(piece.box.least.x() / tolerance_)) + dx;
    const auto y = static_cast<std::int64_t>(std::floor(piece.box.least.y() / tolerance_)) + dy;
    return static_cast<std::uint64_t>(x) * 0x9E37'79B9'7F4A'7C15U ^ static_cast<std::uint64_t>(y);
  }

  Among among_;
  double tolerance_;
  Budget budget_;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> cells_;
};

/// Returns the tolerance of the comparison, mm. Two divisions of one curve into chords may differ
/// by twice the tolerance of the chords.
double tolerance_for(double gap_mm) { return std::max(gap_mm, 3.0 * kChordToleranceMm); }

void report_exhausted(Sketch& sketch) {
  sketch.report({FaultKind::kUnchecked,
                 {},
                 {},
                 "too many contours lie on each other to compare all of them",
                 "remove duplicates in the drawing"});
}

}  // namespace

void drop_duplicates(Sketch& sketch, std::vector<Piece>& pieces, double gap_mm) {
  PieceLookup lookup{Among::kLayer, tolerance_for(gap_mm), sketch.share_of(kMaxComparisons)};
  std::vector<Piece> kept;
  kept.reserve(pieces.size());
  for (Piece& piece : pieces) {
    if (const auto first = lookup.find(piece, kept)) {
      const Entity& entity = kept[*first].contour.entity;
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
  if (lookup.exhausted()) report_exhausted(sketch);
  pieces = std::move(kept);
}

void find_coincident(Sketch& sketch, std::vector<Piece>& pieces, double gap_mm) {
  PieceLookup lookup{Among::kAll, tolerance_for(gap_mm), sketch.share_of(kMaxComparisons)};
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    DrawnContour& contour = pieces[i].contour;
    contour.lies_on = lookup.find(pieces[i], pieces);
    if (!contour.lies_on) {
      lookup.add(pieces[i], i);
      continue;
    }
    const Entity& entity = pieces[*contour.lies_on].contour.entity;
    sketch.report(
        {FaultKind::kDuplicate,
         contour.entity,
         pieces[i].outline.front(),
         fmt::format("it lies on {} of line {}, of another layer", entity.name, entity.line),
         "it is cut once; delete one of them"});
  }
  if (lookup.exhausted()) report_exhausted(sketch);
}

}  // namespace sim::drawing
