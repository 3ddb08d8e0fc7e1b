#include "host-sim/surface/scan_rows.hpp"

#include <cmath>

namespace sim::surface {
namespace {

Eigen::Vector2d plan_point(const XyzTable& table, std::size_t index) {
  return table.points[index].head<2>();
}

/// Returns the direction in plan of the first step that is not zero; a zero vector if there is no
/// such step.
Eigen::Vector2d first_direction(const XyzTable& table) {
  for (std::size_t i = 1; i < table.points.size(); ++i) {
    const Eigen::Vector2d step = plan_point(table, i) - plan_point(table, i - 1);
    const double length = step.norm();
    if (length > 0.0) return step / length;
  }
  return Eigen::Vector2d::Zero();
}

/// Returns the index of the first point of each row except the first row, for rows along
/// `direction`.
std::vector<std::size_t> turns_along(const XyzTable& table, const Eigen::Vector2d& direction) {
  std::vector<std::size_t> turns;
  // Sense of the row: 1 along `direction`, -1 against it, 0 before the first step.
  double sense = 0.0;
  for (std::size_t i = 1; i < table.points.size(); ++i) {
    const Eigen::Vector2d step = plan_point(table, i) - plan_point(table, i - 1);
    const double along = step.dot(direction);
    const double sideways = std::abs(direction.x() * step.y() - direction.y() * step.x());
    if (sideways > std::abs(along) || along * sense < 0.0) {
      turns.push_back(i);
      sense = 0.0;
    } else if (sense == 0.0 && along != 0.0) {
      sense = along > 0.0 ? 1.0 : -1.0;
    }
  }
  return turns;
}

/// Returns the direction from the first to the last point of the longest row.
Eigen::Vector2d longest_direction(const XyzTable& table, const std::vector<std::size_t>& turns) {
  Eigen::Vector2d longest = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i <= turns.size(); ++i) {
    const std::size_t begin = i == 0 ? 0 : turns[i - 1];
    const std::size_t end = i == turns.size() ? table.points.size() : turns[i];
    const Eigen::Vector2d along = plan_point(table, end - 1) - plan_point(table, begin);
    if (along.squaredNorm() > longest.squaredNorm()) longest = along;
  }
  return longest.normalized();
}

std::vector<std::size_t> turns_of(const XyzTable& table) {
  // The direction is refined, because measured points deviate from the grid and a single step is
  // inaccurate.
  constexpr int kRounds = 3;
  std::vector<std::size_t> turns = turns_along(table, first_direction(table));
  for (int round = 0; round < kRounds; ++round) {
    turns = turns_along(table, longest_direction(table, turns));
  }
  return turns;
}

/// Returns whether `row` runs against `before`. This is true if its ends are nearer to the opposite
/// ends of `before` than to the corresponding ends.
bool runs_against(const XyzTable& table, const ScanRow& row, const ScanRow& before) {
  const auto distance = [&](std::size_t a, std::size_t b) {
    return (plan_point(table, a) - plan_point(table, b)).norm();
  };
  const std::size_t start = before.index(0);
  const std::size_t end = before.index(before.size() - 1);
  return distance(row.begin, end) + distance(row.end - 1, start) <
         distance(row.begin, start) + distance(row.end - 1, end);
}

}  // namespace

std::vector<ScanRow> rows_of(const XyzTable& table) {
  std::vector<std::size_t> bounds = table.breaks.empty() ? turns_of(table) : table.breaks;
  bounds.push_back(table.points.size());
  std::vector<ScanRow> rows;
  std::size_t begin = 0;
  for (const std::size_t end : bounds) {
    ScanRow row{begin, end};
    row.is_turned = !rows.empty() && runs_against(table, row, rows.back());
    rows.push_back(row);
    begin = end;
  }
  return rows;
}

}  // namespace sim::surface
