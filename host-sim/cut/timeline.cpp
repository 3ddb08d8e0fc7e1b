#include "host-sim/cut/timeline.hpp"

#include <utility>

#include "host-sim/cut/predicted_time.hpp"
#include "host-sim/cut/rapid_way.hpp"
#include "planner/order/rapid_time.hpp"

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

class TimelineMaker {
 public:
  explicit TimelineMaker(const OrderWish& machine)
      : machine_{machine}, rapid_time_{machine.limits}, here_{machine.from} {}

  void go_to(const Place& place, std::size_t cut) {
    const double seconds = rapid_time_(place.x() - here_.x(), place.y() - here_.y());
    if (seconds > 0.0) add(TimeKind::kRapid, cut, {here_, place}, seconds);
    here_ = place;
  }

  /// From rest to rest between the corners of a rapid.
  void go_along(const std::vector<Place>& way, std::size_t cut) {
    for (std::size_t i = 1; i < way.size(); ++i) go_to(way[i], cut);
  }

  void add_cut(const Cut& cut, const LayerPlan& layer, std::size_t number) {
    if (cut.wait_s > 0.0) add(TimeKind::kWait, number, {here_, here_}, cut.wait_s);
    const std::vector<double> times = stroke_times(cut.strokes, layer, machine_);
    for (std::size_t i = 0; i < cut.strokes.size(); ++i) {
      const Stroke& stroke = cut.strokes[i];
      if (stroke.dwell_s > 0.0) {
        add(TimeKind::kCornerDwell, number, {stroke.from, stroke.from}, stroke.dwell_s);
      }
      add(kind_of(stroke.purpose), number, stroke, times[i]);
    }
    here_ = cut.end();
  }

  Timeline take() { return std::move(timeline_); }

 private:
  void add(TimeKind kind, std::size_t cut, const Stroke& path, double seconds) {
    const double begin = timeline_.total_s();
    timeline_.steps.push_back({kind, cut, path, begin, begin + seconds});
  }

  const OrderWish& machine_;
  cnc::order::RapidTime rapid_time_;
  Timeline timeline_;
  Place here_;
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

Timeline timeline_of(const CutPlan& plan) {
  TimelineMaker maker{plan.order.wish};
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
