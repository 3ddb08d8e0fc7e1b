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
#include "host-sim/pocket/spiral_turn.hpp"
#include "planner/pocket/links.hpp"

namespace sim::pocket {
namespace {

using cnc::WideVec2;
using cnc::contour::kNone;
using cnc::pocket::LoopPlace;
using cnc::pocket::Use;

/// Loops with a turn between them are at most this many radii of the tool apart, in corners, too.
constexpr double kWidest = 1.9;
/// Turns are exact within this share of the tool's radius.
constexpr double kTolerance = 2.5e-4;
/// A spiral of fewer turns takes longer than its loops.
constexpr std::size_t kFewestTurns = 2;

/// A loop of a spiral and the turn that leads to it.
struct SpiralLoop {
  PassLoop loop;
  double start_mm = 0.0;           ///< Where turns end and begin, on the loop as it is driven.
  std::vector<WayElement> turn{};  ///< From the loop before; none for the first one.
};

class SpiralDriver {
 public:
  /// @param beside where rows may begin beside a stock; null where there is none
  SpiralDriver(const PocketPlan& plan,
               const SpiralOptions& options,
               const EntryBesideSearch* beside,
               SpiralPath& out)
      : plan_{plan},
        options_{options},
        beside_{beside},
        tree_{plan.passes, plan.parents},
        out_{out},
        writer_{out, options.depth_mm} {
    for (const Contour& pass : plan.passes) is_driven_.emplace_back(pass.loop_ends.size());
  }

  /// Leaves a loop out.
  void leave_out(const PassLoop& loop) { is_driven_[loop.pass][loop.loop] = true; }

  void drive_all() {
    for (const std::uint32_t pass : tree_.inner_first()) {
      drive_loops(pass);
      drive_spirals(pass);
    }
    writer_.end_row();
  }

 private:
  [[nodiscard]] DrivenLoop driven(const PassLoop& loop) const {
    return {plan_.passes[loop.pass].view(), loop.loop, options_.milling};
  }

  /// Drives the loops of a pass that no spiral has driven, each after a link or an entry.
  void drive_loops(std::uint32_t pass) {
    std::vector<bool>& is_driven = is_driven_[pass];
    for (auto left = std::ranges::count(is_driven, false); left > 0; --left) {
      const LoopPlace<double> start = go_to_loop_of(pass);
      const DrivenLoop loop = driven({pass, start.loop});
      const double way = loop.way_at(start.pose.point);
      pass_along(loop.stretch(way, way), Use::kPass);
      is_driven[start.loop] = true;
      at_ = start;
      at_pass_ = pass;
      ++out_.loops;
    }
  }

  LoopPlace<double> go_to_loop_of(std::uint32_t pass) {
    const bool is_near = at_pass_ != kNone && (at_pass_ == pass || tree_.parent(at_pass_) == pass);
    if (is_near) {
      if (const auto link = link_to(pass)) {
        for (std::size_t i = 0; i < 3; ++i) {
          if ((link->points[i + 1] - link->points[i]).norm() < kShortestWayMm) continue;
          writer_.go(Use::kPass, link->points[i + 1], link->bulges[i], writer_.floor_z());
        }
        ++out_.links;
        return link->landing;
      }
    }
    writer_.end_row();
    if (const auto start = enter_from_beside(pass)) return *start;
    const auto left = std::ranges::find(is_driven_[pass], false);
    return enter(pass, static_cast<std::size_t>(left - is_driven_[pass].begin()));
  }

  [[nodiscard]] std::optional<cnc::pocket::Link<double>> link_to(std::uint32_t pass) const {
    const Contour& area = plan_.passes[pass];
    std::vector<cnc::contour::Curve<double>> curves(area.vertices.size());
    std::vector<cnc::contour::FlatBox<double>> boxes(
        cnc::contour::BoxTree<double>::size_for(area.vertices.size()));
    cnc::pocket::LinkSearch<double> search{slice_of(curves), slice_of(boxes)};
    const bool has_space = search.enter(area.view());
    CNC_ASSERT(has_space);
    const std::size_t loops = area.loop_ends.size();
    // A vector of bool has no storage to hand out.
    const auto left_out = std::make_unique<bool[]>(loops);  // NOLINT(modernize-avoid-c-arrays)
    for (std::size_t i = 0; i < loops; ++i) left_out[i] = is_driven_[pass][i];
    return search.find(
        at_.pose, {left_out.get(), loops}, options_.milling, options_.tool_radius_mm);
  }

  /// Begins a row beside the stock, by the shortest way to a loop of a pass that is left.
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

