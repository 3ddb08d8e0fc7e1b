#include "host-sim/cut/cut_account.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "host-sim/report/duration_text.hpp"

namespace sim::cut {
namespace {

using Json = nlohmann::ordered_json;

std::size_t pierces_of(const std::vector<PartRow>& parts) {
  std::size_t sum = 0;
  for (const PartRow& part : parts) sum += part.pierces;
  return sum;
}

std::string line_of_times(const Timeline& timeline) {
  const auto sums = timeline.by_kind();
  std::string line = "time:";
  for (std::size_t i = 0; i < kTimeKinds; ++i) {
    if (!(sums[i] > 0.0)) continue;
    line += fmt::format("{} {} {}",
                        line.ends_with(':') ? "" : ",",
                        title_of(static_cast<TimeKind>(i)),
                        duration_text(sums[i]));
  }
  return line;
}

std::string line_of_layers(const CutAccount& account, const drawing::Drawing& drawn) {
  std::string line = "cuts by layer:";
  for (std::size_t i = 0; i < account.cuts_of_layers.size(); ++i) {
    if (account.cuts_of_layers[i] == 0) continue;
    line += fmt::format("{} \"{}\" {} {}",
                        line.ends_with(':') ? "" : ",",
                        drawn.layers[i].name,
                        drawn.layers[i].colour,
                        account.cuts_of_layers[i]);
  }
  return line;
}

Json json_of(const PartRow& part, const CutAccount& account) {
  Json row;
  row["name"] = part.name;
  row["number"] = part.number;
  row["copies"] = part.copies;
  row["pierces"] = part.pierces;
  row["cut_length_mm"] = part.cut_length_mm;
  row["area_mm2"] = part.area_mm2;
  row["time_s"] = part.time_s;
  if (account.prices.is_given()) {
    row["cost"] = part.cost.total();
    row["cost_each"] = part.cost.total() / static_cast<double>(part.copies);
  }
  return row;
}

}  // namespace

CutAccount account_of(const drawing::Drawing& drawn,
                      const CutPlan& plan,
                      const Timeline& predicted,
                      double job_time_s,
                      const PriceList& prices) {
  CutAccount account;
  account.predicted_s = predicted.total_s();
  account.timeline = job_time_s > 0.0 ? scaled_to(predicted, job_time_s) : predicted;
  account.prices = prices;
  account.cost = cost_of(prices, account.timeline.total_s(), 1.0);
  account.parts = part_table(drawn, plan, account.timeline, prices);
  account.cuts_of_layers.resize(drawn.layers.size());
  for (const Cut& cut : plan.cuts) ++account.cuts_of_layers[cut.layer];
  return account;
}

std::vector<std::string> lines_of(const CutAccount& account, const drawing::Drawing& drawn) {
  std::vector<std::string> lines{line_of_times(account.timeline)};
  const auto is_cut = [](std::size_t cuts) { return cuts != 0; };
  if (std::ranges::count_if(account.cuts_of_layers, is_cut) > 1) {
    lines.push_back(line_of_layers(account, drawn));
  }
  if (!account.prices.is_given()) return lines;
  lines.push_back(fmt::format("cost: {}: machine {}, sheet {}",
                              amount_text(account.cost.total(), account.prices),
                              amount_text(account.cost.machine, account.prices),
                              amount_text(account.cost.material, account.prices)));
  constexpr std::size_t kMaxPartLines = 12;
  for (std::size_t i = 0; i < std::min(account.parts.size(), kMaxPartLines); ++i) {
    const PartRow& part = account.parts[i];
    lines.push_back(fmt::format(
        "cost of {}: {} each, {} in all",
        part.copies == 1 ? part.name : fmt::format("{} parts like {}", part.copies, part.name),
        amount_text(part.cost.total() / static_cast<double>(part.copies), account.prices),
        amount_text(part.cost.total(), account.prices)));
  }
  if (account.parts.size() > kMaxPartLines) {
    lines.push_back(fmt::format("and {} more kinds of parts; the report has all",
                                account.parts.size() - kMaxPartLines));
  }
  return lines;
}

void add_to_report(Json& report, const CutAccount& account, const drawing::Drawing& drawn) {
  const auto sums = account.timeline.by_kind();
  Json& time = report["time"];
  time["total_s"] = account.timeline.total_s();
  time["predicted_s"] = account.predicted_s;
  for (std::size_t i = 0; i < kTimeKinds; ++i) {
    time[fmt::format("{}_s", key_of(static_cast<TimeKind>(i)))] = sums[i];
  }
  report["pierces"] = pierces_of(account.parts);
  report["cuts_by_layer"] = Json::array();
  for (std::size_t i = 0; i < account.cuts_of_layers.size(); ++i) {
    if (account.cuts_of_layers[i] == 0) continue;
    report["cuts_by_layer"].push_back({{"layer", drawn.layers[i].name},
                                       {"colour", drawn.layers[i].colour},
                                       {"cuts", account.cuts_of_layers[i]}});
  }
  report["parts"] = Json::array();
  for (const PartRow& part : account.parts) report["parts"].push_back(json_of(part, account));
  if (!account.prices.is_given()) return;
  report["cost"] = {{"currency", account.prices.currency},
                    {"total", account.cost.total()},
                    {"machine", account.cost.machine},
                    {"sheet", account.cost.material},
                    {"per_hour", account.prices.per_hour}};
}

}  // namespace sim::cut
