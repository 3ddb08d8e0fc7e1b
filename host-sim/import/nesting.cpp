#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <span>

#include "host-sim/import/piece.hpp"

namespace sim::drawing {
namespace {

constexpr std::size_t kMaxRayCrossings = 400'000'000;

/// Returns the x coordinates at which a horizontal line crosses an outline, in ascending order.
std::vector<double> cuts_at(const std::vector<Place>& outline, double y) {
  std::vector<double> cuts;
  for (std::size_t i = 1; i < outline.size(); ++i) {
    const Place& a = outline[i - 1];
    const Place& b = outline[i];
    if ((a.y() <= y) == (b.y() <= y)) continue;
    cuts.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
  }
  std::ranges::sort(cuts);
  return cuts;
}

/// Returns a point inside a piece, away from its edges, because neighbouring pieces may share
/// edges. Of the intervals inside the piece at three heights, takes the middle of the widest one.
Place place_inside(const Piece& piece) {
  Place best = piece.outline.front();
  double widest = -1.0;
  for (const double share : {0.4871, 0.3229, 0.6513}) {
    const double y = piece.box.least.y() + share * piece.box.height();
    const std::vector<double> cuts = cuts_at(piece.outline, y);
    for (std::size_t i = 1; i < cuts.size(); i += 2) {
      if (cuts[i] - cuts[i - 1] <= widest) continue;
      widest = cuts[i] - cuts[i - 1];
      best = {0.5 * (cuts[i] + cuts[i - 1]), y};
    }
  }
  return best;
}

/// Chords of closed pieces, sorted into horizontal strips of equal height. A chord is in each strip
/// that it touches.
class Strips {
 public:
  explicit Strips(const std::vector<Piece>& pieces) : pieces_{pieces} {
    double rise = 0.0;
    std::size_t chords = 0;
    for (const Piece& piece : pieces) {
      if (!piece.contour.closed) continue;
      min_ = std::min(min_, piece.box.least.y());
      max_ = std::max(max_, piece.box.most.y());
      chords += piece.outline.size();
      for (std::size_t i = 1; i < piece.outline.size(); ++i) {
        rise += std::abs(piece.outline[i].y() - piece.outline[i - 1].y());
      }
    }
    if (chords == 0) return;
    height_ = std::max({rise / static_cast<double>(chords), (max_ - min_) / 1.0e6, 1.0e-6});
    fill();
  }

  /// Counts in `hits`, for each piece, its crossings of the ray from `place` to the right. `place`
  /// may be outside of all strips. Returns false if the budget is spent.
  bool count(const Place& place, std::map<std::size_t, std::size_t>& hits, Budget& budget) const {
    // Cost of the full check of a chord, relative to the cost of the check of a piece's box.
    constexpr std::size_t kCloseLook = 16;
    if (place.y() < min_ || place.y() > max_) return true;
    const std::size_t number = strip_of(place.y());
    const std::span strip =
        std::span{chords_}.subspan(ends_[number], ends_[number + 1] - ends_[number]);
    std::size_t close = 0;
    for (const auto& [piece, i] : strip) {
      if (!pieces_[piece].box.around({.least = place, .most = place})) continue;
      ++close;
      const Place& a = pieces_[piece].outline[i];
      const Place& b = pieces_[piece].outline[i + 1];
      if ((a.y() <= place.y()) == (b.y() <= place.y())) continue;
      const double x = a.x() + (place.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
      if (x > place.x()) ++hits[piece];
    }
    return budget.spend(strip.size() + kCloseLook * close);
  }

 private:
  struct Chord {
    std::uint32_t piece = 0;
    std::uint32_t index = 0;
  };

  [[nodiscard]] std::size_t strip_of(double y) const {
    return static_cast<std::size_t>(std::max(0.0, std::floor((y - min_) / height_)));
  }

  /// Sorts the chords into strips. Counts the chords of each strip first, because lists that grow
  /// would take several times the memory.
  void fill() {
    ends_.assign(strip_of(max_) + 2, 0);
    for_each_chord([this](std::size_t strip, const Chord&) { ++ends_[strip + 1]; });
    std::partial_sum(ends_.begin(), ends_.end(), ends_.begin());
    chords_.resize(ends_.back());
    std::vector<std::size_t> next = ends_;
    for_each_chord([&](std::size_t strip, const Chord& chord) { chords_[next[strip]++] = chord; });
  }

  template <typename Visit>
  void for_each_chord(const Visit& visit) const {
    for (std::uint32_t piece = 0; piece < pieces_.size(); ++piece) {
      if (!pieces_[piece].contour.closed) continue;
      const std::vector<Place>& outline = pieces_[piece].outline;
      for (std::uint32_t i = 0; i + 1 < outline.size(); ++i) {
        const auto [low, high] = std::minmax(outline[i].y(), outline[i + 1].y());
        const std::size_t last = strip_of(high);
        for (std::size_t strip = strip_of(low); strip <= last; ++strip) visit(strip, {piece, i});
      }
    }
  }

  const std::vector<Piece>& pieces_;
  double min_ = OutlineBox::kInfinite;
  double max_ = -OutlineBox::kInfinite;
  double height_ = 1.0;
  /// For each strip, the index of its first chord in `chords_`. The chords of a strip end where
  /// those of the next strip begin.
  std::vector<std::size_t> ends_;
  std::vector<Chord> chords_;
};

/// Finds, among the pieces that surround a point, the piece with the smallest area.
struct Innermost {
  void look_at(std::size_t other, double area) {
    if (area >= smallest) return;
    smallest = area;
    piece = other;
  }