  /// Begins a row by an entry to a loop.
  LoopPlace<double> enter(std::uint32_t pass, std::size_t loop) {
    std::uint32_t root = pass;
    while (tree_.parent(root) != kNone) root = tree_.parent(root);
    if (root != wall_pass_) {
      walls_ = std::make_unique<OwnedBoundary>(plan_.passes[root]);
      wall_pass_ = root;
    }
    const auto area = plan_.passes[pass].view();
    const auto plan = cnc::pocket::plan_entry<double>(
        walls_->view(), walls_->nearest(), area, loop, options_.milling, options_.entry);
    const std::size_t first = out_.points.size();
    for (std::size_t size = 1024;; size *= 2) {
      out_.points.resize(first + size);
      cnc::pocket::ToolPathWriter<double> writer{{out_.points.data() + first, size}, {}};
      const auto result = cnc::pocket::write_entry<double>(
          plan, area, options_.milling, options_.entry, {0.0, -options_.depth_mm}, writer);
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

  /// Drives a spiral from each loop of a pass from which one leads outwards, that of the tool
  /// first.
  void drive_spirals(std::uint32_t pass) {
    const std::size_t loops = is_driven_[pass].size();
    const std::size_t first = at_.loop;
    for (std::size_t i = 0; i < loops; ++i) {
      const std::size_t loop = (first + i) % loops;
      const std::vector<SpiralLoop> spiral = spiral_from({pass, loop});
      if (spiral.size() > kFewestTurns) drive(spiral);
    }
  }

  /// The loops of the longest spiral from a loop outwards, itself included.
  [[nodiscard]] std::vector<SpiralLoop> spiral_from(const PassLoop& first) const {
    std::vector<PassLoop> chain{first};
    for (;;) {
      const std::optional<PassLoop> next = tree_.around(chain.back());
      if (!next || is_driven_[next->pass][next->loop]) break;
      chain.push_back(*next);
    }
    while (chain.size() > kFewestTurns) {
      std::vector<SpiralLoop> spiral = with_turns(chain);
      if (spiral.size() == chain.size()) return spiral;
      chain.resize(spiral.size());
    }
    return {};
  }

  /// Turns along a chain of loops; fewer where one of them is not possible.
  [[nodiscard]] std::vector<SpiralLoop> with_turns(const std::vector<PassLoop>& chain) const {
    std::vector<SpiralLoop> spiral;
    spiral.reserve(chain.size());
    for (const PassLoop& loop : chain) spiral.push_back({loop});
    spiral.back().start_mm = driven(chain.back()).longest_middle();
    for (std::size_t i = chain.size() - 1; i > 0; --i) {
      const WideVec2 place = driven(chain[i]).row().place(spiral[i].start_mm);
      const OwnedBoundary inner{only(chain[i - 1])};
      spiral[i - 1].start_mm = driven(chain[i - 1]).way_at(inner.nearest().nearest_to(place).point);
    }
    for (std::size_t i = 1; i < chain.size(); ++i) {
      auto turn = spiral_turn(OwnedBoundary{only(chain[i - 1])},
                              driven(chain[i]),
                              spiral[i].start_mm,
                              {.tolerance_mm = kTolerance * options_.tool_radius_mm,
                               .widest_mm = kWidest * options_.tool_radius_mm});
      if (!turn) {
        spiral.resize(i);
        return spiral;
      }
      spiral[i].turn = std::move(*turn);
    }
    return spiral;
  }

  /// A loop by itself.
  [[nodiscard]] Contour only(const PassLoop& loop) const {
    Contour contour;
    append_loop(plan_.passes[loop.pass].view(), loop.loop, contour);
    return contour;
  }

  /// Drives the turns of a spiral whose first loop is driven, and the last loop as a whole.
  void drive(const std::vector<SpiralLoop>& spiral) {
    const PassLoop& first = spiral.front().loop;
    const DrivenLoop begin = driven(first);
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
      for (const WayElement& element : spiral[i].turn) writer_.pass(element.to, element.bulge);
      is_driven_[spiral[i].loop.pass][spiral[i].loop.loop] = true;
      ++out_.turns;
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
  SpiralPath& out_;
  DepthWriter writer_;
  std::vector<std::vector<bool>> is_driven_;  ///< Whether a loop is driven, of each pass.
  LoopPlace<double> at_;                      ///< Where the tool is.
  std::uint32_t at_pass_ = kNone;             ///< The pass that was driven last.
  std::unique_ptr<OwnedBoundary> walls_;      ///< Of the pass at the wall around the last entry.
  std::uint32_t wall_pass_ = kNone;
};

}  // namespace

double widest_spiral_mm(double tool_radius_mm, double corner_radius_mm) {
  return tool_radius_mm - corner_radius_mm;
}

SpiralPath spiral_path(const PocketPlan& plan, const SpiralOptions& options) {
  SpiralPath path;
  SpiralDriver{plan, options, nullptr, path}.drive_all();
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
