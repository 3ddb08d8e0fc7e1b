#include "host-sim/machine/kerf_question.hpp"

#include <fmt/format.h>

#include "host-sim/machine/simulator.hpp"

namespace sim {

KerfQuestion::KerfQuestion(const cnc::Settings& settings)
    : statements_{
          fmt::format("$32=1\n$30={:.3f}\n", settings.get(cnc::setting::kMaxSpindleSpeed))} {}

void KerfQuestion::hear(std::string_view statement) {
  if (!statement.starts_with("$PC") && !statement.starts_with("$K")) return;
  statements_ += statement;
  statements_ += '\n';
}

std::optional<double> KerfQuestion::width(const CutCondition& condition) const {
  const std::string text = fmt::format("{}G21 G94 M190 P{} Q{:.4f}\nS{:.3f} F{:.3f}\nG41\n",
                                       statements_,
                                       condition.table,
                                       condition.thickness_mm,
                                       condition.spindle_speed,
                                       condition.feed_mm_min);
  Simulator controller{text, {.machine = {.has_switches = false}}};
  if (!controller.run().refusals.empty()) return std::nullopt;
  return static_cast<double>(controller.machine().interpreter().state().compensation.width_mm);
}

}  // namespace sim
