#include "host-sim/pocket/paper_path.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "host-sim/pocket/pocket_plan.hpp"
#include "planner/pocket/paper_pocket.hpp"

namespace sim::pocket {
namespace {

using cnc::pocket::PaperFault;

[[noreturn]] void refuse(PaperFault fault) {
  switch (fault) {
    case PaperFault::kNotANumber:
      throw NoPocketPath{"a coordinate of the pocket is not finite; correct the drawing"};
    case PaperFault::kNotOneLoop:
      throw NoPocketPath{
          "the paper's method supports no islands; leave --strategy paper out or draw one contour"};
    case PaperFault::kToolTooLarge:
      throw NoPocketPath{
          "the paper's method finds no loop: the tool is too large, or a wall is too short; "
          "choose a smaller --tool, or leave --strategy paper out"};
    case PaperFault::kTooManyElements:
    case PaperFault::kTooManyPasses:
    case PaperFault::kPathTooLong:
      break;
  }
  throw NoPocketPath{"the path is too long; choose a larger tool"};
}

/// Returns an upper bound of the number of loops. Each loop is at least one tool radius inside of
/// the previous loop on both sides. Arcs may reach beyond the vertices. In a pocket that the method
/// supports, they are less than twice as far from the middle as the vertices.
std::size_t max_loops_of(const cnc::contour::ContourView<double>& pocket, double tool_radius_mm) {
  double left = std::numeric_limits<double>::infinity();
  double right = -left;
  for (const ContourVertex& vertex : pocket.vertices) {
    left = std::min(left, vertex.x);
    right = std::max(right, vertex.x);
  }
  constexpr double kMax = 10'000.0;
  return static_cast<std::size_t>(std::clamp((right - left) / tool_radius_mm, 16.0, kMax));
}

}  // namespace

PaperPath paper_path(const cnc::contour::ContourView<double>& pocket,
                     double tool_radius_mm,
                     double depth_mm) {
  const std::size_t elements = pocket.vertices.size();
  const std::size_t max_loops = max_loops_of(pocket, tool_radius_mm);
  std::vector<cnc::contour::Curve<double>> curves(elements);
  std::vector<double> distances(max_loops);
  std::vector<cnc::pocket::PathPoint<double>> points(max_loops * (elements + 1) + 1);
  std::vector<std::uint32_t> row_ends(1);
  cnc::pocket::ToolPathWriter<double> writer{slice_of(points), slice_of(row_ends)};
  const auto loops = cnc::pocket::write_paper_path<double>(
      pocket, {tool_radius_mm, -depth_mm}, {slice_of(curves), slice_of(distances)}, writer);
  if (!loops.ok()) refuse(loops.error());
  PaperPath path;
  path.loops = loops.value();
  const auto row = writer.view().points;
  path.points.push_back({row[0].x, row[0].y, 0.0, 0.0, cnc::pocket::Use::kEntry});
  path.points.insert(path.points.end(), row.begin(), row.end());
  path.end_row();
  return path;
}

}  // namespace sim::pocket
