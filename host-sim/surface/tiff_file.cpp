#include "host-sim/surface/tiff_file.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>

namespace sim::surface {
namespace {

/// Maximum number of bytes of a single allocation by libtiff. A larger one indicates a damaged
/// file.
constexpr tmsize_t kMaxAtOnce = tmsize_t{1} << 30;

std::uint16_t short_of(TIFF* tiff, std::uint32_t tag) {
  std::uint16_t value = 0;
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): libtiff has no other way to a tag.
  return TIFFGetFieldDefaulted(tiff, tag, &value) == 1 ? value : std::uint16_t{0};
}

std::uint32_t long_of(TIFF* tiff, std::uint32_t tag) {
  std::uint32_t value = 0;
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): libtiff has no other way to a tag.
  return TIFFGetField(tiff, tag, &value) == 1 ? value : 0U;
}

}  // namespace

TiffFile::TiffFile(std::string_view bytes) : source_{.bytes = bytes, .at = 0, .complaint = {}} {
  TIFFOpenOptions* const options = TIFFOpenOptionsAlloc();
  TIFFOpenOptionsSetErrorHandlerExtR(options, note, &source_);
  TIFFOpenOptionsSetWarningHandlerExtR(options, pass_over, nullptr);
  TIFFOpenOptionsSetMaxSingleMemAlloc(options, kMaxAtOnce);
  tiff_.reset(TIFFClientOpenExt(
      "", "rm", &source_, give, take_none, seek, close, size, nullptr, nullptr, options));
  TIFFOpenOptionsFree(options);
}

tmsize_t TiffFile::give(thandle_t handle, void* into, tmsize_t count) {
  auto& source = *static_cast<Source*>(handle);
  if (count <= 0 || source.at >= source.bytes.size()) return 0;
  const std::size_t given = std::min(static_cast<std::size_t>(count),
                                     static_cast<std::size_t>(source.bytes.size() - source.at));
  std::memcpy(into, source.bytes.data() + source.at, given);
  source.at += given;
  return static_cast<tmsize_t>(given);
}

toff_t TiffFile::seek(thandle_t handle, toff_t way, int from) {
  auto& source = *static_cast<Source*>(handle);
  if (from == SEEK_CUR) {
    source.at += way;
  } else {
    source.at = from == SEEK_END ? source.bytes.size() + way : way;
  }
  return source.at;
}

toff_t TiffFile::size(thandle_t handle) { return static_cast<Source*>(handle)->bytes.size(); }

int TiffFile::note(TIFF*, void* source, const char*, const char* format, std::va_list values) {
  std::array<char, 200> text{};
  // NOLINTNEXTLINE(clang-analyzer-valist.Uninitialized): libtiff sets `values`.
  std::vsnprintf(text.data(), text.size(), format, values);
  static_cast<Source*>(source)->complaint = text.data();
  return 1;
}

TiffSamples TiffFile::samples() const {
  TIFF* const tiff = tiff_.get();
  const std::uint16_t format = short_of(tiff, TIFFTAG_SAMPLEFORMAT);
  return {.rows = long_of(tiff, TIFFTAG_IMAGELENGTH),
          .columns = long_of(tiff, TIFFTAG_IMAGEWIDTH),
          .bits = short_of(tiff, TIFFTAG_BITSPERSAMPLE),
          .format = format == SAMPLEFORMAT_VOID ? SAMPLEFORMAT_UINT : format,
          .per_pixel = short_of(tiff, TIFFTAG_SAMPLESPERPIXEL),
          .is_upright = short_of(tiff, TIFFTAG_ORIENTATION) == ORIENTATION_TOPLEFT};
}

std::string TiffFile::text(std::uint32_t tag) const {
  const std::vector<char> letters = numbers<char>(tag);
  return {letters.begin(), std::ranges::find(letters, '\0')};
}

bool TiffFile::read(const TiffSamples& samples, std::vector<std::uint8_t>& bytes) {
  bytes.resize(samples.bytes() * samples.rows * samples.columns);
  return TIFFIsTiled(tiff_.get()) != 0 ? read_tiles(samples, bytes) : read_rows(samples, bytes);
}

bool TiffFile::read_rows(const TiffSamples& samples, std::vector<std::uint8_t>& bytes) {
  const std::size_t width = samples.bytes() * samples.columns;
  if (TIFFScanlineSize64(tiff_.get()) != width) return false;
  for (std::uint32_t row = 0; row < samples.rows; ++row) {
    if (TIFFReadScanline(tiff_.get(), bytes.data() + width * row, row, 0) != 1) return false;
  }
  return true;
}

bool TiffFile::read_tiles(const TiffSamples& samples, std::vector<std::uint8_t>& bytes) {
  const std::uint32_t tile_columns = long_of(tiff_.get(), TIFFTAG_TILEWIDTH);
  const std::uint32_t tile_rows = long_of(tiff_.get(), TIFFTAG_TILELENGTH);
  const std::uint64_t size = TIFFTileSize64(tiff_.get());
  const std::uint64_t wanted = std::uint64_t{samples.bytes()} * tile_rows * tile_columns;
  if (tile_columns == 0 || tile_rows == 0 || size != wanted ||
      size > static_cast<std::uint64_t>(kMaxAtOnce)) {
    return false;
  }
  std::vector<std::uint8_t> tile(size);
  for (std::uint32_t top = 0; top < samples.rows; top += tile_rows) {
    for (std::uint32_t left = 0; left < samples.columns; left += tile_columns) {
      if (TIFFReadTile(tiff_.get(), tile.data(), left, top, 0, 0) < 0) return false;
      const std::size_t width = samples.bytes() * std::min(tile_columns, samples.columns - left);
      for (std::uint32_t row = 0; row < std::min(tile_rows, samples.rows - top); ++row) {
        const std::size_t into = std::size_t{top + row} * samples.columns + left;
        std::copy_n(tile.data() + samples.bytes() * tile_columns * row,
                    width,
                    bytes.data() + samples.bytes() * into);
      }
    }
  }
  return true;
}

}  // namespace sim::surface
