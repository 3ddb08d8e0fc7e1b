#include "host-sim/pocket/stock_parts.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>

#include "host-sim/pocket/areas.hpp"
#include "host-sim/pocket/depth_writer.hpp"
#include "host-sim/pocket/driven_loop.hpp"
#include "host-sim/pocket/lead_arc.hpp"
#include "host-sim/pocket/loop_pieces.hpp"

namespace sim::pocket {
namespace {

using cnc::WideVec2;
using cnc::pocket::Milling;
using cnc::pocket::Use;
using Box = cnc::contour::FlatBox<double>;

/// Candidate radii of the arc that leads to a part, as shares of the tool's radius, the best first.
constexpr std::array kLeadShares{1.0, 0.5, 0.25, 0.125};
constexpr double kFreeSlackMm = 1.0e-9;

/// A part of a pass with its pass and its group.
struct Piece {
  LoopPiece part;
  std::size_t pass = 0;
  std::size_t group = 0;
};

Box box_of(const Piece& piece) {
  Box box{piece.part.strokes[0].from.x(),
          piece.part.strokes[0].from.y(),
          piece.part.strokes[0].from.x(),
          piece.part.strokes[0].from.y()};
  for (const cut::Stroke& stroke : piece.part.strokes) {
    for (const double share : {0.5, 1.0}) {
      const WideVec2 place = cut::place_at(stroke, share);
      box.include({place.x(), place.y(), place.x(), place.y()});
    }
  }
  return box;
}

/// Puts pieces near each other into one group. Two pieces are near if their boxes, widened by a
/// radius, overlap. The number of a group is the index of one of its pieces.
void group(std::vector<Piece>& pieces, double radius_mm) {
  std::vector<Box> boxes;
  for (const Piece& piece : pieces) {
    const Box box = box_of(piece);
    boxes.push_back(
        {box.x0 - radius_mm, box.y0 - radius_mm, box.x1 + radius_mm, box.y1 + radius_mm});
  }
  std::vector<std::size_t> leader(pieces.size());
  std::iota(leader.begin(), leader.end(), std::size_t{0});
  const auto leader_of = [&leader](std::size_t piece) {
    while (leader[piece] != piece) piece = leader[piece] = leader[leader[piece]];
    return piece;
  };
  std::vector<std::size_t> by_x(leader);
  std::ranges::sort(by_x, {}, [&boxes](std::size_t piece) { return boxes[piece].x0; });
  for (std::size_t i = 0; i < by_x.size(); ++i) {
    const Box& box = boxes[by_x[i]];
    for (std::size_t k = i + 1; k < by_x.size() && boxes[by_x[k]].x0 <= box.x1; ++k) {
      if (box.meets(boxes[by_x[k]])) leader[leader_of(by_x[k])] = leader_of(by_x[i]);
    }
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) pieces[i].group = leader_of(i);
}

/// Writes parts of passes as rows.
class PieceDriver {
 public:
  PieceDriver(const StockAreas& areas, const PartOptions& options)
      : areas_{areas}, options_{options} {}

  /// @param pass the pass whose loop contains the piece
  void drive(const Piece& piece, const Contour& pass, PathRows& out) const {
    if (piece.part.is_whole) {
      return ramp_along_wall(pass.view(), piece.part.loop, options_.drive, out);
    }
    const bool is_climb = options_.drive.milling == Milling::kClimb;
    const auto strokes = is_climb ? piece.part.strokes : reversed(piece.part.strokes);
    DepthWriter writer{out, options_.drive.depth_mm};
    const WideVec2& start = strokes.front().from;
    const double bulge = side() * kQuarterTurnBulge;
    const auto lead_in = lead_at(start, cut::tangent_at(strokes.front(), 0.0), -1.0);
    if (lead_in) {
      writer.begin_row_in_cleared(*lead_in);
      writer.pass(start, bulge);
    } else {
      sink(strokes, writer);
    }
    for (const cut::Stroke& stroke : strokes) writer.pass(stroke.to, stroke.bulge);
    const auto lead_out = lead_at(strokes.back().to, cut::tangent_at(strokes.back(), 1.0), 1.0);
    if (lead_out) writer.pass(*lead_out, bulge);
    writer.end_row();
  }

 private:
  /// Returns the side of the path on which the pocket is: 1 for left, −1 for right.
  [[nodiscard]] double side() const {
    return options_.drive.milling == Milling::kClimb ? 1.0 : -1.0;
  }

  /// Returns the far end of a quarter turn that touches the path at the point `touch`. The quarter
  /// turn is before this point if `forwards` is −1, and after it if `forwards` is 1. Returns none
  /// if at every radius the tool would touch stock at the far end, or would gouge on the quarter
  /// turn.
  [[nodiscard]] std::optional<WideVec2> lead_at(const WideVec2& touch,
                                                const WideVec2& tangent,
                                                double forwards) const {
    for (const double share : kLeadShares) {
      const double radius = share * options_.tool_radius_mm;
      const WideVec2 centre = touch + side() * radius * cnc::left_normal(tangent);
      const WideVec2 end = centre + forwards * radius * tangent;
      const bool is_free = areas_.cleared->depth(end) >= options_.tool_radius_mm + kFreeSlackMm;
      if (is_free && areas_.locus->depth(centre) >= radius - kFreeSlackMm) return end;
    }
    return std::nullopt;
  }

  /// Descends forth and back along a part, or plunges at its start.
  void sink(const std::vector<cut::Stroke>& strokes, DepthWriter& writer) const {
    const WideVec2& start = strokes.front().from;
    writer.begin_row(start);
    const double floor = writer.floor_z();
    if (options_.drive.plunges) return writer.go(Use::kEntry, start, 0.0, floor);
    const double length = cut::length_of(strokes);
    const double pairs = legs_of_ramp(options_.drive, 2.0 * length, start);
    const auto back = reversed(strokes);
    double way = 0.0;
    const auto go_along = [&](const std::vector<cut::Stroke>& leg) {
      for (const cut::Stroke& stroke : leg) {
        way += cut::length_of(stroke);
        writer.go(Use::kEntry, stroke.to, stroke.bulge, floor * way / (2.0 * pairs * length));
      }
    };
    for (double pair = 0.0; pair < pairs; pair += 1.0) {
      go_along(strokes);
      go_along(back);
    }
    writer.settle();
  }

  StockAreas areas_;
  PartOptions options_;
};

}  // namespace

StockParts parts_in_stock(const std::vector<Contour>& passes,
                          const StockAreas& areas,
                          const PartOptions& options) {
  std::vector<Piece> pieces;
  for (std::size_t pass = passes.size(); pass-- > 0;) {
    const double overlap_mm = kPartOverlap * options.tool_radius_mm;
    for (LoopPiece& part : pieces_outside(passes[pass].view(), areas.idle, overlap_mm)) {
      pieces.push_back({std::move(part), pass, 0});
    }
  }
  group(pieces, options.tool_radius_mm);
  std::ranges::stable_sort(pieces, {}, &Piece::group);
  const PieceDriver driver{areas, options};
  std::vector<PathRows> groups;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (i == 0 || pieces[i].group != pieces[i - 1].group) groups.emplace_back();
    driver.drive(pieces[i], passes[pieces[i].pass], groups.back());
  }
  StockParts path;
  path.parts = static_cast<std::uint32_t>(pieces.size());
  if (groups.empty()) return path;
  for (const std::size_t index : short_order(groups)) path.append(groups[index]);
  return path;
}

}  // namespace sim::pocket
