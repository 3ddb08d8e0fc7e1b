#include "host-sim/cut/timeline.hpp"

#include <algorithm>
#include <limits>

#include "host-sim/cut/rapid_way.hpp"
#include "host-sim/knowledge/experiment.hpp"

namespace sim::cut {
namespace {

struct KindName {
  std::string_view name;
  std::string_view key;
};
constexpr std::array<KindName, kTimeKinds> kKindNames{{{"pierce", "pierce"},
                                                       {"leads", "lead"},
                                                       {"contours", "contour"},
                                                       {"tabs", "tab"},
                                                       {"corner loops", "corner_loop"},
                                                       {"corner dwells", "corner_dwell"},
                                                       {"rapids", "rapid"},
                                                       {"waits", "wait"}}};

TimeKind kind_of(Purpose purpose) {
  switch (purpose) {
    case Purpose::kPierce:
      return TimeKind::kPierce;
    case Purpose::kLeadIn:
    case Purpose::kLeadOut:
    case Purpose::kLink:
      return TimeKind::kLead;
    case Purpose::kTab:
      return TimeKind::kTab;
    case Purpose::kCornerLoop:
      return TimeKind::kCornerLoop;
    default:
      return TimeKind::kContour;
  }
}

/// Speeds at the joints of one cut, and the limits of each of its strokes.
class CutSpeeds {
 public:
  CutSpeeds(const Cut& cut, const LayerPlan& layer, const MachineRates& rates)
      : cut_{cut}, smoothing_s_{smoothing_seconds(rates)} {
    const double feed = from_thousandths(layer.condition.cut.speed_um_min) / 60.0;
    for (const Stroke& stroke : cut.strokes) {
      const double length = length_of(stroke);
      lengths_.push_back(length);
      limits_.push_back(length > 0.0 ? limits_on(rates, stroke) : PathLimits{});
      double speed = feed;
      if (stroke.purpose == Purpose::kPierce && layer.settings.pierce_s > 0.0) {
        speed = std::min(feed, length / layer.settings.pierce_s);
      }
      limits_.back().speed_mm_s = std::min(limits_.back().speed_mm_s, speed);
      limits_.back().jerk_mm_s3 = std::numeric_limits<double>::infinity();
    }
    find_joints(rates);
  }

  [[nodiscard]] double seconds_of(std::size_t stroke) const {
    const double end = joints_[stroke + 1];
    return seconds_along(lengths_[stroke], joints_[stroke], end, limits_[stroke]) +
           smoothing_s_ * slowing_at(stroke + 1);
  }

 private:
  /// How far the joint slows the beam down, 0…1; the smoothing of jerk takes its time for that.
  [[nodiscard]] double slowing_at(std::size_t joint) const {
    double speed = limits_[joint - 1].speed_mm_s;
    if (joint < limits_.size()) speed = std::min(speed, limits_[joint].speed_mm_s);
    return speed > 0.0 ? 1.0 - std::min(joints_[joint] / speed, 1.0) : 0.0;
  }

  [[nodiscard]] double joint_after(std::size_t stroke, const MachineRates& rates) const {
    const Stroke& next = cut_.strokes[stroke + 1];
    if (next.dwell_s > 0.0 || lengths_[stroke] == 0.0 || lengths_[stroke + 1] == 0.0) return 0.0;
    const double corner =
        corner_speed(rates, tangent_at(cut_.strokes[stroke], 1.0), tangent_at(next, 0.0));
    return std::min({corner, limits_[stroke].speed_mm_s, limits_[stroke + 1].speed_mm_s});
  }

  /// A cut begins and ends at rest; between them each speed can be reached from both sides.
  void find_joints(const MachineRates& rates) {
    const std::size_t count = cut_.strokes.size();
    joints_.assign(count + 1, 0.0);
    for (std::size_t i = 0; i + 1 < count; ++i) joints_[i + 1] = joint_after(i, rates);
    for (std::size_t i = 0; i < count; ++i) {
      joints_[i + 1] =
          std::min(joints_[i + 1], reachable_speed(lengths_[i], joints_[i], limits_[i]));
    }
    for (std::size_t i = count; i-- > 0;) {
      joints_[i] = std::min(joints_[i], reachable_speed(lengths_[i], joints_[i + 1], limits_[i]));
    }
  }

  const Cut& cut_;
  double smoothing_s_;
  std::vector<double> lengths_;
  std::vector<PathLimits> limits_;
  std::vector<double> joints_;  ///< One more than strokes, mm/s.
};

class TimelineMaker {
 public:
  explicit TimelineMaker(const MachineRates& rates) : rates_{rates} {}

  void go_to(const Place& place, std::size_t cut) {
    const double seconds = rapid_seconds(rates_, here_, place);
    if (seconds > 0.0) add(TimeKind::kRapid, cut, {here_, place}, seconds);
    here_ = place;
  }

  /// From rest to rest between the corners of a rapid.
  void go_along(const std::vector<Place>& way, std::size_t cut) {
    for (std::size_t i = 1; i < way.size(); ++i) go_to(way[i], cut);
  }

  void add_cut(const Cut& cut, const LayerPlan& layer, std::size_t number) {
    if (cut.wait_s > 0.0) add(TimeKind::kWait, number, {here_, here_}, cut.wait_s);
    const CutSpeeds speeds{cut, layer, rates_};
    for (std::size_t i = 0; i < cut.strokes.size(); ++i) {
      const Stroke& stroke = cut.strokes[i];
      if (stroke.dwell_s > 0.0) {
        add(TimeKind::kCornerDwell, number, {stroke.from, stroke.from}, stroke.dwell_s);
      }
      add(kind_of(stroke.purpose), number, stroke, speeds.seconds_of(i));
    }
    here_ = cut.end();
  }

  Timeline take() { return std::move(timeline_); }

 private:
  void add(TimeKind kind, std::size_t cut, const Stroke& path, double seconds) {
    const double begin = timeline_.total_s();
    timeline_.steps.push_back({kind, cut, path, begin, begin + seconds});
  }

  const MachineRates& rates_;
  Timeline timeline_;
  Place here_{0.0, 0.0};
};

}  // namespace

std::string_view title_of(TimeKind kind) { return kKindNames[static_cast<std::size_t>(kind)].name; }
std::string_view key_of(TimeKind kind) { return kKindNames[static_cast<std::size_t>(kind)].key; }

std::array<double, kTimeKinds> Timeline::by_kind() const {
  std::array<double, kTimeKinds> sums{};
  for (const TimeStep& step : steps) {
    sums[static_cast<std::size_t>(step.kind)] += step.end_s - step.begin_s;
  }
  return sums;
}

Timeline timeline_of(const CutPlan& plan, const MachineRates& rates) {
  TimelineMaker maker{rates};
  for (std::size_t i = 0; i < plan.cuts.size(); ++i) {
    maker.go_along(rapid_before(plan, i), i);
    maker.add_cut(plan.cuts[i], plan.plan_of(plan.cuts[i]), i);
  }
  maker.go_along(rapid_before(plan, plan.cuts.size()), plan.cuts.size());
  return maker.take();
}

Timeline scaled_to(Timeline timeline, double total_s) {
  const double whole = timeline.total_s();
  if (!(whole > 0.0)) return timeline;
  for (TimeStep& step : timeline.steps) {
    step.begin_s *= total_s / whole;
    step.end_s *= total_s / whole;
  }
  return timeline;
}

}  // namespace sim::cut
