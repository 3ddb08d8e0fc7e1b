#include "planner/pocket/pocket_path.hpp"

#include <cmath>
#include <optional>

#include "planner/pocket/links.hpp"
#include "planner/pocket/loop_driver.hpp"

namespace cnc::pocket {
namespace {

using contour::kNone;

constexpr double kMaxLevels = 10'000.0;

/// Drives all passes of a pocket on one level after another.
template <typename Scalar>
class PathMaker {
 public:
  using Vector = BasicVec2<Scalar>;
  using Fault = std::optional<PocketFault>;

  PathMaker(const PocketOptions<Scalar>& options,
            const PocketPathSpace<Scalar>& space,
            const PassList<Scalar>& passes,
            ToolPathWriter<Scalar>& out)
      : options_{options},
        space_{space},
        passes_{passes},
        out_{out},
        links_{space.clearing.offset.elements, space.clearing.offset.element_boxes},
        locus_{space.locus, space.locus_boxes} {}

  /// Appends the rows of one level.
  [[nodiscard]] Fault run_level(Scalar z_above, Scalar z);

  [[nodiscard]] std::uint32_t rows() const { return rows_; }
  [[nodiscard]] std::uint32_t links() const { return link_count_; }

 private:
  /// A loop of a pass.
  struct Target {
    std::uint32_t pass = kNone;
    std::size_t loop = 0;
  };

  void reset();
  [[nodiscard]] std::uint32_t nearest_ready_pass() const;
  [[nodiscard]] Fault begin_row(const Target& target);
  [[nodiscard]] Fault end_row();
  [[nodiscard]] Fault drive_pass(std::uint32_t pass);
  [[nodiscard]] Fault drive(const Target& target);
  [[nodiscard]] Fault go_to_loop_of(std::uint32_t pass, Target& target);
  [[nodiscard]] Fault follow(const Link<Scalar>& link);
  [[nodiscard]] std::size_t nearest_loop(std::uint32_t pass) const;
  [[nodiscard]] std::uint32_t root_of(std::uint32_t pass) const;
  [[nodiscard]] bool add_place() {
    const Vector& place = at_.pose.point;
    return out_.add({place.x(), place.y(), z_, Scalar{0}, Use::kPass});
  }

