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

/// The cost that the order of cuts minimises.
enum class OrderCost : std::uint8_t {
  kTime,    ///< Time of the rapids, plus the time that the beginnings add to cuts.
  kLength,  ///< Length of the rapids, as in the paper of cnc::order::Annealing.
};
[[nodiscard]] std::string_view text_of(OrderCost cost);

/// Cuts that stay together in the order.
enum class Grouping : std::uint8_t {
  kNone,
  /// Cuts of one layer stay together. The layers are in the order of their ranks, then of the
  /// drawing.
  kLayer,
  kPart,  ///< Cuts of an outermost contour and of everything inside it stay together.
};
[[nodiscard]] std::string_view text_of(Grouping grouping);

/// Requirements on the order of the cuts and on their beginnings, with the data of the machine.
struct OrderWish {
  order::OrderMethod method = order::OrderMethod::kOurs;
  OrderCost cost = OrderCost::kTime;
  Grouping grouping = Grouping::kNone;
  Place from{0.0, 0.0};  ///< Position of the head before the first cut, mm.
  Place to{0.0, 0.0};    ///< Position of the head after the last cut, mm.
  /// Time of the search. Without a value, the number of steps follows from the number of cuts, so
  /// that the result is the same on every machine.
  std::optional<double> seconds{};
  std::uint64_t seed = 1;
  cnc::order::RapidLimits limits{};
  /// Setting $11: deviation up to which corners may be rounded.
  double junction_deviation_mm = 0.01;
  /// Setting $12: tolerance of arcs. Lines that are welded may use part of it.
  double arc_tolerance_mm = 0.002;
  /// Steps per millimetre of X and of Y, settings $100 and $101.
  std::array<double, 2> steps_per_mm{250.0, 250.0};
  std::uint8_t decimals = 4;  ///< Decimals of printed positions; see cnc::gcode::PrintGrid.
  /// Callback that receives the finished share of the search, and the cost.
  order::OrderProgress progress{};
};

}  // namespace sim::cut
