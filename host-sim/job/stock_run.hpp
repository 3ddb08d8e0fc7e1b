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

/// A stock that a job is to carve, and the files to write about the stock that remains.
struct StockWish {
  stock::StockBox box;
  /// True if the stock ends at the bottom of `box`; false if it is deeper than every cut.
  bool has_bottom = true;
  double cell_mm = 0.05;
  stock::Cutter cutter;
  std::string png;
  std::string stl;
  std::string ply;
  std::string map;  ///< File for a picture of the distances from `surface`.
  /// Pocket to which the carved stock is compared; empty for none.
  std::optional<stock::PocketTarget> target{};
  /// Surface to which the carved stock is compared, in machine coordinates; null for none.
  std::shared_ptr<const surface::Mesh> surface{};
};

/// Carves a stock along the path of a tool that the steps of the motors describe.
///
/// A step is attributed to the line of the piece at which the follower of the path is. The follower
/// may be a few steps late, and corners may be rounded. Therefore steps near the joint of a rapid
/// and a feed may be attributed to either motion.
class StockRun final : public TraceSink {
 public:
  /// Greatest distance between the steps and the straight stretches into which they are combined,
  /// in cells.
  static constexpr double kToleranceCells = 0.25;

  /// Begins a run. The path and the follower must outlive this object, and the follower must
  /// receive each row before this object. Throws std::invalid_argument for impossible sizes of the
  /// stock or the tool.
  StockRun(const StockWish& wish,
           const ProgrammedPath& path,
           const PathDeviation& follower,
           const cnc::Settings& settings);
  ~StockRun() = default;
  StockRun(const StockRun&) = delete;
  StockRun& operator=(const StockRun&) = delete;

  void on_row(const TraceRow& row) override;
  void on_end(std::uint64_t time_ns) override;

  /// Adds figures and warnings to a report.
  /// @pre on_end was called
  void add_to(Report& report, const std::string& file) const;
  /// Writes the requested files. Throws std::system_error, with the name of the file, if a file
  /// cannot be written.
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
  /// Comparison with `StockWish::surface`; present after on_end().
  std::optional<stock::SurfaceComparison> comparison_;
};

}  // namespace sim