  std::optional<std::size_t> piece{};
  double smallest = OutlineBox::kInfinite;
};

/// Returns the distance between the points that are checked along open outlines, mm. It is great
/// enough to bound the total number of these points.
double spacing_of_places(const std::vector<Piece>& pieces) {
  constexpr double kEveryMm = 2.0;
  constexpr double kMaxChecked = 500'000.0;
  double length = 0.0;
  for (const Piece& piece : pieces) {
    if (!piece.contour.closed) length += piece.contour.length_mm;
  }
  return std::max(kEveryMm, length / kMaxChecked);
}

/// Returns points along an open outline: at least three, at most `every_mm` apart.
std::vector<Place> places_along(const Piece& piece, double every_mm) {
  const double length = piece.contour.length_mm;
  const double count = std::max(std::ceil(length / every_mm), 3.0);
  std::vector<Place> places;
  double way = 0.0;
  for (std::size_t i = 1; i < piece.outline.size(); ++i) {
    const Place& from = piece.outline[i - 1];
    const Place& to = piece.outline[i];
    const double chord = distance(from, to);
    while (true) {
      const double next = (static_cast<double>(places.size()) + 0.5) * length / count;
      if (next > way + chord || chord <= 0.0) break;
      places.emplace_back(from + std::max(next - way, 0.0) / chord * (to - from));
    }
    way += chord;
  }
  return places;
}

void turn_as_nested(DrawnContour& contour) {
  if ((contour.area_mm2 < 0.0) == contour.is_hole()) return;
  std::ranges::reverse(contour.shapes);
  for (Shape& shape : contour.shapes) shape = reversed(std::move(shape));
  contour.area_mm2 = -contour.area_mm2;
}

}  // namespace

namespace {

/// Finds the contours around an open contour. Returns false if the budget is spent.
bool find_around(std::vector<Piece>& pieces,
                 std::size_t index,
                 double every_mm,
                 const Strips& strips,
                 Budget& budget) {
  std::map<std::size_t, std::size_t> places_in;
  std::map<std::size_t, std::size_t> hits;
  for (const Place& place : places_along(pieces[index], every_mm)) {
    hits.clear();
    if (!strips.count(place, hits, budget)) return false;
    Innermost around;
    for (const auto& [other, count] : hits) {
      if (count % 2 != 0) around.look_at(other, std::abs(pieces[other].contour.area_mm2));
    }
    if (around.piece) ++places_in[*around.piece];
  }
  std::size_t most = 0;
  for (const auto& [other, count] : places_in) {
    pieces[index].contour.runs_through.push_back(other);
    if (count <= most) continue;
    most = count;
    pieces[index].contour.lies_in = other;
  }
  return true;
}

}  // namespace

void nest(Sketch& sketch, std::vector<Piece>& pieces) {
  const Strips strips{pieces};
  const double every_mm = spacing_of_places(pieces);
  Budget budget{sketch.share_of(kMaxRayCrossings)};
  std::map<std::size_t, std::size_t> hits;
  for (std::size_t index = 0; index < pieces.size(); ++index) {
    DrawnContour& contour = pieces[index].contour;
    if (!contour.closed) {
      if (!find_around(pieces, index, every_mm, strips, budget)) break;
      continue;
    }
    hits.clear();
    if (!strips.count(place_inside(pieces[index]), hits, budget)) break;
    Innermost of_its_part;
    Innermost of_all;
    for (const auto& [other, count] : hits) {
      const double area = std::abs(pieces[other].contour.area_mm2);
      // Two contours may each surround the inner point of the other. The contour with the greater
      // area then counts as the outer contour.
      if (count % 2 == 0 || other == index || area <= std::abs(contour.area_mm2)) continue;
      of_all.look_at(other, area);
      if (pieces[other].contour.entity.part != contour.entity.part) continue;
      ++contour.depth;
      of_its_part.look_at(other, area);
    }
    contour.parent = of_its_part.piece;
    contour.lies_in = of_all.piece;
  }
  for (Piece& piece : pieces) {
    if (piece.contour.closed) turn_as_nested(piece.contour);
  }
  if (budget.exhausted()) {
    sketch.report({FaultKind::kUnchecked,
                   {},
                   {},
                   "there are too many contours to determine which of them are holes",
                   "divide the drawing into several files"});
  }
}

}  // namespace sim::drawing
