#pragma once

#include <memory>
#include <optional>
#include <string>

#include "firmware/machine/settings.hpp"
#include "host-sim/measure/path_deviation.hpp"
#include "host-sim/report/report.hpp"
#include "host-sim/stock/carving.hpp"
#include "host-sim/stock/comparison.hpp"
#include "host-sim/stock/step_stretches.hpp"
#include "host-sim/stock/stock.hpp"
#include "host-sim/stock/surface_comparison.hpp"
#include "host-sim/trace/trace_row.hpp"

namespace sim {

/// A stock that a job is to carve, and the files to write of its rest.
struct StockWish {
  stock::StockBox box;
  bool has_bottom = true;  ///< Else the stock ends below every cut.
  double cell_mm = 0.05;
  stock::Cutter cutter;
  std::string png;
  std::string stl;
  std::string ply;
  std::string map;                              ///< A picture of the distances from `surface`.
  std::optional<stock::PocketTarget> target{};  ///< The pocket that it is to become.
  /// The surface that it is to become, in machine coordinates; null for none.
  std::shared_ptr<const surface::Mesh> surface{};
};

/// Carves a stock along the steps of a tool.
///
/// The line of a step is that of the piece of the program on which the follower is. It may be a few
/// steps behind, and corners may be rounded: the ends of rapids at feeds are joints.
class StockRun final : public TraceSink {
 public:
  /// How far the gathered stretches may be off the steps, in cells.
  static constexpr double kToleranceCells = 0.25;

  /// The path and the follower must outlive this; the follower sees each row before it.
  /// Throws std::invalid_argument for a stock or a tool that there is not.
  StockRun(const StockWish& wish,
           const ProgrammedPath& path,
           const PathDeviation& follower,
           const cnc::Settings& settings);
  ~StockRun() = default;
  StockRun(const StockRun&) = delete;
  StockRun& operator=(const StockRun&) = delete;

  void on_row(const TraceRow& row) override;
  void on_end(std::uint64_t time_ns) override;

  /// Adds figures and warnings. @pre on_end was called
  void add_to(Report& report, const std::string& file) const;
  /// Writes the files that are wanted. Throws std::system_error naming the file.
  /// @pre on_end was called
  void write_files(const std::string& title) const;

 private:
  [[nodiscard]] stock::StretchOrigin origin_at(const Point& place) const;
  [[nodiscard]] bool is_near(const Point& place, const Point& end, const PathPiece& piece) const;

  StockWish wish_;
  const ProgrammedPath& path_;
  const PathDeviation& follower_;
  Point step_mm_{};
  double trail_mm_;
  stock::Stock stock_;
  stock::Carving carving_;
  stock::StepStretches stretches_;
  std::optional<stock::SurfaceComparison> comparison_;  ///< After the end.
};

}  // namespace sim
