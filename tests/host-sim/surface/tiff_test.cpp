#include <fcntl.h>
#include <gtest/gtest.h>
#include <tiffio.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include "host-sim/surface/read_surface.hpp"
#include "tests/host-sim/surface/support.hpp"
#include "tests/support/trials.hpp"

namespace sim::surface {
namespace {

/// Heights as a TIFF file contains them.
struct Image {
  std::uint32_t rows = 2;
  std::uint32_t columns = 3;
  std::uint16_t bits = 32;
  std::uint16_t format = SAMPLEFORMAT_IEEEFP;
  std::uint16_t samples = 1;
  std::uint16_t compression = COMPRESSION_NONE;
  std::uint16_t orientation = ORIENTATION_TOPLEFT;
  std::uint32_t tile = 0;  ///< Rows and columns of a tile; 0 for strips.
  std::string mode = "w";  ///< Mode of libtiff with the order of bytes, and 8 for a BigTIFF.
  std::vector<double> scale{};
  std::vector<std::uint16_t> keys{};
  std::string no_data{};
  std::vector<double> heights{1.0, 2.0, 3.0, 4.0, 5.0, 6.0};
};

void add_fields(TIFF* tiff) {
  static std::string scale = "ModelPixelScale";
  static std::string keys = "GeoKeyDirectory";
  static std::string no_data = "GDAL_NODATA";
  static const std::array<TIFFFieldInfo, 3> fields{{
      {33'550, -1, -1, TIFF_DOUBLE, FIELD_CUSTOM, 1, 1, scale.data()},
      {34'735, -1, -1, TIFF_SHORT, FIELD_CUSTOM, 1, 1, keys.data()},
      {42'113, -1, -1, TIFF_ASCII, FIELD_CUSTOM, 1, 0, no_data.data()},
  }};
  TIFFMergeFieldInfo(tiff, fields.data(), fields.size());
}

std::string sample_of(const Image& image, double height) {
  // The bytes are in the order of this machine; libtiff reorders them.
  if (image.format == SAMPLEFORMAT_IEEEFP) {
    return image.bits == 32 ? little(static_cast<float>(height)) : little(height);
  }
  const auto whole = static_cast<std::uint64_t>(static_cast<std::int64_t>(height));
  return little(whole).substr(0, image.bits / 8U);
}

void write_pixels(TIFF* tiff, const Image& image) {
  const auto at = [&image](std::uint32_t row, std::uint32_t column) {
    const bool is_in = row < image.rows && column < image.columns;
    return is_in ? image.heights[std::size_t{row} * image.columns + column] : 0.0;
  };
  if (image.tile == 0) {
    for (std::uint32_t row = 0; row < image.rows; ++row) {
      std::string bytes;
      for (std::uint32_t column = 0; column < image.columns; ++column) {
        for (int i = 0; i < image.samples; ++i) bytes += sample_of(image, at(row, column));
      }
      TIFFWriteScanline(tiff, bytes.data(), row, 0);
    }
    return;
  }
  for (std::uint32_t top = 0; top < image.rows; top += image.tile) {
    for (std::uint32_t left = 0; left < image.columns; left += image.tile) {
      std::string bytes;
      for (std::uint32_t i = 0; i < image.tile * image.tile; ++i) {
        bytes += sample_of(image, at(top + i / image.tile, left + i % image.tile));
      }
      TIFFWriteTile(tiff, bytes.data(), left, top, 0, 0);
    }
  }
}

/// Returns the bytes of a file that libtiff writes.
std::string tiff_of(const Image& image) {
  std::string path = testing::TempDir() + "tiff_XXXXXX";
  const int handle = mkstemp(path.data());
  TIFF* const tiff = TIFFFdOpen(handle, path.c_str(), image.mode.c_str());
  add_fields(tiff);
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, image.columns);
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, image.rows);
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, image.bits);
  TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, image.format);
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, image.samples);
  TIFFSetField(tiff, TIFFTAG_COMPRESSION, image.compression);
  TIFFSetField(tiff, TIFFTAG_ORIENTATION, image.orientation);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  if (image.tile > 0) {
    TIFFSetField(tiff, TIFFTAG_TILEWIDTH, image.tile);
    TIFFSetField(tiff, TIFFTAG_TILELENGTH, image.tile);
  } else {
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, 2U);
  }
  if (!image.scale.empty()) {
    TIFFSetField(tiff, 33'550, static_cast<std::uint16_t>(image.scale.size()), image.scale.data());
  }
  if (!image.keys.empty()) {
    TIFFSetField(tiff, 34'735, static_cast<std::uint16_t>(image.keys.size()), image.keys.data());
  }
  if (!image.no_data.empty()) TIFFSetField(tiff, 42'113, image.no_data.c_str());
  write_pixels(tiff, image);
  TIFFClose(tiff);
  std::ifstream file{path, std::ios::binary};
  std::string bytes{std::istreambuf_iterator<char>{file}, {}};
  std::filesystem::remove(path);
  return bytes;
}

/// Returns the heights of the grid in the order of the image, top row first.
std::vector<double> heights_of(const SurfaceInput& surface) {
  std::vector<double> heights;
  const PointGrid& grid = *surface.grid;
  for (std::size_t row = grid.rows; row-- > 0;) {
    for (std::size_t column = 0; column < grid.columns; ++column) {
      heights.push_back(grid.points[row * grid.columns + column].z());
    }
  }
  return heights;
}

TEST(Tiff, HasTheHeightsThatWereWritten) {
  const proof::Trials trials{60};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    std::mt19937_64 random{seed};
    const auto below = [&random](std::uint32_t count) {
      return static_cast<std::uint32_t>(random() % count);
    };
    Image image{.rows = 2 + below(40), .columns = 2 + below(40)};
    const bool is_real = below(2) == 0;
    constexpr std::array<std::uint16_t, 3> kWholeBits{8, 16, 32};
    image.bits = is_real ? std::array<std::uint16_t, 2>{32, 64}[below(2)] : kWholeBits[below(3)];
    image.format = is_real         ? SAMPLEFORMAT_IEEEFP
                   : below(2) == 0 ? SAMPLEFORMAT_INT
                                   : SAMPLEFORMAT_UINT;
    constexpr std::array<std::uint16_t, 4> kPackings{
        COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_PACKBITS, COMPRESSION_ADOBE_DEFLATE};
    image.compression = kPackings[below(4)];
    image.tile = 16 * below(2);
    image.mode = std::array<std::string, 4>{"wl", "wb", "wl8", "wb8"}[below(4)];
    image.scale = {0.5, 0.25, 0.0};
    image.heights.clear();
    for (std::uint32_t i = 0; i < image.rows * image.columns; ++i) {
      const double height = below(100);
      image.heights.push_back(is_real ? 0.25 * height : height);
    }
    const SurfaceInput surface = read_surface(tiff_of(image), "f", {.unit_mm = 2.0});
    ASSERT_TRUE(surface.grid.has_value());
    EXPECT_EQ(surface.grid->rows, image.rows);
    for (double& height : image.heights) height *= 2.0;
    EXPECT_EQ(heights_of(surface), image.heights);
    const Eigen::Vector3d far = surface.grid->points.back();
    EXPECT_DOUBLE_EQ(far.x(), 1.0 * (image.columns - 1));
    EXPECT_DOUBLE_EQ(far.y(), 0.5 * (image.rows - 1));
    EXPECT_EQ(surface.grid->points.front().head<2>(), Eigen::Vector2d::Zero());
  }
}

TEST(Tiff, OfWholeNumbersWithoutAScaleIsAPicture) {
  const Image image{.bits = 8, .format = SAMPLEFORMAT_UINT, .heights = {0, 255, 51, 0, 0, 0}};
  const SurfaceInput surface =
      read_surface(tiff_of(image), "f", {.pitch_mm = 1.0, .height_mm = 5.0});
  EXPECT_EQ(heights_of(surface), (std::vector<double>{0, 5, 1, 0, 0, 0}));
  EXPECT_NE(refusal_of(tiff_of(image)).find("--pitch"), std::string::npos);
  EXPECT_NE(refusal_of(tiff_of(image), {.pitch_mm = 1.0}).find("--height"), std::string::npos);
}

TEST(Tiff, FillsWhatIsMissingOnlyWhenAsked) {
  Image image{.rows = 3, .scale = {1, 1, 0}, .no_data = "-9999"};
  image.heights = {1, 1, 1, 1, -9999, 1, 1, 1, 1};
  EXPECT_NE(refusal_of(tiff_of(image)).find("row 2, column 2"), std::string::npos);
  const SurfaceInput surface = read_surface(tiff_of(image), "f", {.repair = true});
  EXPECT_EQ(heights_of(surface), std::vector<double>(9, 1.0));
  image.heights[4] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(refusal_of(tiff_of(image)).find("row 2, column 2"), std::string::npos);
}

TEST(Tiff, RefusesWhatHasNoHeights) {
  const auto refusal = [](const Image& image) { return refusal_of(tiff_of(image)); };
  EXPECT_NE(refusal({.samples = 3}).find("3 samples in each pixel"), std::string::npos);
  EXPECT_NE(refusal({.orientation = ORIENTATION_BOTLEFT}).find("first pixel"), std::string::npos);
  EXPECT_NE(refusal({}).find("--pitch"), std::string::npos);
  EXPECT_NE(refusal({.scale = {0, 0, 0}}).find("not above 0"), std::string::npos);
  // A key of three numbers behind the header declares a geographic model.
  const Image degrees{.scale = {0.001, 0.001, 0}, .keys = {1, 1, 0, 1, 1'024, 0, 1, 2}};
  EXPECT_NE(refusal(degrees).find("degrees"), std::string::npos);
  EXPECT_NE(refusal({.rows = 1, .heights = {1, 2, 3}}).find("1 rows"), std::string::npos);
}

TEST(Tiff, IsRefusedWhereItIsCutOffOrDamaged) {
  const proof::Trials trials{200};
  Image image{.compression = COMPRESSION_LZW, .scale = {1, 1, 0}};
  const std::string whole = tiff_of(image);
  for (std::size_t size = 4; size < whole.size(); ++size) {
    EXPECT_FALSE(refusal_of(whole.substr(0, size)).empty()) << size << " of " << whole.size();
  }
  for (const std::uint64_t seed : trials) {
    std::string damaged = whole;
    damaged[seed * 31 % damaged.size()] = static_cast<char>(seed % 251);
    // The file is read or refused; no other effect is allowed.
    static_cast<void>(refusal_of(damaged));
  }
}

}  // namespace
}  // namespace sim::surface
