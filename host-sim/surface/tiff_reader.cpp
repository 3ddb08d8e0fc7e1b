#include "host-sim/surface/tiff_reader.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "host-sim/surface/number_text.hpp"
#include "host-sim/surface/raster.hpp"
#include "host-sim/surface/refusal.hpp"
#include "host-sim/surface/tiff_file.hpp"

namespace sim::surface {
namespace {

// Numbers of tags of GeoTIFF (OGC 19-008r4) and GDAL.
constexpr std::uint32_t kPixelScaleTag = 33'550;
constexpr std::uint32_t kGeoKeysTag = 34'735;
constexpr std::uint32_t kNoDataTag = 42'113;

/// Returns the value of a GeoTIFF key of type short; 0 if the file does not have the key. In the
/// tag, the first four numbers are a header, and each key takes four numbers.
int geo_key(const TiffFile& file, std::uint16_t wanted) {
  const std::vector<std::uint16_t> numbers = file.numbers<std::uint16_t>(kGeoKeysTag);
  for (std::size_t i = 4; i + 3 < numbers.size(); i += 4) {
    if (numbers[i] == wanted && numbers[i + 1] == 0) return numbers[i + 3];
  }
  return 0;
}

bool are_degrees(const TiffFile& file) {
  constexpr std::uint16_t kModelType = 1'024;
  constexpr int kGeographic = 2;
  return geo_key(file, kModelType) == kGeographic;
}

template <typename Number>
std::vector<double> numbers_of(const std::vector<std::uint8_t>& bytes) {
  std::vector<double> numbers(bytes.size() / sizeof(Number));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    Number number{};
    std::memcpy(&number, bytes.data() + i * sizeof(Number), sizeof(Number));
    numbers[i] = static_cast<double>(number);
  }
  return numbers;
}

/// Returns the samples as numbers; nothing for sample formats that are not supported.
std::optional<std::vector<double>> heights_of(const TiffSamples& samples,
                                              const std::vector<std::uint8_t>& bytes) {
  const auto is = [&samples](int format, int bits) {
    return samples.format == format && samples.bits == bits;
  };
  if (is(SAMPLEFORMAT_UINT, 8)) return numbers_of<std::uint8_t>(bytes);
  if (is(SAMPLEFORMAT_UINT, 16)) return numbers_of<std::uint16_t>(bytes);
  if (is(SAMPLEFORMAT_UINT, 32)) return numbers_of<std::uint32_t>(bytes);
  if (is(SAMPLEFORMAT_INT, 8)) return numbers_of<std::int8_t>(bytes);
  if (is(SAMPLEFORMAT_INT, 16)) return numbers_of<std::int16_t>(bytes);
  if (is(SAMPLEFORMAT_INT, 32)) return numbers_of<std::int32_t>(bytes);
  if (is(SAMPLEFORMAT_IEEEFP, 32)) return numbers_of<float>(bytes);
  if (is(SAMPLEFORMAT_IEEEFP, 64)) return numbers_of<double>(bytes);
  return {};
}

constexpr std::string_view kAgain = "export it again";

void require_samples(const TiffSamples& samples, const std::string& name, std::size_t file_bytes) {
  if (samples.per_pixel != 1) {
    refuse(name,
           0,
           fmt::format("has {} samples in each pixel", samples.per_pixel),
           "export only its heights, as one band");
  }
  if (!samples.is_upright) {
    refuse(name, 0, "its first pixel is not at the top left", kAgain);
  }
  if (samples.bits == 0 || samples.bits % 8 != 0 || !heights_of(samples, {})) {
    refuse(name,
           0,
           fmt::format("its heights have {} bits in an unknown format", samples.bits),
           "export whole numbers of 8, 16 or 32 bits, or real numbers of 32 or 64 bits");
  }
  require_raster_size(samples.rows, samples.columns, name);
  // The compression ratio of rows is at most about 1,000. A file that is too short for its image is
  // refused before memory is allocated.
  constexpr std::size_t kMaxInflation = 1'100;
  if (samples.bytes() * samples.rows * samples.columns / kMaxInflation > file_bytes) {
    refuse(name, 0, "most of its heights are missing", kAgain);
  }
}

/// Sets the pitch of the raster, mm, from the options or the file.
void place(const TiffFile& file,
           const std::string& name,
           const ReadOptions& options,
           Raster& raster) {
  const std::vector<double> scale = file.numbers<double>(kPixelScaleTag);
  if (options.pitch_mm > 0.0 || scale.size() < 2) {
    require_pitch(options, name);
    raster.pitch = {options.pitch_mm, options.pitch_mm};
    return;
  }
  if (are_degrees(file)) {
    refuse(name, 0, "the distance between its heights is in degrees", "give it in mm with --pitch");
  }
  raster.pitch = Eigen::Vector2d{scale[0], scale[1]} * options.unit_mm;
  if (raster.pitch.minCoeff() > 0.0 && raster.pitch.allFinite()) return;
  refuse(name, 0, "the distance between its heights is not above 0", "give it in mm with --pitch");
}

/// Converts heights to mm, and the file's value for a missing height to NaN.
void scale_heights(const TiffFile& file, double unit_mm, std::vector<double>& heights) {
  const std::optional<double> no_data = parsed_number(file.text(kNoDataTag));
  for (double& height : heights) {
    const bool is_missing = (no_data && height == *no_data) || !std::isfinite(height);
    height = is_missing ? std::numeric_limits<double>::quiet_NaN() : height * unit_mm;
  }
}

}  // namespace

bool is_tiff(std::string_view bytes) {
  using namespace std::string_view_literals;
  for (const std::string_view start : {"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv}) {
    if (bytes.starts_with(start)) return true;
  }
  return false;
}

GridDraft read_tiff(std::string_view bytes, const std::string& name, const ReadOptions& options) {
  TiffFile file{bytes};
  if (!file.is_open()) refuse(name, 0, "its header is damaged: " + file.complaint(), kAgain);
  const TiffSamples samples = file.samples();
  require_samples(samples, name, bytes.size());
  std::vector<std::uint8_t> pixels;
  if (!file.read(samples, pixels)) {
    refuse(name, 0, "its pixels are damaged: " + file.complaint(), kAgain);
  }
  Raster raster{.rows = samples.rows, .columns = samples.columns};
  raster.heights = *heights_of(samples, pixels);
  const bool is_map = samples.are_real() || !file.numbers<double>(kPixelScaleTag).empty();
  if (!is_map) {
    const double white = std::pow(2.0, samples.bits) - 1.0;
    return picture_draft(std::move(raster), white, name, options);
  }
  place(file, name, options, raster);
  scale_heights(file, options.unit_mm, raster.heights);
  GridDraft draft = draft_of(std::move(raster), name);
  draft.height_span_mm = options.height_mm;
  return draft;
}

}  // namespace sim::surface
