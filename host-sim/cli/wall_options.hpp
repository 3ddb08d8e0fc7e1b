#pragma once

#include <optional>
#include <string>

#include "host-sim/surface/read_surface.hpp"
#include "host-sim/wall/layer/layer_regions.hpp"
#include "host-sim/wall/layer/layer_strokes.hpp"
#include "host-sim/wall/path/rotary_words.hpp"

namespace CLI {
class App;
}

namespace sim {

/// Options of `kerfline wall` for a program of layers.
struct WallJobOptions {
  wall::LayerOptions layers;
  std::optional<double> stock_top_mm;  ///< Z of the stock's top; empty for the part's top.
  wall::StrokeOptions strokes;
  bool without_contour = false;
  wall::RotaryAxes axes = wall::RotaryAxes::kAC;
  double step_mm = 0.1;
  double turn_rate_deg_per_mm = 45.0;
  double swing_deg = 3.0;
  bool avoids = true;
  bool allows_lean = false;
  std::string record;
  double power_w = 0.0;
  double full_power_w = 0.0;  ///< Full power of the laser; 0 for `power_w`.
  double feed_mm_min = 0.0;
  bool constant_power = false;
  double safe_above_mm = 5.0;
  int decimals = 4;
  std::string beams;
  std::string report;

  [[nodiscard]] bool wants_layers() const { return layers.layer_mm > 0.0 || !record.empty(); }
};

/// Options of `kerfline wall`.
struct WallOptions {
  std::string file;
  surface::ReadOptions reading;
  double half_angle_deg = 0.0;
  double margin_deg = 0.0;
  double taper_gain = 0.0;
  double max_tilt_deg = 45.0;
  std::string at;
  std::string cones;
  std::string output;
  WallJobOptions job;

  /// Returns the half angle of the cone that must not touch the part, degrees.
  [[nodiscard]] double clear_deg() const {
    return half_angle_deg * (1.0 + taper_gain) + margin_deg;
  }
};

void add_wall_options(CLI::App& command, WallOptions& options);

/// Checks the options. Throws std::invalid_argument if options are missing or exclude each other.
/// @pre --cones is not among the options
void check_wall_options(const WallOptions& options);

}  // namespace sim
