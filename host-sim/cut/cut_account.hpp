#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "host-sim/cut/part_table.hpp"
#include "host-sim/cut/price.hpp"
#include "host-sim/cut/timeline.hpp"

namespace sim::cut {

/// Account of the time and the money that a job takes.
struct CutAccount {
  Timeline timeline{};  ///< Times that add up to the time of the job on the simulated machine.
  /// Time of the job, predicted from its lengths, feeds and accelerations.
  double predicted_s = 0.0;
  PriceList prices{};
  Cost cost{};
  std::vector<PartRow> parts{};
  std::vector<std::size_t> cuts_of_layers{};  ///< Number of cuts of each layer of the drawing.
};

/// Returns the account of a job.
/// @param job_time_s time on the simulated machine. It is 0 if the machine refused the program; the
/// account then has the predicted times
[[nodiscard]] CutAccount account_of(const drawing::Drawing& drawn,
                                    const CutPlan& plan,
                                    const Timeline& predicted,
                                    double job_time_s,
                                    const PriceList& prices);

/// Returns the account as lines of text: the time by kind, the cuts by layer if there are several
/// layers, and the costs if there is a price.
/// @param drawn the drawing with the names of the layers
[[nodiscard]] std::vector<std::string> lines_of(const CutAccount& account,
                                                const drawing::Drawing& drawn);

/// Adds `time`, `pierces`, `cuts_by_layer` and `parts` to a report, and `cost` if there is a price.
void add_to_report(nlohmann::ordered_json& report,
                   const CutAccount& account,
                   const drawing::Drawing& drawn);

}  // namespace sim::cut