  PocketOptions<Scalar> options_;
  PocketPathSpace<Scalar> space_;
  const PassList<Scalar>& passes_;
  ToolPathWriter<Scalar>& out_;
  LinkSearch<Scalar> links_;
  NearestCurve<Scalar> locus_;
  std::uint32_t locus_root_ = kNone;  ///< Index of the pass whose loops `locus_` contains.
  Scalar z_above_{};
  Scalar z_{};
  LoopPlace<Scalar> at_;  ///< Position of the tool.
  bool in_row_ = false;
  std::uint32_t rows_ = 0;
  std::uint32_t link_count_ = 0;
};

template <typename Scalar>
void PathMaker<Scalar>::reset() {
  for (std::size_t i = 0; i < passes_.size(); ++i) space_.passes[i] = {};
  for (std::size_t i = 0; i < passes_.size(); ++i) {
    const std::uint32_t parent = passes_.note(i).parent;
    if (parent != kNone) ++space_.passes[parent].waits_for;
  }
}

template <typename Scalar>
std::optional<PocketFault> PathMaker<Scalar>::run_level(Scalar z_above, Scalar z) {
  z_above_ = z_above;
  z_ = z;
  reset();
  // Index of the pass around the pass that was driven last, if all passes within it are driven;
  // otherwise kNone.
  std::uint32_t next = kNone;
  for (std::size_t driven = 0; driven < passes_.size(); ++driven) {
    if (next == kNone) {
      if (Fault fault = end_row()) return fault;
      next = nearest_ready_pass();
    }
    if (Fault fault = drive_pass(next)) return fault;
    space_.passes[next].is_driven = true;
    const std::uint32_t parent = passes_.note(next).parent;
    const bool is_ready = parent != kNone && --space_.passes[parent].waits_for == 0;
    next = is_ready ? parent : kNone;
  }
  return end_row();
}

/// Returns the pass whose first vertex is nearest to the tool, among the passes that are not driven
/// yet and wait for no other pass.
template <typename Scalar>
std::uint32_t PathMaker<Scalar>::nearest_ready_pass() const {
  std::uint32_t best = kNone;
  Scalar least{};
  for (std::uint32_t i = 0; i < passes_.size(); ++i) {
    if (space_.passes[i].is_driven || space_.passes[i].waits_for > 0) continue;
    const Scalar away = (passes_.loops(i).vertices[0].point() - at_.pose.point).squaredNorm();
    if (best != kNone && away >= least) continue;
    best = i;
    least = away;
  }
  CNC_ASSERT(best != kNone);
  return best;
}

template <typename Scalar>
std::uint32_t PathMaker<Scalar>::root_of(std::uint32_t pass) const {
  while (passes_.note(pass).parent != kNone) pass = passes_.note(pass).parent;
  return pass;
}

/// Descends to the level by an entry to the loop `target`.
template <typename Scalar>
std::optional<PocketFault> PathMaker<Scalar>::begin_row(const Target& target) {
  const std::uint32_t root = root_of(target.pass);
  if (locus_root_ != root && !locus_.read(passes_.loops(root))) return PocketFault::kSpaceTooSmall;
  locus_root_ = root;
  const auto area = passes_.loops(target.pass);
  const EntryPlan<Scalar> plan = plan_entry<Scalar>(
      passes_.loops(root), locus_, area, target.loop, options_.milling, options_.entry);
  in_row_ = true;
  at_ = plan.place;
  switch (write_entry<Scalar>(plan, area, options_.milling, options_.entry, {z_above_, z_}, out_)) {
    case EntryResult::kDone:
      return {};
    case EntryResult::kTooShort:
      return PocketFault::kNoEntry;
    case EntryResult::kFull:
      break;
  }
  return PocketFault::kPathTooLong;
}

template <typename Scalar>
std::optional<PocketFault> PathMaker<Scalar>::end_row() {
  if (!in_row_) return {};
  in_row_ = false;
  ++rows_;
  if (!add_place() || !out_.end_row()) return PocketFault::kPathTooLong;
  return {};
}

/// Drives around all loops of a pass. The tool moves to each loop over a link if there is one.
template <typename Scalar>
std::optional<PocketFault> PathMaker<Scalar>::drive_pass(std::uint32_t pass) {
  const std::size_t loops = passes_.loops(pass).loop_ends.size();
  if (loops > space_.driven_loops.size()) return PocketFault::kSpaceTooSmall;
  if (!links_.enter(passes_.loops(pass))) return PocketFault::kSpaceTooSmall;
  for (std::size_t i = 0; i < loops; ++i) space_.driven_loops[i] = false;
  for (std::size_t i = 0; i < loops; ++i) {
    Target target;
    if (Fault fault = go_to_loop_of(pass, target)) return fault;
    if (Fault fault = drive(target)) return fault;
    space_.driven_loops[target.loop] = true;
  }
  return {};
}

/// Moves to a loop that is not driven yet, over a link or in a new row.
template <typename Scalar>
std::optional<PocketFault> PathMaker<Scalar>::go_to_loop_of(std::uint32_t pass, Target& target) {
  if (in_row_) {
    const std::size_t loops = passes_.loops(pass).loop_ends.size();
    const auto link = links_.find(at_.pose,
                                  {space_.driven_loops.begin(), loops},
                                  options_.milling,
                                  options_.clearing.tool_radius);
    if (link) {
      target = {pass, link->landing.loop};
      return follow(*link);
    }
    if (Fault fault = end_row()) return fault;
  }
  target = {pass, nearest_loop(pass)};
  return begin_row(target);
}

template <typename Scalar>
std::optional<PocketFault> PathMaker<Scalar>::follow(const Link<Scalar>& link) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector& from = link.points[i];
    // Length in mm below which an element counts as a rounding error.
    constexpr Scalar kShortest{1.0e-9};
    if ((link.points[i + 1] - from).norm() < kShortest) continue;
    if (!out_.add({from.x(), from.y(), z_, link.bulges[i], Use::kPass})) {
      return PocketFault::kPathTooLong;
    }
  }
  at_ = link.landing;
  ++link_count_;
  return {};
}

