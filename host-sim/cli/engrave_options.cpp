#include "host-sim/cli/engrave_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <stdexcept>

#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/value_range.hpp"
#include "host-sim/cut/layer_settings.hpp"
#include "host-sim/engrave/shading_name.hpp"

namespace sim {
namespace {

constexpr double kPictureInchMm = 25.4;
constexpr double kMaxPictureMm = 10'000.0;

constexpr const char* kEngraveFooter =
    "Rows run along X, to and fro, from the bottom; the beam is off over white. A pixel of "
    "darkness\n"
    "d is burnt with min-power + (power - min-power) d^gamma, or, with one of the shadings by "
    "dots,\n"
    "as dots of full --power. Rows of pixels are written as `X0.8 S0:120:300`, which this\n"
    "controller reads; --plain writes one S to a line, for any Grbl.\n"
    "\n"
    "Example:\n"
    "  kerfline engrave photo.jpg --width 80 --interval 0.1 --power 40% --feed 6000 --machine k40\n"
    "      --place corner -o photo.nc --picture burnt.png\n"
    "\n"
    "Exit status: 0 fine, 1 nothing can be burnt there, 2 the call is wrong.";

void add_size_options(CLI::App& command, EngraveOptions& options) {
  const auto add = [&](const char* name, std::optional<double>& value, const char* help) {
    return command.add_option(name, value, help);
  };
  add("--width", options.width_mm, "Width of the picture, mm")
      ->check(in_range(0.1, kMaxPictureMm, "mm"))
      ->type_name("MM");
  add("--height",
      options.height_mm,
      "Height of the picture, mm; with --width the picture is stretched")
      ->check(in_range(0.1, kMaxPictureMm, "mm"))
      ->type_name("MM");
  add("--image-dpi",
      options.image_dpi,
      "Pixels of the picture per inch, in place of --width and --height")
      ->check(in_range(1.0, 1.0e5, "dpi"))
      ->type_name("DPI");
  CLI::Option* const interval =
      command.add_option("--interval", options.interval_mm, "Distance between rows, mm")
          ->check(in_range(0.005, 10.0, "mm"))
          ->type_name("MM")
          ->capture_default_str();
  add("--dpi", options.dpi, "Rows per inch, in place of --interval")
      ->check(in_range(1.0, 5080.0, "dpi"))
      ->excludes(interval)
      ->type_name("DPI");
  add("--pixel", options.pixel_mm, "Width of a pixel, mm; default: the interval")
      ->check(in_range(0.005, 10.0, "mm"))
      ->type_name("MM");
}

void add_tone_options(CLI::App& command, EngraveOptions& options) {
  command
      .add_option("--power", options.power, "Power for black, as 40W, 60% of full power, or S600")
      ->required()
      ->type_name("POWER");
  command.add_option("--min-power", options.min_power, "Power for the lightest grey; default: 0")
      ->type_name("POWER");
  command.add_option("--feed", options.feed_mm_min, "Feed of rows, mm/min")
      ->required()
      ->check(in_range(1.0, 1.0e6, "mm/min"))
      ->type_name("MM/MIN");
  command
      .add_option(
          "--gamma", options.tone.gamma, "Exponent of the darkness; values above 1 burn lighter")
      ->check(in_range(0.1, 10.0, ""))
      ->capture_default_str();
  command
      .add_option(
          "--shading", options.shading, "Shading of the picture: power by the grey, or dots")
      ->check(CLI::IsMember(engrave::shading_names()))
      ->capture_default_str();
  command.add_flag("--invert", options.tone.is_inverted, "Burn light pixels and leave dark ones");
  command
      .add_option(
          "--full-power", options.full_power_w, "Power of the laser at the greatest S ($30), W")
      ->check(in_range(0.001, 1.0e5, "W"))
      ->type_name("W");
}

void add_row_options(CLI::App& command, EngraveOptions& options) {
  command
      .add_option("--overscan",
                  options.overscan_mm,
                  "Distance that the head runs past both ends of a row with the beam off, mm; "
                  "default: computed from the acceleration")
      ->check(in_range(0.0, 1000.0, "mm"))
      ->type_name("MM");
  command
      .add_option("--reverse-shift",
                  options.reverse_shift_mm,
                  "Distance that is added to X of rows that run to the left, mm, for a laser that "
                  "reacts late")
      ->check(in_range(-10.0, 10.0, "mm"))
      ->type_name("MM");
  command.add_flag("--one-way", options.is_one_way, "Burn all rows from left to right");
  command.add_flag("--plain", options.is_plain, "Write one S to a line, for any Grbl");
  command.add_flag("--constant-power",
                   options.constant_power,
                   "Use M3 instead of M4: power does not follow the speed");
  command.add_option("--air", options.air, "Air assist: on or M8, M7, off")
      ->check(CLI::IsMember({"on", "M7", "M8", "off"}))
      ->capture_default_str();
}

/// Returns a power as a share of the full power.
double power_share(const char* option,
                   const std::string& text,
                   double full_power_w,
                   double full_power_s) {
  if (text.empty() || text == "0") return 0.0;
  cut::LayerSettings settings;
  try {
    set(settings, "power", text);
    constexpr double kPercent = 100.0;
    const bool is_watts = settings.power_w.has_value();
    if (is_watts && full_power_w <= 0.0) {
      throw std::invalid_argument(
          "is in watts; give the power of the laser with --full-power or --machine");
    }
    power_in_watts(settings, is_watts ? full_power_w : kPercent, full_power_s);
    const double share = settings.power_w.value_or(0.0) / (is_watts ? full_power_w : kPercent);
    if (share > 1.0)
      throw std::invalid_argument("is more than the full power of the laser; choose less");
    return share;
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{} {}: {}", option, text, error.what()));
  }
}

}  // namespace

void add_engrave_options(CLI::App& command, const std::shared_ptr<EngraveOptions>& options) {
  command.footer(kEngraveFooter);
  mark_file(
      command
          .add_option("IMAGE", options->file, "Picture as PNG, JPEG or BMP; - is standard input")
          ->required(),
      FileRole::kInput);
  add_size_options(command, *options);
  add_tone_options(command, *options);
  add_row_options(command, *options);
  add_machine_options(command, options->place);
  options->post.add_to(command);
  const auto add_file = [&](FileRole role, const char* name, std::string& file, const char* help) {
    mark_file(command.add_option(name, file, help)->type_name("FILE"), role);
  };
  add_file(FileRole::kInput,
           "--settings",
           options->settings_file,
           "File of the machine's settings, `$N=value` on each line");
  command
      .add_option("--set",
                  options->set,
                  "One setting of the machine, such as '$110=12000'; may be repeated")
      ->type_name("$N=V")
      ->allow_extra_args(false);
  add_file(FileRole::kOutput,
           "-o,--output",
           options->output,
           "File of the program; default: standard output");
  add_file(FileRole::kOutput, "--report", options->report, "Write the report as JSON");
  add_file(FileRole::kOutput, "--picture", options->picture, "Write the burnt picture as PNG");
}

engrave::EngraveSettings engrave_settings_of(EngraveOptions& options,
                                             const std::optional<cut::MachineProfile>& machine,
                                             double full_power_s) {
  const double machine_w = machine ? machine->full_power_w : 0.0;
  const double full_power_w = options.full_power_w > 0.0 ? options.full_power_w : machine_w;
  options.tone.max_power = power_share("--power", options.power, full_power_w, full_power_s);
  options.tone.min_power =
      power_share("--min-power", options.min_power, full_power_w, full_power_s);
  if (options.tone.min_power > options.tone.max_power) {
    throw std::invalid_argument("--min-power: exceeds --power; choose less");
  }
  options.tone.shading = engrave::shading_named(options.shading).value_or(engrave::Shading::kGrey);
  if (options.post.is_asked() && !options.is_plain) {
    throw std::invalid_argument("--post: other controllers read one S to a line; add --plain");
  }
  engrave::EngraveSettings settings{.feed_mm_min = options.feed_mm_min,
                                    .overscan_mm = options.overscan_mm.value_or(0.0),
                                    .reverse_shift_mm = options.reverse_shift_mm,
                                    .is_one_way = options.is_one_way,
                                    .is_plain = options.is_plain,
                                    .follows_speed = !options.constant_power,
                                    .full_power_s = full_power_s,
                                    .air = options.air == "M7" ? "M7" : "M8"};
  if (options.air == "off") settings.air.clear();
  return settings;
}

engrave::BurnRaster raster_of(const EngraveOptions& options, const picture::GreyImage& image) {
  const auto across = static_cast<double>(image.width);
  const auto down = static_cast<double>(image.height);
  double width = 0.0;
  double height = 0.0;
  if (options.width_mm || options.height_mm) {
    if (options.image_dpi) {
      throw std::invalid_argument(
          "--image-dpi: the size is given by --width or --height already; leave one out");
    }
    width = options.width_mm.value_or(options.height_mm.value_or(0.0) * across / down);
    height = options.height_mm.value_or(width * down / across);
  } else if (options.image_dpi) {
    width = across * kPictureInchMm / *options.image_dpi;
    height = down * kPictureInchMm / *options.image_dpi;
  } else {
    throw std::invalid_argument(
        "the size of the picture is missing; give --width, --height or --image-dpi");
  }
  const double interval = options.dpi ? kPictureInchMm / *options.dpi : options.interval_mm;
  const double pixel = options.pixel_mm.value_or(interval);
  return engrave::burn_raster(image, {width, height}, interval, pixel, options.tone);
}

}  // namespace sim
