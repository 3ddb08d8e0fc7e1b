#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

#include "host-sim/cut/stroke.hpp"
#include "host-sim/order/order_solver.hpp"
#include "planner/order/rapid_time.hpp"

namespace sim::cut {

/// What an order of cuts is to be short in.
enum class OrderCost : std::uint8_t {
  kTime,    ///< Seconds of rapids, and of what beginnings change of the cuts.
  kLength,  ///< Millimetres of rapids, as in the paper.
};
[[nodiscard]] std::string_view text_of(OrderCost cost);

/// What is cut together.
enum class Grouping : std::uint8_t {
  kNone,
  kLayer,  ///< Each layer as a whole, in the order of their ranks and of the drawing.
  kPart,   ///< Each outermost contour with everything in it.
};
[[nodiscard]] std::string_view text_of(Grouping grouping);

/// How the order of the cuts and their beginnings are chosen.
struct OrderWish {
  order::OrderMethod method = order::OrderMethod::kOurs;
  OrderCost cost = OrderCost::kTime;
  Grouping grouping = Grouping::kNone;
  Place from{0.0, 0.0};  ///< Where the head is before the first cut, mm.
  Place to{0.0, 0.0};    ///< Where it goes after the last one, mm.
  /// Time of the search. Without it a number of steps that follows from the number of cuts, so that
  /// the result is the same on every machine.
  std::optional<double> seconds{};
  std::uint64_t seed = 1;
  cnc::order::RapidLimits limits{};
  double junction_deviation_mm = 0.01;               ///< $11: how far corners may be rounded.
  double arc_tolerance_mm = 0.002;                   ///< $12: share of it for welded lines.
  std::array<double, 2> steps_per_mm{250.0, 250.0};  ///< $100 and $101.
  std::uint8_t decimals = 4;        ///< Decimals of positions, see cnc::gcode::PrintGrid.
  order::OrderProgress progress{};  ///< Share done and cost, now and then.
};

}  // namespace sim::cut
