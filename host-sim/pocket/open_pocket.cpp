#include "host-sim/pocket/open_pocket.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "host-sim/contour/contour_loops.hpp"
#include "host-sim/pocket/driven_loop.hpp"
#include "host-sim/pocket/loop_pieces.hpp"
#include "host-sim/pocket/pocket_plan.hpp"
#include "host-sim/pocket/scan_line.hpp"
#include "planner/base/contract.hpp"

namespace sim::pocket {
namespace {

using cnc::WideVec2;

/// Distance below which two ends of rows are one point, mm.
constexpr double kOnePlaceMm = 1.0e-5;

/// Returns the edge of a box as a counter-clockwise contour.
Contour edge_of(const StockBox& box) {
  Contour contour;
  contour.vertices = {
      {box.x0, box.y0, 0.0}, {box.x1, box.y0, 0.0}, {box.x1, box.y1, 0.0}, {box.x0, box.y1, 0.0}};
  contour.end_loop();
  return contour;
}

void append_loop(const std::vector<cut::Stroke>& strokes, Contour& to) {
  for (const cut::Stroke& stroke : strokes) {
    to.vertices.push_back({stroke.from.x(), stroke.from.y(), stroke.bulge});
  }
  to.end_loop();
}

/// Appends the loops of a contour in reverse direction. The area on their left is then on their
/// right.
void append_reversed(const Contour& contour, Contour& to) {
  for (std::size_t loop = 0; loop < contour.loop_ends.size(); ++loop) {
    const DrivenLoop back{contour.view(), loop, cnc::pocket::Milling::kConventional};
    append_loop(back.row().strokes(), to);
  }
}

/// Returns the area of a box without the area that a contour encloses.
Contour box_without(const StockBox& box, const Contour& hole) {
  Contour area = edge_of(box);
  append_reversed(hole, area);
  return area;
}

/// Returns a box with a wide margin around the stock.
StockBox far_around(const StockBox& stock, double tool_radius_mm) {
  return widened(stock, 2.0 * margin_around(stock, tool_radius_mm));
}

/// Returns the area in which the tool's centre is while the tool touches no stock.
Contour idle_area(const StockBox& stock, double tool_radius_mm) {
  ContourOffset offsetter;
  // The distance is smaller than the tool's radius. This prevents passes around the entire stock,
  // which would remove only the skin.
  const double reach_mm = tool_radius_mm - 2.0 * kStockSkinMm;
  const Contour near_stock = copy_of(offsetter.offset(edge_of(stock).view(), reach_mm));
  return box_without(far_around(stock, tool_radius_mm), near_stock);
}

/// Returns the pieces of a loop on which the tool touches stock.
std::vector<LoopPiece> pieces_of(const cnc::contour::ContourView<double>& loops,
                                 std::size_t loop,
                                 const OwnedArea& idle,
                                 double tool_radius_mm) {
  Contour one;
  sim::append_loop(loops, loop, one);
  return pieces_outside(one.view(), idle, kPartOverlap * tool_radius_mm);
}

/// Joins rows to loops: each row continues with the row that begins at its end. Appends the loops.
void append_joined(std::vector<std::vector<cut::Stroke>> rows, Contour& to) {
  while (!rows.empty()) {
    std::vector<cut::Stroke> loop = std::move(rows.back());
    rows.pop_back();
    while (drawing::distance(loop.back().to, loop.front().from) > kOnePlaceMm) {
      const WideVec2 end = loop.back().to;
      const auto next = std::ranges::find_if(rows, [&end](const auto& row) {
        return drawing::distance(row.front().from, end) <= kOnePlaceMm;
      });
      if (next == rows.end()) {
        throw NoPocketPath{
            fmt::format("at {:.3f} {:.3f} a pocket and the edge of the stock run along each other "
                        "without crossing; draw the pocket a little farther beyond the edge",
                        end.x(),
                        end.y())};
      }
      std::ranges::copy(*next, std::back_inserter(loop));
      rows.erase(next);
    }
    append_loop(loop, to);
  }
}

}  // namespace

/// Builds the boundary of the material that must stay: the edge of the stock outside of the
/// pockets, and the walls of the pockets inside of the stock.
Contour with_surroundings(const Contour& pockets, const StockBox& stock, double margin_mm) {
  const StockBox around = widened(stock, margin_mm);
  const Contour edge = edge_of(widened(stock, -kStockSkinMm));
  Contour area = edge_of(around);
  std::vector<std::vector<cut::Stroke>> rows;
  const auto take = [&](const LoopPiece& piece, std::vector<cut::Stroke> strokes) {
    if (piece.is_whole) {
      append_loop(strokes, area);
    } else {
      rows.push_back(std::move(strokes));
    }
  };
  const OwnedArea in_pockets{pockets.view()};
  CNC_ASSERT(in_pockets->element_count() > 0);
  for (const LoopPiece& piece : pieces_outside(edge.view(), in_pockets, 0.0)) {
    take(piece, reversed(piece.strokes));
  }
  StockBox all = around;
  all.include(box_of(in_pockets));
  const OwnedArea beside{box_without(widened(all, margin_mm), edge).view()};
  for (const LoopPiece& piece : pieces_outside(pockets.view(), beside, 0.0)) {
    take(piece, piece.strokes);
  }
  append_joined(std::move(rows), area);
  return area;
}

bool is_around(const cnc::contour::ContourView<double>& area, const StockBox& stock) {
  return std::ranges::any_of(area.vertices.begin(), area.vertices.end(), [&](const auto& vertex) {
    return vertex.x < stock.x0 || vertex.y < stock.y0;
  });
}

double margin_around(const StockBox& stock, double tool_radius_mm) {
  return 4.0 * tool_radius_mm + 0.5 * std::min(stock.x1 - stock.x0, stock.y1 - stock.y0);
}

bool meets_stock(const cnc::contour::ContourView<double>& loops,
                 std::size_t loop,
                 const StockBox& stock,
                 double tool_radius_mm) {
  const OwnedArea idle{idle_area(stock, tool_radius_mm).view()};
  return !pieces_of(loops, loop, idle, tool_radius_mm).empty();
}

LoopsInStock loops_in_stock(const Contour& pass, const StockBox& stock, double tool_radius_mm) {
  const OwnedArea idle{idle_area(stock, tool_radius_mm).view()};
  LoopsInStock loops;
  for (std::size_t loop = 0; loop < pass.loop_ends.size(); ++loop) {
    const auto pieces = pieces_of(pass.view(), loop, idle, tool_radius_mm);
    if (pieces.empty()) continue;
    sim::append_loop(pass.view(), loop, pieces[0].is_whole ? loops.whole : loops.partly);
  }
  return loops;
}

StockParts open_path(const cnc::contour::ContourView<double>& area,
                     const StockBox& stock,
                     const std::vector<Contour>& passes,
                     const PartOptions& options) {
  ContourOffset offsetter;
  const Contour locus = copy_of(offsetter.offset(area, -options.tool_radius_mm));
  return open_path_within(locus.view(), stock, passes, options);
}

StockParts open_path_within(const cnc::contour::ContourView<double>& locus,
                            const StockBox& stock,
                            const std::vector<Contour>& passes,
                            const PartOptions& options) {
  const double radius_mm = options.tool_radius_mm;
  const OwnedArea allowed{locus};
  const OwnedArea cleared{box_without(far_around(stock, radius_mm), edge_of(stock)).view()};
  const OwnedArea idle{idle_area(stock, radius_mm).view()};
  return parts_in_stock(passes, {allowed, cleared, idle}, options);
}

}  // namespace sim::pocket
