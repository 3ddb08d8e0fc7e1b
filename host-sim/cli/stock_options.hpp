#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host-sim/job/stock_run.hpp"

namespace CLI {
class App;
}

namespace sim {

/// Options of `kerfline sim` for the stock.
struct StockOptions {
  std::string box;
  std::string tool;
  double cell_mm = StockWish{}.cell_mm;
  std::string png;
  std::string stl;
  std::string ply;
  std::string map;
  std::string target;                ///< Drawing of the target pocket.
  std::optional<double> depth_mm{};  ///< Depth of the target pocket, mm.
  std::string surface;  ///< File of the target surface: a measured grid, a mesh or a height map.
};

/// Adds `--stock`, `--tool` and the options that begin with `--stock-`.
void add_stock_options(CLI::App& command, StockOptions& options);

/// Returns the stock that the options describe; empty without `--stock`. Throws
/// std::invalid_argument naming the option.
[[nodiscard]] std::optional<StockWish> stock_wish_of(const StockOptions& options);

/// Reads the drawing of the pocket that the stock is to become; empty without a drawing. Throws
/// std::system_error if the drawing cannot be read, and std::invalid_argument naming the drawing if
/// it has faults.
[[nodiscard]] std::optional<stock::PocketTarget> stock_target_of(const StockOptions& options);

/// Reads the surface that the stock is to become; null without a surface. Prints the notes of its
/// reader to standard error. Throws as read_bytes() and read_surface() do.
[[nodiscard]] std::shared_ptr<const surface::Mesh> stock_surface_of(const StockOptions& options);

/// Returns option and name of each file that is to be written.
[[nodiscard]] std::vector<std::pair<const char*, std::string>> stock_files(
    const StockOptions& options);

}  // namespace sim
