#include "host-sim/pocket/areas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "host-sim/contour/owned_offset_space.hpp"
#include "host-sim/order/order_solver.hpp"
#include "host-sim/pocket/pocket_plan.hpp"
#include "planner/pocket/area_split.hpp"

namespace sim::pocket {
namespace {

/// Number of steps of the search for the order, for each path, and greatest total number of steps.
constexpr std::uint64_t kStepsOfPath = 200;
constexpr std::uint64_t kMaxSteps = 200'000;

}  // namespace

std::vector<Contour> areas_of(const Contour& contours) {
  const std::size_t loops = contours.loop_ends.size();
  std::vector<cnc::pocket::LoopNote<double>> notes(loops);
  std::vector<ContourVertex> vertices(contours.vertices.size());
  std::vector<std::uint32_t> loop_ends(loops);
  std::vector<cnc::pocket::AreaRange> ranges(loops);
  cnc::pocket::AreaList<double> areas{slice_of(vertices), slice_of(loop_ends), slice_of(ranges)};
  const auto result = cnc::pocket::split_areas<double>(contours.view(), slice_of(notes), areas);
  if (result != cnc::pocket::SplitResult::kDone) {
    throw NoPocketPath{
        "an island is outside of all pockets; check for missing or crossing contours"};
  }
  std::vector<Contour> split;
  for (std::size_t i = 0; i < areas.size(); ++i) split.push_back(copy_of(areas[i]));
  return split;
}

std::vector<std::size_t> short_order(const std::vector<PathRows>& paths) {
  order::OrderProblem problem;
  problem.is_symmetric = false;
  problem.first_candidate = {0};
  for (std::size_t i = 0; i <= paths.size(); ++i) {
    problem.first_candidate.push_back(static_cast<cnc::order::Index>(i + 1));
  }
  problem.entry = problem.exit = {{0.0, 0.0}};
  for (const PathRows& path : paths) {
    problem.entry.push_back({path.points.front().x, path.points.front().y});
    problem.exit.push_back({path.points.back().x, path.points.back().y});
  }
  order::OrderOptions options;
  options.steps = std::min(kStepsOfPath * paths.size(), kMaxSteps);
  options.may_prove = false;
  const order::OrderResult result = order::solve_order(problem, options, {});
  std::vector<std::size_t> order;
  for (const cnc::order::Index set : result.order) {
    if (set != 0) order.push_back(set - 1);
  }
  return order;
}

}  // namespace sim::pocket
