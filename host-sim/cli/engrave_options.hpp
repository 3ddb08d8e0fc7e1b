#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host-sim/cli/cut_place_options.hpp"
#include "host-sim/cli/post_option.hpp"
#include "host-sim/engrave/burn_raster.hpp"
#include "host-sim/engrave/engrave_program.hpp"
#include "host-sim/picture/grey_image.hpp"

namespace CLI {
class App;
}

namespace sim {

/// Options of `kerfline engrave`.
struct EngraveOptions {
  std::string file;
  std::optional<double> width_mm{};
  std::optional<double> height_mm{};
  std::optional<double> image_dpi{};  ///< Pixels of the picture per inch.
  double interval_mm = 0.1;
  std::optional<double> dpi{};  ///< Rows per inch, in place of the interval.
  std::optional<double> pixel_mm{};
  std::string power;      ///< Power of black.
  std::string min_power;  ///< Power of the lightest grey.
  double feed_mm_min = 0.0;
  std::string shading = "grey";
  engrave::ToneCurve tone{};
  std::optional<double> overscan_mm{};
  double reverse_shift_mm = 0.0;
  bool is_one_way = false;
  bool is_plain = false;
  bool constant_power = false;
  std::string air = "on";
  double full_power_w = 0.0;
  CutPlaceOptions place;
  PostOption post;
  std::string settings_file;
  std::vector<std::string> set;
  std::string output;
  std::string report;
  std::string picture;
};

/// Adds all options, and the text that `--help` prints below them.
void add_engrave_options(CLI::App& command, const std::shared_ptr<EngraveOptions>& options);

/// Returns the settings with which rows are driven, and sets the powers of the tone curve. Throws
/// std::invalid_argument that names the option.
[[nodiscard]] engrave::EngraveSettings engrave_settings_of(
    EngraveOptions& options,
    const std::optional<cut::MachineProfile>& machine,
    double full_power_s);

/// Returns the raster of a picture in the size that the call requires. Throws std::invalid_argument
/// if the size is not given, or if the raster has too many pixels.
[[nodiscard]] engrave::BurnRaster raster_of(const EngraveOptions& options,
                                            const picture::GreyImage& image);

}  // namespace sim
