#include "host-sim/pocket/spiral_path.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "host-sim/contour/contour_loops.hpp"
#include "host-sim/pocket/depth_writer.hpp"
#include "host-sim/pocket/driven_loop.hpp"
#include "host-sim/pocket/entry_beside.hpp"
#include "host-sim/pocket/loop_chain.hpp"
#include "host-sim/pocket/open_pocket.hpp"
#include "host-sim/pocket/owned_boundary.hpp"
#include "host-sim/pocket/spiral_search.hpp"
#include "planner/pocket/links.hpp"

namespace sim::pocket {
namespace {

using cnc::WideVec2;
using cnc::contour::kNone;
using cnc::pocket::LoopPlace;
using cnc::pocket::Use;

/// A point on one loop of a pass, with the pass.
struct LoopStart {
  std::uint32_t pass = 0;
  LoopPlace<double> place;
};

class SpiralDriver {
 public:
  /// @param beside search for beginnings of rows next to a stock; null if there is no stock
  SpiralDriver(const PocketPlan& plan,
               const SpiralOptions& options,
               const EntryBesideSearch* beside,
               SpiralPath& out)
      : plan_{plan},
        options_{options},
        beside_{beside},
        tree_{plan.passes, plan.parents},
        search_{plan, tree_, options_},
        out_{out},
        writer_{out, options.depth_mm} {
    for (const Contour& pass : plan.passes) is_driven_.emplace_back(pass.loop_ends.size());
  }

  /// Marks a loop as omitted.
  void leave_out(const PassLoop& loop) { is_driven_[loop.pass][loop.loop] = true; }

  /// Selects spirals around islands, and marks the passes that they replace as driven.
  void take_island_spirals() {
    island_spirals_ = search_.around_islands();
    for (const IslandSpiral& spiral : island_spirals_) {
      for (const std::uint32_t pass : spiral.replaced) {
        is_driven_[pass].assign(is_driven_[pass].size(), true);
      }
    }
  }

  void drive_all() {
    for (const std::uint32_t pass : tree_.inner_first()) {
      const auto island = std::ranges::find(island_spirals_, pass, &IslandSpiral::pass);
      if (island != island_spirals_.end()) {
        drive_around_island(island->loops);
        continue;
      }
      drive_loops(pass);
      drive_spirals(pass);
    }
    writer_.end_row();
  }

 private:
  [[nodiscard]] DrivenLoop driven(const PassLoop& loop) const {
    return search_.driven(loop, options_.milling);
  }

  /// Drives all loops of a pass that no spiral has driven. Each loop begins with a link or an
  /// entry.
  void drive_loops(std::uint32_t pass) {
    std::vector<bool>& is_driven = is_driven_[pass];
    for (auto left = std::ranges::count(is_driven, false); left > 0; --left) {
      const LoopPlace<double> start = go_to_loop_of(pass);
      drive_loop(pass, start, options_.milling);
      is_driven[start.loop] = true;
    }
  }

  /// Drives once around the loop on which the tool is.
  void drive_loop(std::uint32_t pass,
                  const LoopPlace<double>& start,
                  cnc::pocket::Milling milling) {
    const DrivenLoop loop = search_.driven({pass, start.loop}, milling);
    const double way = loop.way_at(start.pose.point);
    pass_along(loop.stretch(way, way), Use::kPass);
    at_ = start;
    at_pass_ = pass;
    ++out_.loops;
  }

  LoopPlace<double> go_to_loop_of(std::uint32_t pass) {
    const bool is_near = at_pass_ != kNone && (at_pass_ == pass || tree_.parent(at_pass_) == pass);
    if (is_near) {
      if (const auto link = link_to(pass, at_.pose)) return follow(*link);
    }
    writer_.end_row();
    if (const auto landing = link_from_island(pass)) return *landing;
    if (const auto start = enter_from_beside(pass)) return *start;
    const auto left = std::ranges::find(is_driven_[pass], false);
    const auto loop = static_cast<std::size_t>(left - is_driven_[pass].begin());
    return enter({pass, loop}, options_.milling);
  }

  LoopPlace<double> follow(const cnc::pocket::Link<double>& link) {
    for (std::size_t i = 0; i < 3; ++i) {
      if ((link.points[i + 1] - link.points[i]).norm() < kShortestWayMm) continue;
      writer_.go(Use::kPass, link.points[i + 1], link.bulges[i], writer_.floor_z());
    }
    ++out_.links;
    return link.landing;
  }

