#include "host-sim/cut/repeat_passes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "host-sim/cut/outlines.hpp"
#include "host-sim/cut/rapid_way.hpp"

namespace sim::cut {
namespace {

/// Throws std::invalid_argument if the settings require several passes, but one of the wishes
/// permits only one pass.
void expect_passes_with(const SafetyWishes& wishes, const LayerSettings& settings) {
  const char* other = nullptr;
  if (settings.passes > 1) {
    if (wishes.cool_s > 0.0) other = "--cool";
    if (wishes.chain_mm > 0.0) other = "--chain";
    if (wishes.avoid_freed && settings.passes_by_layer) other = "--avoid-freed and passes-by=layer";
    if (wishes.lift_mm > 0.0 && settings.z_step_mm > 0.0) other = "--lift and z-step";
  }
  if (other == nullptr) return;
  throw std::invalid_argument(fmt::format(
      "passes={}: cannot be used with {}; leave one of them out", settings.passes, other));
}

/// Returns whether the next pass of a cut may run along the same line in the opposite direction.
bool may_return(const Cut& cut) {
  return cut.start() != cut.end() && cut.programmed.empty() && !cut.picture &&
         std::ranges::all_of(cut.strokes, [](const Stroke& stroke) {
           return stroke.purpose == Purpose::kContour || stroke.purpose == Purpose::kOverscan;
         });
}

Cut pass_of(const Cut& cut, unsigned pass) {
  Cut repeated = cut;
  repeated.pass = pass;
  if (pass == 1) return repeated;
  repeated.approach.clear();
  repeated.lift_mm = 0.0;
  repeated.wait_s = 0.0;
  if (pass % 2 == 0 && may_return(cut)) turn_round(repeated.strokes);
  return repeated;
}

/// Makes the list of all passes from the list of cuts.
class PassRepeater {
 public:
  explicit PassRepeater(const CutPlan& plan) : plan_{plan}, last_(plan.cuts.size()) {}

  std::vector<Cut> repeat() && {
    for (std::size_t begin = 0; begin < plan_.cuts.size();) {
      const std::size_t end = end_of_run(begin);
      add_run(begin, end);
      begin = end;
    }
    for (std::size_t i = 0; i < cuts_.size(); ++i) {
      if (cuts_[i].pass > 1) {
        cuts_[i].after = {before_[i]};
        continue;
      }
      for (std::size_t& before : cuts_[i].after) before = last_[before];
      std::erase_if(cuts_[i].after, [i](std::size_t before) { return before >= i; });
    }
    return std::move(cuts_);
  }

 private:
  [[nodiscard]] const LayerSettings& settings_of(std::size_t cut) const {
    return plan_.plan_of(plan_.cuts[cut]).settings;
  }

  /// Returns the end of the run of cuts that begins at `begin`. In a run, each cut gets one pass
  /// before any cut gets its next pass.
  [[nodiscard]] std::size_t end_of_run(std::size_t begin) const {
    std::size_t end = begin + 1;
    if (!settings_of(begin).passes_by_layer) return end;
    const LayerPlan* const layer = &plan_.plan_of(plan_.cuts[begin]);
    while (end < plan_.cuts.size() && &plan_.plan_of(plan_.cuts[end]) == layer) ++end;
    return end;
  }

  void add_run(std::size_t begin, std::size_t end) {
    const unsigned passes = settings_of(begin).passes;
    for (unsigned pass = 1; pass <= passes; ++pass) {
      for (std::size_t i = begin; i < end; ++i) {
        before_.push_back(last_[i]);
        last_[i] = cuts_.size();
        cuts_.push_back(pass_of(plan_.cuts[i], pass));
      }
    }
  }

  const CutPlan& plan_;
  std::vector<Cut> cuts_;
  /// For each pass, the number of the previous pass of the same cut.
  std::vector<std::size_t> before_;
  std::vector<std::size_t> last_;  ///< For each cut, the number of its last pass so far.
};

}  // namespace

void repeat_passes(CutPlan& plan, const SafetyWishes& wishes) {
  bool is_repeated = false;
  for (const Cut& cut : plan.cuts) {
    const LayerSettings& settings = plan.plan_of(cut).settings;
    expect_passes_with(wishes, settings);
    is_repeated = is_repeated || settings.passes > 1;
  }
  if (!is_repeated) return;
  const RapidSum once = rapids_of(plan);
  plan.cuts = PassRepeater{plan}.repeat();
  const RapidSum all = rapids_of(plan);
  OrderFigures& order = plan.order;
  // In the other orders, the rapids between passes would be the same.
  for (RapidSum* sum : {&order.straight, &order.listed, &order.file, &order.nearest}) {
    sum->length_mm += all.length_mm - once.length_mm;
    sum->time_s += all.time_s - once.time_s;
  }
}

}  // namespace sim::cut
