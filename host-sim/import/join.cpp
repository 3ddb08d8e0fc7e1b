#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "host-sim/import/curve_measure.hpp"
#include "host-sim/import/piece.hpp"

namespace sim::drawing {
namespace {

// Of so many ends at one place a drawing is not made; some of them are looked at.
constexpr std::size_t kMostEndsAtAPlace = 16;
// Ends nearer than this are one place: the controller's own resolution.
constexpr double kSamePlaceMm = 1.0e-6;

/// One end of a chain: its start (even) or its end (odd).
using EndIndex = std::size_t;
constexpr EndIndex kNoEnd = static_cast<EndIndex>(-1);

struct EndPair {
  double distance_mm;
  EndIndex first;
  EndIndex second;
  auto operator<=>(const EndPair&) const = default;
};

/// Pairs the ends of chains that are near each other, the nearest first.
class EndMatcher {
 public:
  EndMatcher(const std::vector<Piece>& chains, double gap_mm)
      : chains_{chains},
        gap_{std::max(gap_mm, kSamePlaceMm)},
        partner_(2 * chains.size(), kNoEnd),
        among_others_(partner_.size(), false) {
    cells_.reserve(partner_.size());
    for (EndIndex end = 0; end < partner_.size(); ++end) {
      cells_.emplace_back(key_of(place(end)), end);
    }
    std::ranges::sort(cells_);
    gather_pairs();
    std::ranges::sort(pairs_);
    for (const EndPair& pair : pairs_) {
      if (partner_[pair.first] != kNoEnd || partner_[pair.second] != kNoEnd) continue;
      partner_[pair.first] = pair.second;
      partner_[pair.second] = pair.first;
    }
  }

  [[nodiscard]] EndIndex partner(EndIndex end) const { return partner_[end]; }
  [[nodiscard]] Place place(EndIndex end) const {
    const std::vector<Place>& outline = chains_[end / 2].outline;
    return end % 2 == 0 ? outline.front() : outline.back();
  }
  /// Whether an end that has no partner is near others that have.
  [[nodiscard]] bool among_others(EndIndex end) const { return among_others_[end]; }

 private:
  using Key = std::uint64_t;

  [[nodiscard]] Key key_of(const Place& place, int dx = 0, int dy = 0) const {
    const auto x = static_cast<std::int64_t>(std::floor(place.x() / gap_)) + dx;
    const auto y = static_cast<std::int64_t>(std::floor(place.y() / gap_)) + dy;
    return static_cast<Key>(x) * 0x9E37'79B9'7F4A'7C15U ^ static_cast<Key>(y);
  }

  void gather_pairs() {
    for (EndIndex end = 0; end < partner_.size(); ++end) {
      for (int dx = -1; dx <= 1; ++dx) {
        for (int dy = -1; dy <= 1; ++dy) gather_in(end, key_of(place(end), dx, dy));
      }
    }
  }

  void gather_in(EndIndex end, Key key) {
    std::size_t found = 0;
    for (auto at = std::ranges::lower_bound(cells_, std::pair{key, end + 1});
         at != cells_.end() && at->first == key;
         ++at) {
      const EndIndex other = at->second;
      if (found == kMostEndsAtAPlace) break;
      if (other / 2 == end / 2) continue;
      if (!same_layer(end, other)) continue;
      const double apart = distance(place(end), place(other));
      if (apart > gap_) continue;
      pairs_.push_back({apart, end, other});
      among_others_[end] = among_others_[other] = true;
      ++found;
    }
  }

  [[nodiscard]] bool same_layer(EndIndex a, EndIndex b) const {
    const Entity& first = chains_[a / 2].contour.entity;
    const Entity& second = chains_[b / 2].contour.entity;
    return first.layer == second.layer && first.part == second.part;
  }

