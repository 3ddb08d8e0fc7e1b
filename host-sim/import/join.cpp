#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "host-sim/import/curve_measure.hpp"
#include "host-sim/import/end_matcher.hpp"
#include "host-sim/import/extent.hpp"
#include "host-sim/import/loose_ends.hpp"
#include "host-sim/import/piece.hpp"

namespace sim::drawing {
namespace {

/// Makes `shape` end where `next` starts, by moving an end of a line or Bézier curve, if the two
/// points are within the gap. Returns false if a line is needed between them.
bool meet(Shape& shape, Shape& next, double gap_mm) {
  const Place end = end_of(shape);
  const Place start = start_of(next);
  if (distance(end, start) > std::max(gap_mm, kSamePlaceMm)) return false;
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

void append(std::vector<Shape>& row, std::vector<Shape> more, double gap_mm) {
  if (!row.empty() && !meet(row.back(), more.front(), gap_mm)) {
    row.emplace_back(Line{end_of(row.back()), start_of(more.front())});
  }
  row.insert(row.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

void close(std::vector<Shape>& row, double gap_mm) {
  if (!meet(row.back(), row.front(), gap_mm)) {
    row.emplace_back(Line{end_of(row.back()), start_of(row.front())});
  }
}

/// Removes lines without length, because meet() may move both ends of a short line to one point.
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

/// Joins chains to pieces: continues from each end of a chain to the partner of this end.
class Joiner {
 public:
  Joiner(
      Sketch& sketch, std::vector<Piece> chains, double gap_mm, bool mends_gaps, std::string remedy)
      : sketch_{sketch},
        gap_mm_{gap_mm},
        mends_gaps_{mends_gaps},
        remedy_{std::move(remedy)},
        chains_{std::move(chains)},
        ends_{chains_, gap_mm},
        taken_(chains_.size(), false) {}

  std::vector<Piece> join() {
    if (mends_gaps_) note_gaps(ends_.pair_certain());
    for (EndIndex end = 0; end < 2 * chains_.size(); ++end) {
      if (ends_.partner(end) == kNoEnd) alone_.push_back(end);
    }
    for (const EndIndex end : alone_) {
      if (!taken_[end / 2]) follow(end);
    }
    for (std::size_t chain = 0; chain < chains_.size(); ++chain) {
      if (!taken_[chain]) follow(2 * chain);
    }
    judge_open();
    return std::move(pieces_);
  }

 private:
  /// An open piece, given by its number, and the chain ends at which it begins and ends.
  struct OpenPiece {
    std::size_t piece;
    EndIndex first;
    EndIndex last;
  };

  void follow(EndIndex from) {
    Piece piece;
    piece.contour.entity = chains_[from / 2].contour.entity;
    EndIndex end = from;
    EndIndex next = kNoEnd;
    for (std::size_t bound = 0; bound <= chains_.size(); ++bound) {
      std::vector<Shape> shapes = std::move(chains_[end / 2].contour.shapes);
      taken_[end / 2] = true;
      append(piece.contour.shapes,
             end % 2 == 0 ? std::move(shapes) : reversed_row(std::move(shapes)),
             gap_mm_);
      next = ends_.partner(end ^ 1U);
      if (next == kNoEnd || taken_[next / 2]) break;
      end = next;
    }
    piece.contour.closed = next != kNoEnd;
    if (piece.contour.closed) close(piece.contour.shapes, gap_mm_);
    drop_places(piece.contour.shapes);
    measure(piece);
    if (!piece.contour.closed) {
      open_.push_back({pieces_.size(), from, end ^ 1U});
      loose_.add(piece);
    }
    pieces_.push_back(std::move(piece));
  }

  /// Closes pieces that nearly close themselves, and reports pieces that stay open.
  void judge_open() {
    loose_.prepare();
    for (std::size_t i = 0; i < open_.size(); ++i) {
      const OpenPiece& open = open_[i];
      Piece& piece = pieces_[open.piece];
      const bool has_branch = ends_.among_others(open.first) || ends_.among_others(open.last);
      if (mends_gaps_ && !has_branch && nearly_closes(piece, i)) {
        close_itself(piece);
        continue;
      }
      piece.contour.is_doubtful = has_branch || loose_.is_of_pair(2 * i, kWidestDoubtfulGapMm) ||
                                  loose_.is_of_pair(2 * i + 1, kWidestDoubtfulGapMm);
      report(piece, open);
    }
    if (closed_ == 0) return;
    sketch_.report({FaultKind::kMended,
                    widest_entity_,
                    widest_.place,
                    fmt::format("{} contour{} nearly closed, without a third end near, and closed "
                                "by a line; the longest line, here, has {:.3f} mm",
                                closed_,
                                closed_ == 1 ? " is" : "s are",
                                widest_.size),
                    "draw them closed, or set --gap if a gap is meant"});
  }

  /// Returns whether the gap between the ends of a piece is probably a mistake, because it is short
  /// compared with the contour and no other end is near.
  [[nodiscard]] bool nearly_closes(const Piece& piece, std::size_t open) const {
    constexpr double kMaxShare = 0.02;
    const double apart = distance(piece.outline.front(), piece.outline.back());
    return apart <= kWidestProposedGapMm && apart <= kMaxShare * piece.contour.length_mm &&
           loose_.are_pair(2 * open, 2 * open + 1);
  }

  void close_itself(Piece& piece) {
    const Place from = piece.outline.back();
    const Place to = piece.outline.front();
    ++closed_;
    if (distance(from, to) > widest_.size) widest_entity_ = piece.contour.entity;
    widest_.take_greater(distance(from, to), from);
    piece.contour.shapes.emplace_back(Line{from, to});
    piece.contour.closed = true;
    measure(piece);
  }

  void report(const Piece& piece, const OpenPiece& open) {
    report_end(piece, open.first, piece.outline.front(), piece.outline.back());
    if (ends_.among_others(open.first) != ends_.among_others(open.last)) {
      report_end(piece, open.last, piece.outline.back(), piece.outline.front());
    }
  }

  void report_end(const Piece& piece, EndIndex end, const Place& place, const Place& other) {
    const Entity& entity = chains_[end / 2].contour.entity;
    if (ends_.among_others(end)) {
      sketch_.report({FaultKind::kBranch,
                      entity,
                      place,
                      "more than two ends meet here",
                      "keep two of them, or move the others to another layer"});
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
                    "close it, or " + remedy_,
                    !piece.contour.is_doubtful});
  }

  void note_gaps(const CertainGaps& gaps) {
    if (gaps.count == 0) return;
    sketch_.report({FaultKind::kMended,
                    {},
                    gaps.widest.place,
                    fmt::format("{} gap{} between two ends without a third end near {} joined by "
                                "lines; the longest line, here, has {:.3f} mm",
                                gaps.count,
                                gaps.count == 1 ? "" : "s",
                                gaps.count == 1 ? "is" : "are",
                                gaps.widest.size),
                    "draw them joined, or set --gap"});
  }

  Sketch& sketch_;
  double gap_mm_;
  bool mends_gaps_;
  std::string remedy_;
  std::vector<Piece> chains_;
  EndMatcher ends_;
  std::vector<bool> taken_;
  std::vector<EndIndex> alone_;
  std::vector<Piece> pieces_;
  std::vector<OpenPiece> open_;
  LooseEnds loose_;  ///< Ends of the pieces of `open_`, in the same order: two for each piece.
  std::size_t closed_ = 0;  ///< Number of nearly closed pieces that were closed by a line.
  Extent widest_{};  ///< Length of the longest line that closed a piece, mm, and its position.
  Entity widest_entity_{};
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
                        bool mends_gaps,
                        const std::string& remedy) {
  std::vector<Piece> closed;
  std::vector<Piece> open;
  for (Piece& chain : chains) {
    const double apart = distance(chain.outline.front(), chain.outline.back());
    if (chain.contour.length_mm <= gap_mm) {
      // A piece as short as this one is not visible, so it is no error. One note gives the number
      // of these pieces.
      sketch.note({FaultKind::kIgnored,
                   chain.contour.entity,
                   chain.outline.front(),
                   "shorter than the gaps that are joined",
                   "set a smaller --gap to keep it"});
    } else if (apart <= std::max(gap_mm, kSamePlaceMm)) {
      close(chain.contour.shapes, gap_mm);
      drop_places(chain.contour.shapes);
      chain.contour.closed = true;
      measure(chain);
      closed.push_back(std::move(chain));
    } else {
      open.push_back(std::move(chain));
    }
  }
  for (Piece& piece : Joiner{sketch, std::move(open), gap_mm, mends_gaps, remedy}.join()) {
    closed.push_back(std::move(piece));
  }
  return closed;
}

}  // namespace sim::drawing