  /// Begins a row on the first loop of a spiral around an island, and follows a link from there to
  /// the wall of the same island. Returns none where no link fits.
  std::optional<LoopPlace<double>> link_from_island(std::uint32_t pass) {
    for (const LoopStart& start : beside_islands_) {
      if (tree_.parent(start.pass) != pass) continue;
      const auto link = link_to(pass, start.place.pose);
      if (!link) continue;
      writer_.begin_row_in_cleared(start.place.pose.point);
      return follow(*link);
    }
    return std::nullopt;
  }

  [[nodiscard]] std::optional<cnc::pocket::Link<double>> link_to(
      std::uint32_t pass, const cnc::pocket::Pose<double>& from) const {
    const Contour& area = plan_.passes[pass];
    std::vector<cnc::contour::Curve<double>> curves(area.vertices.size());
    std::vector<cnc::contour::FlatBox<double>> boxes(
        cnc::contour::BoxTree<double>::size_for(area.vertices.size()));
    cnc::pocket::LinkSearch<double> search{slice_of(curves), slice_of(boxes)};
    const bool has_space = search.enter(area.view());
    CNC_ASSERT(has_space);
    const std::size_t loops = area.loop_ends.size();
    // An array, because std::vector<bool> does not store its items as bool.
    const auto left_out = std::make_unique<bool[]>(loops);  // NOLINT(modernize-avoid-c-arrays)
    for (std::size_t i = 0; i < loops; ++i) left_out[i] = is_driven_[pass][i];
    return search.find(from, {left_out.get(), loops}, options_.milling, options_.tool_radius_mm);
  }

  /// Begins a row next to the stock, on the shortest path to one of the undriven loops of a pass.
  /// Returns none if there is no such path.
  std::optional<LoopPlace<double>> enter_from_beside(std::uint32_t pass) {
    std::optional<EntryBeside> best;
    std::size_t best_loop = 0;
    for (std::size_t loop = 0; beside_ != nullptr && loop < is_driven_[pass].size(); ++loop) {
      if (is_driven_[pass][loop]) continue;
      const auto entry = beside_->find(driven({pass, loop}));
      if (!entry || (best && entry->length_mm >= best->length_mm)) continue;
      best = entry;
      best_loop = loop;
    }
    if (!best) return std::nullopt;
    const DrivenLoop loop = driven({pass, best_loop});
    const WideVec2 place = loop.row().place(best->way_mm);
    writer_.begin_row_in_cleared(best->from);
    if (best->approach.exists) {
      writer_.pass(best->approach.arc_start);
      writer_.pass(place, best->approach.bulge());
    }
    return LoopPlace<double>{best_loop, 0, {place, loop.row().leaving(best->way_mm)}};
  }

  /// Begins a row with an entry to a loop.
  LoopPlace<double> enter(const PassLoop& loop, cnc::pocket::Milling milling) {
    std::uint32_t root = loop.pass;
    while (tree_.parent(root) != kNone) root = tree_.parent(root);
    if (root != wall_pass_) {
      walls_ = std::make_unique<OwnedBoundary>(plan_.passes[root]);
      wall_pass_ = root;
    }
    const auto area = plan_.passes[loop.pass].view();
    const auto plan = cnc::pocket::plan_entry<double>(
        walls_->view(), walls_->nearest(), area, loop.loop, milling, options_.entry);
    const std::size_t first = out_.points.size();
    for (std::size_t size = 1024;; size *= 2) {
      out_.points.resize(first + size);
      cnc::pocket::ToolPathWriter<double> writer{{out_.points.data() + first, size}, {}};
      const auto result = cnc::pocket::write_entry<double>(
          plan, area, milling, options_.entry, {0.0, -options_.depth_mm}, writer);
      if (result == cnc::pocket::EntryResult::kFull) continue;
      if (result == cnc::pocket::EntryResult::kTooShort) {
        throw NoPocketPath{
            "a pass is too short for a ramp, and no helix fits; choose --entry plunge or a smaller "
            "tool"};
      }
      out_.points.resize(first + writer.point_count());
      break;
    }
    const WideVec2& place = plan.place.pose.point;
    out_.points.push_back({place.x(), place.y(), writer_.floor_z(), 0.0, Use::kPass});
    return plan.place;
  }

  /// Drives a spiral from each loop of a pass from which a spiral leads outwards. Begins with the
  /// loop on which the tool is.
  void drive_spirals(std::uint32_t pass) {
    const std::size_t loops = is_driven_[pass].size();
    const std::size_t first = at_.loop;
    for (std::size_t i = 0; i < loops; ++i) {
      const std::size_t loop = (first + i) % loops;
      const std::vector<SpiralLoop> spiral = search_.outwards({pass, loop}, is_driven_);
      if (!spiral.empty()) drive(spiral);
    }
  }

