#include "host-sim/cut/cooling.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "host-sim/cut/heat_map.hpp"
#include "host-sim/cut/rapid_way.hpp"

namespace sim::cut {
namespace {

/// Number of next cuts in the order among which the search looks for a cut that may overtake the
/// others. The number is large enough for a cut outside of the hot area, and small enough for a
/// fast search.
constexpr std::size_t kMaxOvertaken = 64;

/// Follows a job, and keeps its time and the heat of its cuts.
class HeatClock {
 public:
  explicit HeatClock(const CoolingRules& rules)
      : rules_{rules}, heat_{rules.distance_mm, rules.cool_s} {}

  [[nodiscard]] double now_s() const { return now_s_; }
  [[nodiscard]] const Place& here() const { return here_; }

  /// Returns the time that a cut must wait before its pierce if the beam arrives there at
  /// `arrival_s`, s.
  [[nodiscard]] double wait_at(const Cut& cut, double arrival_s) const {
    if (cut.strokes.front().purpose == Purpose::kLink) return 0.0;
    return std::max(0.0, heat_.cool_from(cut.start(), arrival_s) - arrival_s);
  }

  void travel(const Place& to) {
    now_s_ += min_time(here_, to, rules_.limits);
    here_ = to;
  }

  void cut(const Cut& cut, const LayerPlan& layer, double wait_s) {
    now_s_ += wait_s;
    for (const Stroke& stroke : cut.strokes) {
      const double end_s = now_s_ + min_time(stroke, layer);
      if (has_beam(stroke.purpose)) heat_.add(stroke, now_s_ + stroke.dwell_s, end_s);
      now_s_ = end_s;
    }
    here_ = beam_end(cut);
  }

 private:
  CoolingRules rules_;
  HeatMap heat_;
  double now_s_ = 0.0;
  Place here_{0.0, 0.0};
};

/// Chooses the order of the cuts of a plan, one cut after the other.
class CoolOrder {
 public:
  CoolOrder(CutPlan& plan, const CoolingRules& rules)
      : plan_{plan}, rules_{rules}, clock_{rules}, order_(plan.cuts.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    is_done_.resize(plan.cuts.size());
  }

  void run() {
    for (std::size_t i = 0; i < order_.size(); ++i) {
      const std::size_t next = best_at(i);
      if (next != i) {
        ++plan_.safety.cooling_swaps;
        const auto begin = order_.begin() + static_cast<std::ptrdiff_t>(i);
        const auto at = order_.begin() + static_cast<std::ptrdiff_t>(next);
        std::rotate(begin, at, at + 1);
      }
      const Cut& cut = plan_.cuts[order_[i]];
      clock_.travel(rapid_end(cut));
      clock_.cut(cut, plan_.plan_of(cut), clock_.wait_at(cut, clock_.now_s()));
      is_done_[order_[i]] = true;
    }
    apply();
  }

 private:
  [[nodiscard]] const Cut& at(std::size_t i) const { return plan_.cuts[order_[i]]; }
  [[nodiscard]] double way(const Place& from, const Place& to) const {
    return min_time(from, to, rules_.limits);
  }
  [[nodiscard]] bool is_ready(const Cut& cut) const {
    return std::ranges::all_of(cut.after, [this](std::size_t before) { return is_done_[before]; });
  }

  /// Returns the present position in the order of the cut that should move to position `i`: of all
  /// ready cuts, the cut with the smallest sum of wait and detour.
  [[nodiscard]] std::size_t best_at(std::size_t i) const {
    const Place& here = clock_.here();
    const auto cost_of = [&](std::size_t k) {
      const double there_s = way(here, rapid_end(at(k)));
      return clock_.wait_at(at(k), clock_.now_s() + there_s);
    };
    double least = cost_of(i);
    std::size_t best = i;
    const std::size_t end = std::min(order_.size(), i + kMaxOvertaken);
    for (std::size_t k = i + 1; k < end && least > 0.0; ++k) {
      if (at(k).layer != at(i).layer || at(k).turn != at(i).turn) break;
      if (!is_ready(at(k))) continue;
      const double cost = detour(i, k) + cost_of(k);
      if (cost >= least) continue;
      least = cost;
      best = k;
    }
    return best;
  }

  /// Returns the additional time of travel if the cut at position `k` moves to position `i`, s.
  [[nodiscard]] double detour(std::size_t i, std::size_t k) const {
    const Place& here = clock_.here();
    double added = way(here, rapid_end(at(k))) + way(beam_end(at(k)), rapid_end(at(i))) -
                   way(here, rapid_end(at(i))) - way(beam_end(at(k - 1)), rapid_end(at(k)));
    if (k + 1 < order_.size()) {
      const Place& next = rapid_end(at(k + 1));
      added += way(beam_end(at(k - 1)), next) - way(beam_end(at(k)), next);
    }
    return std::max(added, 0.0);
  }

  void apply() {
    std::vector<std::size_t> number(order_.size());
    for (std::size_t i = 0; i < order_.size(); ++i) number[order_[i]] = i;
    std::vector<Cut> cuts;
    cuts.reserve(order_.size());
    for (const std::size_t old : order_) {
      cuts.push_back(std::move(plan_.cuts[old]));
      for (std::size_t& before : cuts.back().after) before = number[before];
    }
    plan_.cuts = std::move(cuts);
  }

  CutPlan& plan_;
  CoolingRules rules_;
  HeatClock clock_;
  std::vector<std::size_t> order_;
  std::vector<bool> is_done_;
};

}  // namespace

void reorder_for_cooling(CutPlan& plan, const CoolingRules& rules) { CoolOrder{plan, rules}.run(); }

void wait_for_cooling(CutPlan& plan, const CoolingRules& rules) {
  HeatClock clock{rules};
  plan.safety.cools = true;
  for (std::size_t i = 0; i < plan.cuts.size(); ++i) {
    Cut& cut = plan.cuts[i];
    for (const Place& place : rapid_before(plan, i)) clock.travel(place);
    // Rounds up to the next millisecond, because programs give times in milliseconds.
    cut.wait_s = 1.0e-3 * std::ceil(1.0e3 * clock.wait_at(cut, clock.now_s()));
    clock.cut(cut, plan.plan_of(cut), cut.wait_s);
    if (cut.wait_s <= 0.0) continue;
    ++plan.safety.waits;
    plan.safety.waits_s += cut.wait_s;
  }
}

}  // namespace sim::cut
