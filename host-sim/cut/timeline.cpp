#include "host-sim/cut/timeline.hpp"

#include <algorithm>
#include <utility>

#include "host-sim/contour/shared_work.hpp"
#include "host-sim/cut/controller_clock.hpp"
#include "host-sim/cut/job_clock.hpp"
#include "host-sim/cut/rapid_way.hpp"

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
                                                       {"waits", "wait"},
                                                       {"overscan", "overscan"}}};

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
    case Purpose::kOverscan:
      return TimeKind::kOverscan;
    case Purpose::kCornerLoop:
      return TimeKind::kCornerLoop;
    default:
      return TimeKind::kContour;
  }
}

bool is_rest(TimeKind kind) { return kind == TimeKind::kCornerDwell || kind == TimeKind::kWait; }

/// Makes the timeline of a job by following it in the order of its program. The times of motions
/// are known only at the end of the job.
class TimelineMaker {
 public:
  explicit TimelineMaker(const OrderWish& machine) : clock_{machine}, here_{machine.from} {}

  void go_along(const std::vector<Place>& way, std::size_t cut) {
    for (std::size_t i = 1; i < way.size(); ++i) {
      if (way[i] == here_) continue;
      add_motion(TimeKind::kRapid, cut, {here_, way[i]}, 0.0);
      here_ = way[i];
    }
  }

  void add_cut(const Cut& cut, const LayerPlan& layer, std::size_t number) {
    if (cut.wait_s > 0.0) add_rest(TimeKind::kWait, number, here_, cut.wait_s);
    for (const Stroke& stroke : cut.strokes) {
      if (stroke.dwell_s > 0.0) {
        add_rest(TimeKind::kCornerDwell, number, stroke.from, stroke.dwell_s);
      }
      add_motion(kind_of(stroke.purpose), number, stroke, feed_of(stroke, layer));
    }
    here_ = cut.end();
  }

  /// Returns the timeline: all steps one after the other, with their times.
  Timeline finish() {
    const std::vector<double> times = clock_.finish();
    std::size_t motion = 0;
    double now = 0.0;
    for (TimeStep& step : timeline_.steps) {
      const double seconds = is_rest(step.kind) ? step.end_s : times[motion++];
      step.begin_s = now;
      now += seconds;
      step.end_s = now;
    }
    return std::move(timeline_);
  }

 private:
  void add_motion(TimeKind kind, std::size_t cut, const Stroke& path, double feed_mm_s) {
    const bool is_lit =
        kind != TimeKind::kRapid && kind != TimeKind::kTab && kind != TimeKind::kOverscan;
    clock_.move(path, feed_mm_s, is_lit);
    timeline_.steps.push_back({kind, cut, path});
  }
  void add_rest(TimeKind kind, std::size_t cut, const Place& place, double seconds) {
    clock_.rest();
    timeline_.steps.push_back({kind, cut, {place, place}, 0.0, seconds});
  }

  ControllerClock clock_;
  /// The steps. Before finish(), only the times of rests are known, which begin at 0.
  Timeline timeline_;
  Place here_;
};

/// Consecutive cuts whose times are predicted independently of other ranges.
struct CutRange {
  std::size_t first = 0;
  /// Number after that of the last cut. It is the number of cuts plus one if the range includes the
  /// return to the end of the job.
  std::size_t end = 0;
};

/// Divides the cuts of a long job into ranges. The division does not depend on the number of
/// threads.
std::vector<CutRange> ranges_of(const CutPlan& plan) {
  constexpr std::size_t kStrokesOfRange = 50'000;
  const std::size_t all = plan.cuts.size() + 1;
  std::vector<CutRange> ranges{{0, all}};
  std::size_t strokes = 0;
  for (std::size_t i = 0; i < plan.cuts.size(); ++i) {
    if (strokes >= kStrokesOfRange) {
      ranges.back().end = i;
      ranges.push_back({i, all});
      strokes = 0;
    }
    strokes += plan.cuts[i].strokes.size();
  }
  return ranges;
}

/// Returns the cuts that must be driven to predict the times of a range. The look-ahead of the
/// controller depends on the latest motions, so cuts before the range are driven, too. Cuts after
/// the range are driven because the job does not end with the last motion of the range.
CutRange driven_for(const CutPlan& plan, const CutRange& range) {
  constexpr std::size_t kStrokesBefore = 4 * cnc::motion::kLookAheadBlocks;
  constexpr std::size_t kStrokesBehind = cnc::motion::kLookAheadBlocks;
  CutRange driven = range;
  for (std::size_t strokes = 0; driven.first > 0 && strokes < kStrokesBefore;) {
    strokes += plan.cuts[--driven.first].strokes.size();
  }
  for (std::size_t strokes = 0; driven.end < plan.cuts.size() && strokes < kStrokesBehind;) {
    strokes += plan.cuts[driven.end++].strokes.size();
  }
  return driven;
}

/// Returns the steps of a range of cuts. The first step begins at an arbitrary time.
Timeline timeline_of(const CutPlan& plan, const CutRange& range) {
  const CutRange driven = driven_for(plan, range);
  OrderWish machine = plan.order.wish;
  if (driven.first > 0) machine.from = plan.cuts[driven.first - 1].end();
  TimelineMaker maker{machine};
  for (std::size_t i = driven.first; i < driven.end; ++i) {
    maker.go_along(rapid_before(plan, i), i);
    if (i < plan.cuts.size()) maker.add_cut(plan.cuts[i], plan.plan_of(plan.cuts[i]), i);
  }
  Timeline timeline = maker.finish();
  std::erase_if(timeline.steps, [&range](const TimeStep& step) {
    return step.cut < range.first || step.cut >= range.end;
  });
  return timeline;
}

/// Appends the steps of `more` to `all`. Their times move to follow the existing steps.
void append(Timeline& more, Timeline& all) {
  double now = all.total_s();
  for (TimeStep& step : more.steps) {
    const double seconds = step.end_s - step.begin_s;
    step.begin_s = now;
    now += seconds;
    step.end_s = now;
  }
  all.steps.insert(all.steps.end(), more.steps.begin(), more.steps.end());
  more.steps = {};
}

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
  const std::vector<CutRange> ranges = ranges_of(plan);
  std::vector<Timeline> timelines(ranges.size());
  share_work(ranges.size(),
             [&] { return [&](std::size_t i) { timelines[i] = timeline_of(plan, ranges[i]); }; });
  Timeline all = std::move(timelines.front());
  for (std::size_t i = 1; i < timelines.size(); ++i) append(timelines[i], all);
  return all;
}

Timeline predict(CutPlan& plan) {
  Timeline timeline = timeline_of(plan);
  const double own_s = plan.order.rapids.own_s;
  plan.order.rapids = rapids_of(plan);
  plan.order.rapids.own_s = own_s;
  plan.order.strokes_s = timeline.total_s() - plan.order.rapids.time_s;
  return timeline;
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
