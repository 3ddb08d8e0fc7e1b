#include <gmock/gmock.h>

#include <boost/beast/zlib/deflate_stream.hpp>
#include <boost/crc.hpp>

#include "tests/host-sim/surface/support.hpp"
#include "tests/support/trials.hpp"

namespace sim::surface {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr ReadOptions kOptions{.pitch_mm = 0.5, .height_mm = 4.0};

std::string chunk_of(const std::string& type, const std::string& data) {
  boost::crc_32_type sum;
  sum.process_bytes(type.data(), type.size());
  sum.process_bytes(data.data(), data.size());
  return big(static_cast<std::uint32_t>(data.size())) + type + data +
         big(static_cast<std::uint32_t>(sum.checksum()));
}

std::string deflated(const std::string& bytes) {
  namespace zlib = boost::beast::zlib;
  zlib::deflate_stream deflater;
  std::string out(deflater.upper_bound(bytes.size()) + 64, '\0');
  zlib::z_params state;
  state.next_in = bytes.data();
  state.avail_in = bytes.size();
  state.next_out = out.data();
  state.avail_out = out.size();
  boost::beast::error_code error;
  deflater.write(state, zlib::Flush::finish, error);
  out.resize(state.total_out);
  std::uint32_t low = 1;
  std::uint32_t high = 0;
  for (const char byte : bytes) {
    low = (low + static_cast<std::uint8_t>(byte)) % 65'521;
    high = (high + low) % 65'521;
  }
  return "\x78\x9C" + out + big(high << 16U | low);
}

/// A picture before it is written: samples of all pixels, row by row.
struct Picture {
  std::uint32_t columns = 0;
  std::uint32_t rows = 0;
  std::uint8_t depth = 8;
  std::uint8_t kind = 0;
  std::uint8_t interlaced = 0;
  std::vector<std::uint16_t> samples{};
};

int guess_of(std::size_t filter, int a, int b, int c) {
  if (filter == 4) {
    const int guess = a + b - c;
    const int nearest = std::min({std::abs(guess - a), std::abs(guess - b), std::abs(guess - c)});
    if (nearest == std::abs(guess - a)) return a;
    return nearest == std::abs(guess - b) ? b : c;
  }
  return filter == 0 ? 0 : filter == 1 ? a : filter == 2 ? b : (a + b) / 2;
}

/// Returns the filtered rows; each row uses the next filter.
std::string filtered(const Picture& picture) {
  const std::size_t step = (picture.kind == 4 ? 2U : 1U) * picture.depth / 8U;
  std::string bytes;
  for (const std::uint16_t sample : picture.samples) {
    bytes += picture.depth == 16 ? big(sample) : std::string(1, static_cast<char>(sample));
  }
  const std::size_t width = bytes.size() / picture.rows;
  const auto at = [&](std::size_t row, std::size_t i) {
    return static_cast<int>(static_cast<std::uint8_t>(bytes[row * width + i]));
  };
  std::string all;
  for (std::size_t row = 0; row < picture.rows; ++row) {
    all += static_cast<char>(row % 5);
    for (std::size_t i = 0; i < width; ++i) {
      const int a = i < step ? 0 : at(row, i - step);
      const int b = row == 0 ? 0 : at(row - 1, i);
      const int c = i < step || row == 0 ? 0 : at(row - 1, i - step);
      all += static_cast<char>(at(row, i) - guess_of(row % 5, a, b, c));
    }
  }
  return all;
}

std::string png_of(const Picture& picture, const std::string& pixels) {
  const std::string header = big(picture.columns) + big(picture.rows) +
                             static_cast<char>(picture.depth) + static_cast<char>(picture.kind) +
                             std::string(2, '\0') + static_cast<char>(picture.interlaced);
  const std::string data = deflated(pixels);
  return "\x89PNG\r\n\x1A\n" + chunk_of("IHDR", header) + chunk_of("tEXt", "Title") +
         chunk_of("IDAT", data.substr(0, data.size() / 2)) +
         chunk_of("IDAT", data.substr(data.size() / 2)) + chunk_of("IEND", "");
}

Picture random_picture(std::uint64_t seed, std::uint8_t depth) {
  std::mt19937_64 random{seed};
  Picture picture{.columns = 2 + static_cast<std::uint32_t>(seed % 9),
                  .rows = 2 + static_cast<std::uint32_t>(seed % 11),
                  .depth = depth};
  std::uniform_int_distribution<int> some{0, depth == 8 ? 255 : 65'535};
  for (std::size_t i = 0; i < std::size_t{picture.columns} * picture.rows; ++i) {
    picture.samples.push_back(static_cast<std::uint16_t>(some(random)));
  }
  return picture;
}

TEST(PngReader, PicturesAreReadBack) {
  const proof::Trials trials{200};
  for (const std::uint64_t seed : trials) {
    for (const std::uint8_t depth : {std::uint8_t{8}, std::uint8_t{16}}) {
      const Picture picture = random_picture(seed, depth);
      const SurfaceInput input = read_surface(png_of(picture, filtered(picture)), "f", kOptions);
      ASSERT_EQ(input.grid->rows, picture.rows);
      ASSERT_EQ(input.grid->columns, picture.columns);
      for (std::size_t i = 0; i < picture.samples.size(); ++i) {
        const std::size_t row = picture.rows - 1 - i / picture.columns;
        EXPECT_DOUBLE_EQ(input.grid->at(row, i % picture.columns).z(),
                         picture.samples[i] * 4.0 / (depth == 8 ? 255.0 : 65'535.0));
      }
    }
  }
}

TEST(PngReader, OpacityIsPassedOver) {
  const Picture picture{.columns = 2, .rows = 2, .kind = 4, .samples = {255, 7, 0, 7, 0, 7, 0, 7}};
  const SurfaceInput input = read_surface(png_of(picture, filtered(picture)), "f", kOptions);
  EXPECT_EQ(input.grid->at(1, 0).z(), 4.0);
  EXPECT_THAT(input.notes, ElementsAre("f: its opacity is ignored"));
}

TEST(PngReader, AnyDamagedByteIsFound) {
  const Picture picture = random_picture(5, 8);
  const std::string bytes = png_of(picture, filtered(picture));
  for (std::size_t i = 8; i < bytes.size(); ++i) {
    std::string damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ 4);
    EXPECT_NE(refusal_of(damaged, kOptions), "") << i;
    EXPECT_NE(refusal_of(bytes.substr(0, i), kOptions), "") << i;
  }
  EXPECT_THAT(refusal_of(bytes.substr(0, 40), kOptions), HasSubstr("ends too early"));
}

TEST(PngReader, OtherPicturesAreRefused) {
  Picture picture = random_picture(5, 8);
  const std::string pixels = filtered(picture);
  EXPECT_THAT(refusal_of(png_of(picture, pixels)), HasSubstr("--pitch"));
  EXPECT_THAT(refusal_of(png_of(picture, pixels + "x"), kOptions), HasSubstr("pixels are damaged"));
  EXPECT_THAT(refusal_of(png_of(picture, pixels.substr(1)), kOptions), HasSubstr("are damaged"));
  std::string filter = pixels;
  filter[0] = '\x05';
  EXPECT_THAT(refusal_of(png_of(picture, filter), kOptions), HasSubstr("bad adaptive filter"));
  picture.kind = 2;
  EXPECT_THAT(refusal_of(png_of(picture, pixels), kOptions), HasSubstr("is a colour picture"));
  picture.kind = 0;
  picture.depth = 4;
  EXPECT_THAT(refusal_of(png_of(picture, pixels), kOptions), HasSubstr("has 4 bit"));
  picture.depth = 8;
  picture.interlaced = 1;
  EXPECT_THAT(refusal_of(png_of(picture, pixels), kOptions), HasSubstr("without interlacing"));
  picture.interlaced = 0;
  picture.columns = picture.rows = 6000;
  EXPECT_THAT(refusal_of(png_of(picture, pixels), kOptions), HasSubstr("are damaged"));
  picture.columns = 0x7FFF'FFFF;
  EXPECT_THAT(refusal_of(png_of(picture, pixels), kOptions), HasSubstr("are too many"));
}

}  // namespace
}  // namespace sim::surface
