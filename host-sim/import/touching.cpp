#include "host-sim/import/touching.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <utility>

#include "host-sim/import/curve_measure.hpp"
#include "host-sim/import/near_order.hpp"
#include "planner/contour/box_tree.hpp"

namespace sim::drawing {
namespace {

// Greatest number of pairs of chords that are checked. This many take some seconds.
constexpr std::size_t kMaxChordPairs = 200'000'000;
// Greatest distance between chords of two curves that touch, mm: twice the tolerance of chords, and
// some space for rounding.
constexpr double kNearMm = 2.5 * kChordToleranceMm;
// Least length of the path from the start of one chord to the end of a later chord of the same
// contour at which the two chords are compared, mm. A shorter path encloses nothing that could be
// cut. Finely drawn curves have many pairs of chords with such short paths.
constexpr double kShortPathMm = 0.01;

/// A chord of an outline.
struct Chord {
  Place start;
  Place end;
};

bool cross_each_other(const Chord& a, const Chord& b) {
  const auto parts = [](const Chord& by, const Chord& other) {
    const Place way = by.end - by.start;
    return (cross(way, other.start - by.start) > 0.0) != (cross(way, other.end - by.start) > 0.0);
  };
  return parts(a, b) && parts(b, a);
}

bool are_near(const Chord& a, const Chord& b) {
  if (cross_each_other(a, b)) return true;
  return std::min({distance_to_chord(a.start, b.start, b.end),
                   distance_to_chord(a.end, b.start, b.end),
                   distance_to_chord(b.start, a.start, a.end),
                   distance_to_chord(b.end, a.start, a.end)}) <= kNearMm;
}

/// Returns whether the chord `b`, which follows the chord `a`, runs back along it.
bool turns_back(const Chord& a, const Chord& b) {
  const Place in = a.end - a.start;
  const Place out = b.end - b.start;
  if (dot(in, out) >= 0.0) return false;
  return in.squaredNorm() < out.squaredNorm()
             ? distance_to_chord(a.start, b.start, b.end) <= kNearMm
             : distance_to_chord(b.end, a.start, a.end) <= kNearMm;
}

using Box = cnc::contour::FlatBox<double>;

Box box_of_chord(const Place& start, const Place& end) {
  const auto [left, right] = std::minmax(start.x(), end.x());
  const auto [low, high] = std::minmax(start.y(), end.y());
  return {left, low, right, high};
}

Box box_near(const Box& box) {
  return {box.x0 - kNearMm, box.y0 - kNearMm, box.x1 + kNearMm, box.y1 + kNearMm};
}

/// A searchable set of boxes. It is reused: fill() replaces its content.
class Boxes {
 public:
  /// Replaces the boxes by `box_at(i)` for all i < count.
  template <typename BoxAt>
  void fill(std::size_t count, const BoxAt& box_at) {
    const std::size_t size = Tree::size_for(count);
    if (boxes_.size() < size) boxes_.resize(size);
    tree_ = Tree{{boxes_.data(), boxes_.size()}};
    for (std::uint32_t i = 0; i < count; ++i) tree_.leaf(i) = box_at(i);
    tree_.build(static_cast<std::uint32_t>(count));
  }
  /// Calls `visit(i)` for each box from number `from` on that is near `box`, until a call returns
  /// false.
  template <typename Visit>
  void search(const Box& box, std::uint32_t from, const Visit& visit) const {
    tree_.search(box_near(box), from, visit);
  }

 private:
  using Tree = cnc::contour::BoxTree<double>;
  std::vector<Box> boxes_;
  Tree tree_{cnc::contour::Slice<Box>{}};
};

/// Finds pieces that may touch. Compares each piece with itself and with near pieces that have
/// fewer chords. `chords_` contains the chords of one piece at a time.
class TouchFinder {
 public:
  TouchFinder(Sketch& sketch, const std::vector<Piece>& pieces)
      : sketch_{sketch},
        pieces_{pieces},
        touching_{PieceSets{pieces.size()}, std::vector<bool>(pieces.size(), false)},
        budget_{sketch.share_of(kMaxChordPairs)} {
    for (std::uint32_t i = 0; i < pieces.size(); ++i) {
      if (pieces[i].contour.closed && chords_of(i) > 0) closed_.push_back(i);
    }
    sort_by_place();
    near_.fill(closed_.size(), [&](std::uint32_t i) {
      const OutlineBox& box = pieces_[closed_[i]].box;
      return box_of_chord(box.least, box.most);
    });
  }

  void run() {
    for (const std::uint32_t piece : closed_) {
      chords_.fill(chords_of(piece), [&](std::uint32_t i) {
        return box_of_chord(place(piece, i), place(piece, i + 1));
      });
      look_at_itself(piece);
      look_at_others(piece);
      if (budget_.exhausted()) return report_end(piece);
    }
  }
  [[nodiscard]] TouchingPieces found() && { return std::move(touching_); }

 private:
  [[nodiscard]] const Place& place(std::uint32_t piece, std::uint32_t index) const {
    return pieces_[piece].outline[index];
  }
  [[nodiscard]] std::uint32_t chords_of(std::uint32_t piece) const {
    const std::size_t places = pieces_[piece].outline.size();
    return places == 0 ? 0 : static_cast<std::uint32_t>(places - 1);
  }

