#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "host-sim/cut/part_table.hpp"
#include "host-sim/cut/price.hpp"
#include "host-sim/cut/timeline.hpp"

namespace sim::cut {

/// What the time and the money of a job go to.
struct CutAccount {
  Timeline timeline{};       ///< Adds up to the time of the job on the simulated machine.
  double predicted_s = 0.0;  ///< Time of the job by its lengths, feeds and accelerations.
  PriceList prices{};
  Cost cost{};
  std::vector<PartRow> parts{};
  std::vector<std::size_t> cuts_of_layers{};  ///< One for each layer of the drawing.
};

/// Makes up the account of a job.
/// @param job_time_s of the simulated machine; 0 where it refused the program: then the predicted
/// times count
[[nodiscard]] CutAccount account_of(const drawing::Drawing& drawn,
                                    const CutPlan& plan,
                                    const Timeline& predicted,
                                    double job_time_s,
                                    const PriceList& prices);

/// For people: the time by kind, cuts by layer where there are several, and costs where there is a
/// price. @param drawn has the layers' names
[[nodiscard]] std::vector<std::string> lines_of(const CutAccount& account,
                                                const drawing::Drawing& drawn);

/// Adds `time`, `cuts_by_layer`, `parts` and, where there is a price, `cost` to a report.
void add_to_report(nlohmann::ordered_json& report,
                   const CutAccount& account,
                   const drawing::Drawing& drawn);

}  // namespace sim::cut
