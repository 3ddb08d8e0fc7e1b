#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "planner/order/neighbours.hpp"
#include "planner/order/rapid_time.hpp"

namespace sim::cut {

/// Cost of a straight rapid, as its length or its time.
///
/// A time is expressed as the distance that a rapid covers in this time. So both kinds of cost have
/// about the same magnitude, and a search that compares costs with distances works with both.
class RapidCost {
 public:
  /// Makes an object whose cost is the length, mm.
  RapidCost() = default;
  /// Makes an object whose cost is the time, for a machine with `limits`.
  explicit RapidCost(const cnc::order::RapidLimits& limits)
      : time_{limits},
        mm_per_s_{std::min(limits.rate_mm_s[0], limits.rate_mm_s[1])},
        is_time_{true} {}

  [[nodiscard]] double operator()(double x_mm, double y_mm) const {
    if (is_time_) return mm_per_s_ * time_(x_mm, y_mm);
    return std::sqrt(x_mm * x_mm + y_mm * y_mm);
  }
  [[nodiscard]] bool is_time() const { return is_time_; }
  [[nodiscard]] double mm_per_s() const { return mm_per_s_; }

 private:
  cnc::order::RapidTime time_{{}};
  double mm_per_s_ = 1.0;
  bool is_time_ = false;
};

/// Cost of the leg between two candidates of cnc::order.
class LegCost {
 public:
  struct Terms {
    cnc::order::CandidatePlaces places;
    std::span<const double> own;  ///< Own cost of each candidate; empty if there are no own costs.
    /// Whether the leg after the last cut costs nothing, because other cuts follow.
    bool is_free_end = false;
  };

  LegCost(const Terms& terms, const RapidCost& rapid) : terms_{terms}, rapid_{&rapid} {}

  /// Returns the cost of the leg between two candidates. Half of the own cost of a candidate
  /// belongs to the leg to the candidate, and half to the leg from it. So a tour has the same cost
  /// in both directions if its rapids have.
  [[nodiscard]] double operator()(cnc::order::Index from, cnc::order::Index to) const {
    return table_.empty() ? computed(from, to) : table_[from * terms_.places.entry.size() + to];
  }

  /// Fills a table with the costs of all legs, and uses it from then on. The table must outlive
  /// this object.
  void keep_in(std::vector<double>& table) {
    const std::size_t count = terms_.places.entry.size();
    table.resize(count * count);
    for (std::size_t from = 0; from < count; ++from) {
      for (std::size_t to = 0; to < count; ++to) {
        table[from * count + to] =
            computed(static_cast<cnc::order::Index>(from), static_cast<cnc::order::Index>(to));
      }
    }
    table_ = table;
  }

 private:
  [[nodiscard]] double computed(cnc::order::Index from, cnc::order::Index to) const {
    const double own = terms_.own.empty() ? 0.0 : 0.5 * (terms_.own[from] + terms_.own[to]);
    if (terms_.is_free_end && to == 0) return own;
    const cnc::order::Place& exit = terms_.places.exit[from];
    const cnc::order::Place& entry = terms_.places.entry[to];
    return own + (*rapid_)(entry.x - exit.x, entry.y - exit.y);
  }

  Terms terms_;
  const RapidCost* rapid_;
  std::span<const double> table_;
};

}  // namespace sim::cut
