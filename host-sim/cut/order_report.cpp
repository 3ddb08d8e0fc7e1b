#include "host-sim/cut/order_report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "host-sim/report/duration_text.hpp"

namespace sim::cut {
namespace {

using Json = nlohmann::ordered_json;

/// Returns the percentage by which `ours` is less than `other`; 0 if `other` is 0.
double saving(double ours, double other) {
  return other > 0.0 ? 100.0 * (1.0 - ours / other) : 0.0;
}

/// Returns the time of the job in another order. The time of the cuts differs, too, because their
/// beginnings differ.
double job_time(const RapidSum& sum, const OrderFigures& order) {
  return order.strokes_s - order.rapids.own_s + sum.own_s + sum.time_s;
}

Json json_of(const RapidSum& sum, const OrderFigures& order) {
  return {{"rapid_length_mm", sum.length_mm},
          {"rapid_time_s", sum.time_s},
          {"predicted_job_time_s", job_time(sum, order)}};
}

/// Returns whether any rapids are routed around areas.
bool is_led(const OrderFigures& order) {
  constexpr double kNothingMm = 0.05;
  return std::abs(order.rapids.length_mm - order.straight.length_mm) > kNothingMm;
}

}  // namespace

std::vector<std::string> lines_of(const OrderFigures& order, std::size_t cuts) {
  const auto line = [&](std::string_view name, const RapidSum& sum) {
    return fmt::format("{} {:.1f} mm and {:.1f} s of rapids", name, sum.length_mm, sum.time_s);
  };
  std::string first = line(
      fmt::format("order {}, by {}:", order::name_of(order.wish.method), text_of(order.wish.cost)),
      order.rapids);
  if (order.is_proven) first += "; proven";
  const auto cost = [&order](const RapidSum& sum) {
    return order.wish.cost == OrderCost::kLength ? sum.length_mm : sum.time_s;
  };
  // For the other orders, only the lengths of straight rapids are known. So this order is compared
  // by its straight rapids, too.
  const auto beside = [&](std::string_view name, const RapidSum& other) {
    return line(name, other) +
           fmt::format("; {:.1f} percent saved", saving(cost(order.straight), cost(other)));
  };
  std::vector<std::string> lines{first};
  if (is_led(order)) lines.push_back(line("  this order, by straight rapids:", order.straight));
  lines.push_back(beside("  only listed starts:", order.listed));
  lines.push_back(beside("  as drawn, usual starts:", order.file));
  lines.push_back(beside("  nearest, usual starts:", order.nearest));
  lines.push_back(
      fmt::format("  {} pierces; predicted {} in all", cuts, duration_text(order.predicted_s())));
  return lines;
}

Json json_of(const OrderFigures& order, std::size_t cuts) {
  Json json;
  json["method"] = order::name_of(order.wish.method);
  json["cost"] = text_of(order.wish.cost);
  json["group"] = text_of(order.wish.grouping);
  json["seed"] = order.wish.seed;
  json["proven"] = order.is_proven;
  json["from_mm"] = {order.wish.from.x(), order.wish.from.y()};
  json["to_mm"] = {order.wish.to.x(), order.wish.to.y()};
  json["pierces"] = cuts;
  json.update(json_of(order.rapids, order));
  json["cut_time_s"] = order.strokes_s;
  json["by_straight_ways"] = json_of(order.straight, order);
  json["with_listed_starts"] = json_of(order.listed, order);
  json["file_with_usual_starts"] = json_of(order.file, order);
  json["nearest_with_usual_starts"] = json_of(order.nearest, order);
  json["saved_of_nearest"] = {
      {"rapid_length_percent", saving(order.rapids.length_mm, order.nearest.length_mm)},
      {"rapid_time_s", order.nearest.time_s - order.rapids.time_s},
      {"job_time_s", job_time(order.nearest, order) - order.predicted_s()}};
  return json;
}

}  // namespace sim::cut