  /// Sorts the closed pieces so that pieces near each other in the plane are mostly near each other
  /// in the list.
  void sort_by_place() {
    OutlineBox all;
    for (const std::uint32_t piece : closed_) {
      all.include(pieces_[piece].box.least);
      all.include(pieces_[piece].box.most);
    }
    constexpr double kCells = 1 << 20;
    const double size = std::max({all.width(), all.height(), 1.0e-9});
    std::vector<std::pair<std::uint64_t, std::uint32_t>> keys;
    keys.reserve(closed_.size());
    for (const std::uint32_t piece : closed_) {
      const OutlineBox& box = pieces_[piece].box;
      const Place cell = (0.5 * (box.least + box.most) - all.least) * (kCells / size);
      keys.emplace_back(
          near_order(static_cast<std::uint32_t>(cell.x()), static_cast<std::uint32_t>(cell.y())),
          piece);
    }
    std::ranges::sort(keys);
    std::ranges::transform(keys, closed_.begin(), &std::pair<std::uint64_t, std::uint32_t>::second);
  }

  /// Compares a piece with itself.
  /// @pre `chords_` contains the chords of the piece
  void look_at_itself(std::uint32_t piece) {
    along_mm_.assign(1, 0.0);
    const std::uint32_t count = chords_of(piece);
    for (std::uint32_t i = 0; i < count; ++i) {
      along_mm_.push_back(along_mm_.back() + distance(place(piece, i), place(piece, i + 1)));
    }
    for (std::uint32_t i = 0; i < count && !touching_.touches[piece]; ++i) {
      if (!budget_.spend(1)) return;
      const Chord chord{place(piece, i), place(piece, i + 1)};
      chords_.search(box_of_chord(chord.start, chord.end), i + 1, [&](std::uint32_t k) {
        if (touch_itself(piece, i, k)) touching_.touches[piece] = true;
        return budget_.spend(1) && !touching_.touches[piece];
      });
    }
  }

  /// Compares a piece with near pieces.
  /// @pre `chords_` contains the chords of the piece
  void look_at_others(std::uint32_t piece) {
    const Entity& entity = pieces_[piece].contour.entity;
    const OutlineBox& box = pieces_[piece].box;
    near_.search(box_of_chord(box.least, box.most), 0, [&](std::uint32_t i) {
      const std::uint32_t other = closed_[i];
      const bool is_smaller =
          std::pair{chords_of(other), other} < std::pair{chords_of(piece), piece};
      const Entity& of_other = pieces_[other].contour.entity;
      if (!is_smaller || !sketch_.fill_together(entity, of_other)) return true;
      if (touching_.touches[piece] && touching_.sets.are_one(piece, other)) return true;
      if (touch_other(piece, other)) {
        touching_.touches[piece] = touching_.touches[other] = true;
        touching_.sets.unite(piece, other);
      }
      return !budget_.exhausted();
    });
  }

  [[nodiscard]] bool touch_other(std::uint32_t piece, std::uint32_t other) {
    const OutlineBox& box = pieces_[piece].box;
    const Box around = box_near(box_of_chord(box.least, box.most));
    bool touches = false;
    for (std::uint32_t i = 0; i < chords_of(other) && !touches; ++i) {
      if (!budget_.spend(1)) return false;
      const Chord chord{place(other, i), place(other, i + 1)};
      const Box own = box_of_chord(chord.start, chord.end);
      if (!around.meets(own)) continue;
      chords_.search(own, 0, [&](std::uint32_t k) {
        touches = are_near({place(piece, k), place(piece, k + 1)}, chord);
        return budget_.spend(1) && !touches;
      });
    }
    return touches;
  }

  [[nodiscard]] bool is_short_path(std::uint32_t first, std::uint32_t last) const {
    const double ahead = along_mm_[last + 1] - along_mm_[first];
    const double round_the_seam = along_mm_.back() - along_mm_[last] + along_mm_[first + 1];
    return std::min(ahead, round_the_seam) < kShortPathMm;
  }

  /// Returns whether two chords of a piece touch.
  /// @pre first < last
  [[nodiscard]] bool touch_itself(std::uint32_t piece,
                                  std::uint32_t first,
                                  std::uint32_t last) const {
    const Chord a{place(piece, first), place(piece, first + 1)};
    const Chord b{place(piece, last), place(piece, last + 1)};
    if (first + 1 == last) return turns_back(a, b);
    if (first == 0 && last + 1 == chords_of(piece)) return turns_back(b, a);
    return !is_short_path(first, last) && are_near(a, b);
  }

  void report_end(std::uint32_t piece) {
    sketch_.report({FaultKind::kUnchecked,
                    pieces_[piece].contour.entity,
                    place(piece, 0),
                    fmt::format("too many curves lie close together to search all of them "
                                "for crossings: {} pairs of curves were compared",
                                sketch_.share_of(kMaxChordPairs)),
                    "simplify the drawing here, or divide it into several files"});
  }

  Sketch& sketch_;
  const std::vector<Piece>& pieces_;
  TouchingPieces touching_;
  Budget budget_;
  /// Numbers of the closed pieces, in the order of sort_by_place().
  std::vector<std::uint32_t> closed_;
  Boxes near_;    ///< Boxes of the pieces of `closed_`.
  Boxes chords_;  ///< Boxes of the chords of the piece that is being compared.
  /// Length of the path of this piece from its start to each of its points, mm.
  std::vector<double> along_mm_;
};

}  // namespace

TouchingPieces find_touching(Sketch& sketch, const std::vector<Piece>& pieces) {
  TouchFinder finder{sketch, pieces};
  finder.run();
  return std::move(finder).found();
}

}  // namespace sim::drawing