/// Returns the loop whose first vertex is nearest to the tool, among the loops that are not driven
/// yet.
template <typename Scalar>
std::size_t PathMaker<Scalar>::nearest_loop(std::uint32_t pass) const {
  const auto area = passes_.loops(pass);
  std::size_t best = area.loop_ends.size();
  Scalar least{};
  for (std::size_t loop = 0; loop < area.loop_ends.size(); ++loop) {
    if (space_.driven_loops[loop]) continue;
    const Vector first = area.vertices[area.loop_begin(loop)].point();
    const Scalar away = (first - at_.pose.point).squaredNorm();
    if (best < area.loop_ends.size() && away >= least) continue;
    best = loop;
    least = away;
  }
  return best;
}

template <typename Scalar>
std::optional<PocketFault> PathMaker<Scalar>::drive(const Target& target) {
  const bool added = drive_loop<Scalar>(
      passes_.loops(target.pass), at_, options_.milling, {z_, z_, Use::kPass}, out_);
  return added ? Fault{} : Fault{PocketFault::kPathTooLong};
}

template <typename Scalar>
bool are_in_range(const PocketOptions<Scalar>& options) {
  const EntryOptions<Scalar>& entry = options.entry;
  const bool is_plunge = entry.kind == EntryKind::kPlunge;
  const bool has_slope = entry.slope > Scalar{0} && entry.slope <= Scalar{1};
  const bool has_helix = entry.helix_radius > Scalar{0} && std::isfinite(entry.helix_radius);
  return options.depth > Scalar{0} && std::isfinite(options.depth) &&
         options.depth_step > Scalar{0} &&
         options.depth <= Scalar{kMaxLevels} * options.depth_step && (is_plunge || has_slope) &&
         (entry.kind != EntryKind::kHelix || has_helix);
}

}  // namespace

template <typename Scalar>
Scalar level_count(Scalar depth, Scalar greatest_step) {
  constexpr Scalar kHair{1.0e-9};
  return std::max(Scalar{1}, std::ceil(depth / greatest_step * (Scalar{1} - kHair)));
}

template <typename Scalar>
Result<PocketReport, PocketError> write_pocket_path(const contour::ContourView<Scalar>& pocket,
                                                    const PocketOptions<Scalar>& options,
                                                    const PocketPathSpace<Scalar>& space,
                                                    PassList<Scalar>& passes,
                                                    ToolPathWriter<Scalar>& out) {
  if (!are_in_range(options)) return PocketError{PocketFault::kOptionOutOfRange};
  const auto count = clear_pocket(pocket, options.clearing, space.clearing, passes);
  if (!count.ok()) return PocketError{PocketFault::kClearing, count.error()};
  if (count.value() == 0) return PocketError{PocketFault::kToolTooLarge};
  if (count.value() > space.passes.size()) return PocketError{PocketFault::kSpaceTooSmall};
  PathMaker<Scalar> maker{options, space, passes, out};
  const Scalar levels = level_count(options.depth, options.depth_step);
  const Scalar step = -options.depth / levels;
  const auto level_count = static_cast<std::uint32_t>(levels);
  for (std::uint32_t level = 0; level < level_count; ++level) {
    const Scalar above = static_cast<Scalar>(level) * step;
    const Scalar z =
        level + 1 == level_count ? -options.depth : static_cast<Scalar>(level + 1) * step;
    if (const auto fault = maker.run_level(above, z)) return PocketError{*fault};
  }
  return PocketReport{count.value(), level_count, maker.rows(), maker.links()};
}

template double level_count(double, double);
template Result<PocketReport, PocketError> write_pocket_path(const contour::ContourView<double>&,
                                                             const PocketOptions<double>&,
                                                             const PocketPathSpace<double>&,
                                                             PassList<double>&,
                                                             ToolPathWriter<double>&);

}  // namespace cnc::pocket