  const std::vector<Piece>& chains_;
  double gap_;
  std::vector<EndIndex> partner_;
  std::vector<bool> among_others_;
  std::vector<EndPair> pairs_;
  std::vector<std::pair<Key, EndIndex>> cells_;  ///< Sorted.
};

/// Makes `next` begin where `shape` ends. False when a line has to go between.
bool meet(Shape& shape, Shape& next) {
  const Place end = end_of(shape);
  const Place start = start_of(next);
  if (auto* const line = std::get_if<Line>(&next)) {
    line->start = end;
  } else if (auto* const before = std::get_if<Line>(&shape)) {
    before->end = start;
  } else if (auto* const curve = std::get_if<Bezier>(&next)) {
    curve->points[1] += end - start;
    curve->points[0] = end;
  } else if (auto* const curve_before = std::get_if<Bezier>(&shape)) {
    curve_before->points[2] += start - end;
    curve_before->points[3] = start;
  } else {
    return distance(end, start) <= kSamePlaceMm;
  }
  return true;
}

void append(std::vector<Shape>& row, std::vector<Shape> more) {
  if (!row.empty() && !meet(row.back(), more.front())) {
    row.emplace_back(Line{end_of(row.back()), start_of(more.front())});
  }
  row.insert(row.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

void close(std::vector<Shape>& row) {
  if (!meet(row.back(), row.front())) {
    row.emplace_back(Line{end_of(row.back()), start_of(row.front())});
  }
}

/// Lines within the gap may have become places.
void drop_places(std::vector<Shape>& row) {
  std::erase_if(row, [](const Shape& shape) {
    const auto* const line = std::get_if<Line>(&shape);
    return line != nullptr && line->start == line->end;
  });
}

std::vector<Shape> reversed_row(std::vector<Shape> row) {
  std::ranges::reverse(row);
  for (Shape& shape : row) shape = reversed(std::move(shape));
  return row;
}

/// Follows partners from chain to chain.
class Joiner {
 public:
  Joiner(Sketch& sketch, std::vector<Piece> chains, double gap_mm, std::string remedy)
      : sketch_{sketch},
        remedy_{std::move(remedy)},
        chains_{std::move(chains)},
        ends_{chains_, gap_mm},
        taken_(chains_.size(), false) {}

  std::vector<Piece> join() {
    for (EndIndex end = 0; end < 2 * chains_.size(); ++end) {
      if (ends_.partner(end) == kNoEnd) alone_.push_back(end);
    }
    for (const EndIndex end : alone_) {
      if (!taken_[end / 2]) follow(end);
    }
    for (std::size_t chain = 0; chain < chains_.size(); ++chain) {
      if (!taken_[chain]) follow(2 * chain);
    }
    return std::move(pieces_);
  }

 private:
  void follow(EndIndex from) {
    Piece piece;
    piece.contour.entity = chains_[from / 2].contour.entity;
    EndIndex end = from;
    EndIndex next = kNoEnd;
    for (std::size_t bound = 0; bound <= chains_.size(); ++bound) {
      std::vector<Shape> shapes = std::move(chains_[end / 2].contour.shapes);
      taken_[end / 2] = true;
      append(piece.contour.shapes,
             end % 2 == 0 ? std::move(shapes) : reversed_row(std::move(shapes)));
      next = ends_.partner(end ^ 1U);
      if (next == kNoEnd || taken_[next / 2]) break;
      end = next;
    }
    piece.contour.closed = next != kNoEnd;
    if (piece.contour.closed) close(piece.contour.shapes);
    drop_places(piece.contour.shapes);
    measure(piece);
    if (!piece.contour.closed) report(piece, from, end ^ 1U);
    pieces_.push_back(std::move(piece));
  }

  void report(const Piece& piece, EndIndex first, EndIndex last) {
    report_end(piece, first, piece.outline.front(), piece.outline.back());
    if (ends_.among_others(first) != ends_.among_others(last)) {
      report_end(piece, last, piece.outline.back(), piece.outline.front());
    }
  }

  void report_end(const Piece& piece, EndIndex end, const Place& place, const Place& other) {
    const Entity& entity = chains_[end / 2].contour.entity;
    if (ends_.among_others(end)) {
      sketch_.report({FaultKind::kBranch,
                      entity,
                      place,
                      "more than two ends meet here",
                      "leave two of them, or put the others on another layer"});
      return;
    }
    sketch_.report({FaultKind::kOpen,
                    entity,
                    place,
                    fmt::format("the contour is open: {:.3f} mm of path, its ends {:.3f} mm apart, "
                                "the other at {:.3f} {:.3f}",
                                piece.contour.length_mm,
                                distance(place, other),
                                other.x(),
                                other.y()),
                    "close it, or " + remedy_});
  }

  Sketch& sketch_;
  std::string remedy_;
  std::vector<Piece> chains_;
  EndMatcher ends_;
  std::vector<bool> taken_;
  std::vector<EndIndex> alone_;
  std::vector<Piece> pieces_;
};

}  // namespace

void measure(Piece& piece) {
  DrawnContour& contour = piece.contour;
  piece.outline = outline_of(contour.shapes, kChordToleranceMm);
  piece.outline.shrink_to_fit();
  piece.box = box_of(piece.outline);
  contour.length_mm = 0.0;
  double area = 0.0;
  const Place from = piece.outline.front();
  for (const Shape& shape : contour.shapes) {
    contour.length_mm += length_of(shape);
    if (contour.closed) area += swept_area(shape, from);
  }
  contour.area_mm2 = area;
}

std::vector<Piece> join(Sketch& sketch,
                        std::vector<Piece> chains,
                        double gap_mm,
                        const std::string& remedy) {
  std::vector<Piece> closed;
  std::vector<Piece> open;
  for (Piece& chain : chains) {
    const double apart = distance(chain.outline.front(), chain.outline.back());
    if (chain.contour.length_mm <= gap_mm) {
      sketch.report({FaultKind::kTooSmall,
                     chain.contour.entity,
                     chain.outline.front(),
                     "it is shorter than the gaps that are joined",
                     "delete it, or join smaller gaps only"});
    } else if (apart <= std::max(gap_mm, kSamePlaceMm)) {
      close(chain.contour.shapes);
      drop_places(chain.contour.shapes);
      chain.contour.closed = true;
      measure(chain);
      closed.push_back(std::move(chain));
    } else {
      open.push_back(std::move(chain));
    }
  }
  for (Piece& piece : Joiner{sketch, std::move(open), gap_mm, remedy}.join()) {
    closed.push_back(std::move(piece));
  }
  return closed;
}

}  // namespace sim::drawing
