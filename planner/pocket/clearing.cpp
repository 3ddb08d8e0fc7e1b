#include "planner/pocket/clearing.hpp"

#include <cmath>
#include <optional>

#include "planner/pocket/loop_measures.hpp"
#include "planner/pocket/step_search.hpp"

namespace cnc::pocket {
namespace {

using contour::ContourView;
using contour::kNone;

/// Length in mm by which a pass is assumed to clear more than the tool's radius on each side.
/// Remains thinner than this length are ignored, so that none of them requires a pass.
constexpr double kThinRest = 1.0e-7;

/// Sine of the least turn that counts as a corner. Elements that join smoothly turn by less.
constexpr double kCorner = 1.0e-4;

/// Returns whether the boundary of an area has a corner that turns right.
template <typename Scalar>
bool has_inner_corner(const ContourView<Scalar>& area) {
  bool found = false;
  for_each_corner(area, [&found](const auto& before, const auto& after) {
    found = found || cross(before.end_tangent, after.start_tangent) < -Scalar{kCorner};
  });
  return found;
}

/// Appends the passes of one pocket, the outer passes first.
template <typename Scalar>
class Clearing {
 public:
  Clearing(const ClearingOptions<Scalar>& options,
           const ClearingSpace<Scalar>& space,
           PassList<Scalar>& passes)
      : options_{options},
        space_{space},
        passes_{passes},
        cleared_{options.tool_radius + Scalar{kThinRest}},
        max_{options.stepover - cleared_ + options.corner_radius} {}

  [[nodiscard]] std::optional<ClearingError> run(const ContourView<Scalar>& pocket);

 private:
  using Error = std::optional<ClearingError>;

  [[nodiscard]] Error split_offset(const ContourView<Scalar>& area,
                                   Scalar distance,
                                   const AreaSpace<Scalar>& into,
                                   AreaList<Scalar>& list) const;
  [[nodiscard]] Error split(const ContourView<Scalar>& loops, AreaList<Scalar>& list) const;
  [[nodiscard]] Error split_locus(const ContourView<Scalar>& pocket, AreaList<Scalar>& list) const;
  [[nodiscard]] Result<ContourView<Scalar>, contour::OffsetError> pass_around(
      const ContourView<Scalar>& goal) const;
  [[nodiscard]] Error add_goals(const AreaList<Scalar>& goals, const PassNote<Scalar>& note);
  [[nodiscard]] Error step_inwards(std::uint32_t pass);
  [[nodiscard]] Error step_into(const ContourView<Scalar>& left, std::uint32_t pass);
  [[nodiscard]] Error step_by_stepover(std::uint32_t pass);
  [[nodiscard]] Error leaves_nothing(const ContourView<Scalar>& goal, bool& nothing) const;