  /// Drives the first loop of a spiral around an island, then the spiral.
  void drive_around_island(const std::vector<SpiralLoop>& spiral) {
    const SpiralLoop& first = spiral.front();
    writer_.end_row();
    const LoopPlace<double> start = enter(first.loop, first.milling);
    drive_loop(first.loop.pass, start, first.milling);
    // The wall of the island is driven in the direction opposite to the spiral's first loop.
    LoopPlace<double> back = start;
    back.pose.tangent = -back.pose.tangent;
    beside_islands_.push_back({first.loop.pass, back});
    drive(spiral);
  }

  /// Drives the turns of a spiral after its first loop, then the last loop as a full loop.
  void drive(const std::vector<SpiralLoop>& spiral) {
    const PassLoop& first = spiral.front().loop;
    const DrivenLoop begin = search_.driven(first, spiral.front().milling);
    const double start_mm = spiral.front().start_mm;
    if (at_pass_ == first.pass && at_.loop == first.loop) {
      const double here_mm = begin.way_at(at_.pose.point);
      if (std::abs(here_mm - start_mm) > kShortestWayMm) {
        pass_along(begin.stretch(here_mm, start_mm), Use::kLink);
      }
    } else {
      writer_.begin_row_in_cleared(begin.row().place(start_mm));
    }
    for (std::size_t i = 1; i < spiral.size(); ++i) {
      for (const WayElement& element : spiral[i].turns) writer_.pass(element.to, element.bulge);
      is_driven_[spiral[i].loop.pass][spiral[i].loop.loop] = true;
      out_.turns += spiral[i].turn_count;
    }
    const PassLoop& last = spiral.back().loop;
    const DrivenLoop end = driven(last);
    const double end_mm = spiral.back().start_mm;
    pass_along(end.stretch(end_mm, end_mm), Use::kPass);
    ++out_.loops;
    at_ = {last.loop, 0, {end.row().place(end_mm), end.row().leaving(end_mm)}};
    at_pass_ = last.pass;
  }

  void pass_along(const std::vector<cut::Stroke>& strokes, Use use) {
    for (const cut::Stroke& stroke : strokes) {
      writer_.go(use, stroke.to, stroke.bulge, writer_.floor_z());
    }
  }

  static constexpr double kShortestWayMm = 1.0e-9;

  const PocketPlan& plan_;
  SpiralOptions options_;
  const EntryBesideSearch* beside_;
  PassTree tree_;
  SpiralSearch search_;
  SpiralPath& out_;
  DepthWriter writer_;
  DrivenMarks is_driven_;
  std::vector<IslandSpiral> island_spirals_;
  std::vector<LoopStart> beside_islands_;
  LoopPlace<double> at_;                  ///< Position of the tool.
  std::uint32_t at_pass_ = kNone;         ///< Number of the last pass that was driven.
  std::unique_ptr<OwnedBoundary> walls_;  ///< Loops of the outermost pass around the last entry.
  std::uint32_t wall_pass_ = kNone;
};

}  // namespace

double widest_spiral_mm(double tool_radius_mm, double corner_radius_mm) {
  return tool_radius_mm - corner_radius_mm;
}

SpiralPath spiral_path(const PocketPlan& plan, const SpiralOptions& options) {
  SpiralPath path;
  SpiralDriver driver{plan, options, nullptr, path};
  driver.take_island_spirals();
  driver.drive_all();
  return path;
}

SpiralPath open_spiral_path(const cnc::contour::ContourView<double>& area,
                            const StockBox& stock,
                            const PocketPlan& plan,
                            const SpiralOptions& options) {
  const OwnedArea owned{area};
  const EntryBesideSearch beside{owned, stock, options.tool_radius_mm};
  SpiralPath path;
  SpiralDriver driver{plan, options, &beside, path};
  std::vector<Contour> walls;
  for (std::uint32_t pass = 0; pass < plan.passes.size(); ++pass) {
    const Contour& loops = plan.passes[pass];
    const bool is_wall = plan.parents[pass] == kNone;
    if (is_wall) walls.push_back(loops);
    for (std::size_t loop = 0; loop < loops.loop_ends.size(); ++loop) {
      if (is_wall || !meets_stock(loops.view(), loop, stock, options.tool_radius_mm)) {
        driver.leave_out({pass, loop});
      }
    }
  }
  driver.drive_all();
  const StockParts parts =
      open_path(area,
                stock,
                walls,
                {.tool_radius_mm = options.tool_radius_mm,
                 .drive = {.depth_mm = options.depth_mm,
                           .slope = options.entry.slope,
                           .plunges = options.entry.kind == cnc::pocket::EntryKind::kPlunge,
                           .milling = options.milling}});
  path.append(parts);
  path.loops += parts.parts;
  return path;
}

}  // namespace sim::pocket
