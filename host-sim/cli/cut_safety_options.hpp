#pragma once

#include <memory>
#include <vector>

#include "host-sim/cut/safety.hpp"
#include "host-sim/job/setting_line.hpp"

namespace CLI {
class App;
}

namespace sim {

struct CutCommandOptions;

/// Adds the options of `kerfline cut` for an order that is safe to run.
void add_cut_safety_options(CLI::App& command, const std::shared_ptr<CutCommandOptions>& options);

/// Returns the greatest speeds of a machine with these settings changed: $110 and $111.
[[nodiscard]] cut::RapidRates rapid_rates_of(const std::vector<SettingChange>& changes);

}  // namespace sim
