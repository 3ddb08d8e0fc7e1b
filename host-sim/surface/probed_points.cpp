#include "host-sim/surface/probed_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

#include "host-sim/surface/refusal.hpp"

namespace sim::surface {
namespace {

/// Distance above the depth within which a failed answer counts as at the depth. Reports are
/// rounded to three decimals of a mm or an inch.
constexpr double kDepthToleranceMm = 0.03;

enum class PointState : std::uint8_t { kMissing, kMissed, kIncomplete, kMeasured };

struct PointRecord {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  PointState state = PointState::kMissing;
  std::size_t line = 0;
};

/// Assigns the answers of a log to the points of a grid.
class AnswerMatcher {
 public:
  AnswerMatcher(const ProbePlan& plan, std::string name)
      : plan_{plan},
        name_{std::move(name)},
        tolerance_mm_{std::min(kPlaceToleranceMm, 0.1 * plan.grid.min_pitch_mm())},
        records_(plan.grid.size()) {}

  void take(const ProbeLog& log) {
    for (const std::size_t line : log.damaged_lines) {
      note(line, "an answer is damaged and ignored");
    }
    std::vector<ProbeAnswer> run;
    std::size_t point = 0;
    for (ProbeAnswer answer : log.answers) {
      answer.place -= plan_.offset;
      if (!counts(answer)) continue;
      const std::size_t nearest = plan_.grid.nearest(answer.place.head<2>());
      if (!run.empty() && nearest != point) {
        finish(point, run);
        run.clear();
      }
      if (!is_at(answer, nearest)) continue;
      point = nearest;
      run.push_back(answer);
    }
    if (!run.empty()) finish(point, run);
    if (matched_ == 0) refuse_all(log);
  }

  ProbedPoints result() {
    ProbedPoints probed;
    for (std::size_t turn = 0; turn < records_.size(); ++turn) {
      const std::size_t index = plan_.grid.driven(turn);
      if (records_[index].state != PointState::kMeasured) probed.faults.push_back(fault_of(index));
    }
    for (std::size_t index = 0; index < records_.size(); ++index) {
      const PointRecord& record = records_[index];
      const Eigen::Vector2d place = plan_.grid.place(index);
      const double none = std::numeric_limits<double>::quiet_NaN();
      const bool is_measured = record.state == PointState::kMeasured;
      probed.points.push_back(is_measured ? record.place
                                          : Eigen::Vector3d{place.x(), place.y(), none});
    }
    probed.notes = std::move(notes_);
    return probed;
  }

 private:
  /// Returns whether an answer belongs to a touch: it has a contact, or it missed and ended at the
  /// depth.
  [[nodiscard]] bool counts(const ProbeAnswer& answer) const {
    return answer.is_touch || !plan_.depth_mm ||
           answer.place.z() <= *plan_.depth_mm + kDepthToleranceMm;
  }

  /// Returns whether an answer is at the grid point `index`. Adds a note if it is not.
  bool is_at(const ProbeAnswer& answer, std::size_t index) {
    const double off = (answer.place.head<2>() - plan_.grid.place(index)).norm();
    if (off <= tolerance_mm_) return true;
    note(
        answer.line,
        fmt::format("{} at X {:.3f}, Y {:.3f}, Z {:.3f}, {:.3f} mm away from the nearest point, {}",
                    answer.is_touch ? "the tip touched" : "a probe missed",
                    answer.place.x(),
                    answer.place.y(),
                    answer.place.z(),
                    off,
                    plan_.grid.name(index)));
    return false;
  }

  /// Stores the result of successive answers at one point.
  /// @pre `run` has at least one answer
  void finish(std::size_t index, std::span<const ProbeAnswer> run) {
    ++matched_;
    PointState state = run.back().is_touch ? PointState::kMeasured : PointState::kMissed;
    if (run.size() < plan_.touches) state = PointState::kIncomplete;
    note_more_touches(index, run);
    PointRecord& record = records_[index];
    const bool is_again = record.state != PointState::kMissing;
    if (is_again) note_again(index, run.back());
    // A measured height is not replaced by a failed answer, even by a later one.
    if (state != PointState::kMeasured && record.state == PointState::kMeasured) return;
    record = {.place = run.back().place, .state = state, .line = run.back().line};
  }

  /// Adds a note if a visit of a point has more answers than expected. Repetitions of the last
  /// answer by `$#` are not noted, and neither is the contact of a guarded motion exactly at the
  /// point.
  void note_more_touches(std::size_t index, std::span<const ProbeAnswer> run) {
    const std::size_t expected = plan_.touches + (plan_.has_guards ? 1 : 0);
    if (run.size() <= expected) return;
    const auto extra = run.subspan(expected);
    const auto is_other = [&](const ProbeAnswer& answer) {
      return answer.place != run[expected - 1].place;
    };
    if (std::ranges::none_of(extra, is_other)) return;
    note(run.back().line,
         fmt::format("{} has {} answers in place of {}; the last answer is used",
                     plan_.grid.name(index),
                     run.size(),
                     plan_.touches));
  }

  void note_again(std::size_t index, const ProbeAnswer& answer) {
    const PointRecord& before = records_[index];
    note(answer.line,
         fmt::format("{} is probed again: Z {:.3f}, and {:.3f} in line {}",
                     plan_.grid.name(index),
                     answer.place.z(),
                     before.place.z(),
                     before.line));
  }

  [[nodiscard]] std::string fault_of(std::size_t index) const {
    const PointRecord& record = records_[index];
    const std::string point = plan_.grid.name(index);
    switch (record.state) {
      case PointState::kMissed:
        return fmt::format("{}:{}: {} touched nothing down to Z {:.3f}; probe deeper",
                           name_,
                           record.line,
                           point,
                           record.place.z());
      case PointState::kIncomplete:
        return fmt::format(
            "{}:{}: {} has only its fast touch; probe it again", name_, record.line, point);
      default:
        return fmt::format("{}: {} has no answer; probe it again", name_, point);
    }
  }

  [[noreturn]] void refuse_all(const ProbeLog& log) const {
    if (log.answers.empty()) {
      refuse(name_, 0, "has no [PRB:…] answer", "name the log of the sender");
    }
    const ProbeAnswer& first = log.answers.front();
    const Eigen::Vector3d place = first.place - plan_.offset;
    const std::size_t nearest = plan_.grid.nearest(place.head<2>());
    refuse(name_,
           first.line,
           fmt::format("no answer is at a point of the grid; the first is at X {:.3f}, Y {:.3f} in "
                       "work coordinates, nearest to {}",
                       place.x(),
                       place.y(),
                       plan_.grid.name(nearest)),
           "give the work zero in machine coordinates with --offset, and --inches if the log has "
           "inches");
  }

  void note(std::size_t line, std::string_view text) {
    notes_.push_back(fmt::format("{}:{}: {}", name_, line, text));
  }

  const ProbePlan& plan_;
  std::string name_;
  double tolerance_mm_;
  std::vector<PointRecord> records_;
  std::vector<std::string> notes_;
  std::size_t matched_ = 0;
};

}  // namespace

ProbedPoints probed_points(const ProbeLog& log, const ProbePlan& plan, const std::string& name) {
  AnswerMatcher matcher{plan, name};
  matcher.take(log);
  return matcher.result();
}

}  // namespace sim::surface