  ClearingOptions<Scalar> options_;
  ClearingSpace<Scalar> space_;
  PassList<Scalar>& passes_;
  Scalar cleared_;  ///< Distance on each side of a pass that is assumed to be cleared, mm.
  /// Greatest distance, mm, by which the search for the next pass moves the remaining area inwards.
  /// It is negative if the step-over is so small that the next pass is outside the remaining area.
  Scalar max_;
};

template <typename Scalar>
std::optional<ClearingError> Clearing<Scalar>::run(const ContourView<Scalar>& pocket) {
  AreaList<Scalar> goals;
  if (Error e = split_locus(pocket, goals)) return e;
  const PassNote<Scalar> at_wall{options_.tool_radius, kNone};
  for (std::size_t i = 0; i < goals.size(); ++i) {
    if (!passes_.add(goals[i], at_wall)) return ClearingError{ClearingFault::kPassesTooLong};
  }
  for (std::uint32_t pass = 0; pass < passes_.size(); ++pass) {
    if (Error e = max_ > Scalar{0} ? step_inwards(pass) : step_by_stepover(pass)) return e;
  }
  return {};
}

/// Splits the offset of an area into connected areas.
template <typename Scalar>
std::optional<ClearingError> Clearing<Scalar>::split_offset(const ContourView<Scalar>& area,
                                                            Scalar distance,
                                                            const AreaSpace<Scalar>& into,
                                                            AreaList<Scalar>& list) const {
  auto writer = space_.loops.writer();
  const auto moved = contour::offset<Scalar>(area, distance, space_.offset, writer);
  if (!moved.ok()) return ClearingError{ClearingFault::kOffset, moved.error()};
  list = into.list();
  return split(moved.value(), list);
}

template <typename Scalar>
std::optional<ClearingError> Clearing<Scalar>::split(const ContourView<Scalar>& loops,
                                                     AreaList<Scalar>& list) const {
  switch (split_areas(loops, space_.notes, list)) {
    case SplitResult::kDone:
      return {};
    case SplitResult::kFull:
      return ClearingError{ClearingFault::kTooManyLoops};
    case SplitResult::kNoOwner:
      break;
  }
  return ClearingError{ClearingFault::kLoopsCross};
}

/// Finds the areas in which the tool's centre may be, and splits them into connected areas.
template <typename Scalar>
std::optional<ClearingError> Clearing<Scalar>::split_locus(const ContourView<Scalar>& pocket,
                                                           AreaList<Scalar>& list) const {
  if (!options_.is_locus) return split_offset(pocket, -options_.tool_radius, space_.goals, list);
  list = space_.goals.list();
  return split(pocket, list);
}

/// Returns the pass around a goal: the boundary of the goal grown by the corner radius. Parts of a
/// goal that are less than twice this radius apart merge, with corners between them. Arcs of this
/// radius then fill these corners, so the pass surrounds slightly more than the goal requires.
template <typename Scalar>
Result<ContourView<Scalar>, contour::OffsetError> Clearing<Scalar>::pass_around(
    const ContourView<Scalar>& goal) const {
  const Scalar radius = options_.corner_radius;
  auto writer = space_.loops.writer();
  const auto grown = contour::offset<Scalar>(goal, radius, space_.offset, writer);
  if (!grown.ok() || radius == Scalar{0} || !has_inner_corner(grown.value())) return grown;
  auto wide_writer = space_.grown.writer();
  const auto wide = contour::offset<Scalar>(goal, Scalar{2} * radius, space_.offset, wide_writer);
  if (!wide.ok()) return wide;
  return contour::offset<Scalar>(wide.value(), -radius, space_.offset, writer);
}

/// Appends a pass around each goal.
template <typename Scalar>
std::optional<ClearingError> Clearing<Scalar>::add_goals(const AreaList<Scalar>& goals,
                                                         const PassNote<Scalar>& note) {
  for (std::size_t i = 0; i < goals.size(); ++i) {
    const auto grown = pass_around(goals[i]);
    if (!grown.ok()) return ClearingError{ClearingFault::kOffset, grown.error()};
    if (!passes_.add(grown.value(), note)) return ClearingError{ClearingFault::kPassesTooLong};
  }
  return {};
}

/// Appends the passes directly inside `pass`. They surround the areas that `pass` leaves uncut,
/// each as far inside as its area allows.
template <typename Scalar>
std::optional<ClearingError> Clearing<Scalar>::step_inwards(std::uint32_t pass) {
  AreaList<Scalar> left;
  if (Error e = split_offset(passes_.loops(pass), -cleared_, space_.left, left)) return e;
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (Error e = step_into(left[i], pass)) return e;
  }
  return {};
}

template <typename Scalar>
std::optional<ClearingError> Clearing<Scalar>::step_into(const ContourView<Scalar>& left,
                                                         std::uint32_t pass) {
  const Scalar reach = options_.tool_radius + options_.corner_radius;
  const Scalar base = cleared_ - options_.corner_radius;
  StepSearch<Scalar> search{space_, reach};
  const auto inwards = search.find(left, max_, base);
  if (!inwards.ok()) return ClearingError{ClearingFault::kOffset, inwards.error()};
  AreaList<Scalar> goals = space_.goals.list();
  if (Error e = split(search.goal(), goals)) return e;
  return add_goals(goals, {passes_.note(pass).distance + base + inwards.value(), pass});
}

/// Appends the passes directly inside `pass`, all at the step-over from it. The step-over is so
/// small that these passes are outside the areas that `pass` leaves uncut. Each new pass surrounds
/// such an area.
template <typename Scalar>
std::optional<ClearingError> Clearing<Scalar>::step_by_stepover(std::uint32_t pass) {
  AreaList<Scalar> goals;
  const Scalar inwards = options_.stepover + options_.corner_radius;
  if (Error e = split_offset(passes_.loops(pass), -inwards, space_.goals, goals)) return e;
  AreaList<Scalar> kept = space_.left.list();
  for (std::size_t i = 0; i < goals.size(); ++i) {
    bool nothing = false;
    if (Error e = leaves_nothing(goals[i], nothing)) return e;
    if (nothing) continue;
    if (!kept.begin_area()) return ClearingError{ClearingFault::kTooManyLoops};
    for (std::size_t loop = 0; loop < goals[i].loop_ends.size(); ++loop) {
      if (!kept.add_loop(goals[i], loop)) return ClearingError{ClearingFault::kTooManyLoops};
    }
  }
  return add_goals(kept, {passes_.note(pass).distance + options_.stepover, pass});
}

/// Sets `nothing` to whether the pass outside a goal has already cleared the complete goal.
template <typename Scalar>
std::optional<ClearingError> Clearing<Scalar>::leaves_nothing(const ContourView<Scalar>& goal,
                                                              bool& nothing) const {
  auto writer = space_.loops.writer();
  const auto left = contour::offset<Scalar>(goal, max_, space_.offset, writer);
  if (!left.ok()) return ClearingError{ClearingFault::kOffset, left.error()};
  nothing = left.value().loop_ends.size() == 0;
  return {};
}

template <typename Scalar>
bool in_range(const ClearingOptions<Scalar>& options) {
  const Scalar radius = options.tool_radius;
  return radius > Scalar{0} && std::isfinite(radius) && options.corner_radius >= Scalar{0} &&
         options.corner_radius <= radius / Scalar{3} && options.stepover > Scalar{0} &&
         std::isfinite(options.stepover);
}

}  // namespace

template <typename Scalar>
Result<std::uint32_t, ClearingError> clear_pocket(const ContourView<Scalar>& pocket,
                                                  const ClearingOptions<Scalar>& options,
                                                  const ClearingSpace<Scalar>& space,
                                                  PassList<Scalar>& passes) {
  passes.clear();
  if (!in_range(options)) return ClearingError{ClearingFault::kOptionOutOfRange};
  if (const auto error = Clearing<Scalar>{options, space, passes}.run(pocket)) return *error;
  return static_cast<std::uint32_t>(passes.size());
}

template Result<std::uint32_t, ClearingError> clear_pocket(const ContourView<double>&,
                                                           const ClearingOptions<double>&,
                                                           const ClearingSpace<double>&,
                                                           PassList<double>&);

}  // namespace cnc::pocket
