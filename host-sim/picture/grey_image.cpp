#include "host-sim/picture/grey_image.hpp"

#include <fmt/format.h>
#include <png.h>
#include <turbojpeg.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "host-sim/picture/bmp_reader.hpp"

namespace sim::picture {
namespace {

constexpr std::string_view kPngStart = "\x89PNG\r\n\x1A\n";
constexpr std::string_view kJpegStart = "\xFF\xD8";
constexpr std::string_view kBmpStart = "BM";

std::invalid_argument refusal(const std::string& name, const std::string& reason) {
  return std::invalid_argument(fmt::format("{}: {}", name, reason));
}

GreyImage image_from(std::size_t width,
                     std::size_t height,
                     const std::vector<std::uint8_t>& lightness) {
  GreyImage image{width, height, std::vector<float>(width * height), {}};
  for (std::size_t i = 0; i < lightness.size(); ++i) {
    image.darkness[i] = 1.0F - static_cast<float>(lightness[i]) / 255.0F;
  }
  return image;
}

/// Frees the memory that libpng keeps for a picture.
struct PngEnd {
  void operator()(png_image* image) const { png_image_free(image); }
};

GreyImage read_png_image(std::string_view bytes, const std::string& name) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  const std::unique_ptr<png_image, PngEnd> png{&header};
  const auto refuse = [&] {
    return refusal(name, fmt::format("the PNG is damaged, {}; save it again", &header.message[0]));
  };
  if (png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()) == 0) throw refuse();
  expect_size(header.width, header.height, name);
  header.format = PNG_FORMAT_GRAY;
  std::vector<std::uint8_t> lightness(std::size_t{header.width} * header.height);
  const png_color white{255, 255, 255};
  if (png_image_finish_read(&header, &white, lightness.data(), 0, nullptr) == 0) throw refuse();
  return image_from(header.width, header.height, lightness);
}

/// Destroys a JPEG decoder.
struct JpegEnd {
  void operator()(void* decoder) const { static_cast<void>(tjDestroy(decoder)); }
};

GreyImage read_jpeg_image(std::string_view bytes, const std::string& name) {
  const std::unique_ptr<void, JpegEnd> decoder{tjInitDecompress()};
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): text as bytes.
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  int width = 0;
  int height = 0;
  int sampling = 0;
  int colours = 0;
  const auto refuse = [&] {
    return refusal(
        name,
        fmt::format("the JPEG cannot be read, {}; save it as PNG", tjGetErrorStr2(decoder.get())));
  };
  if (tjDecompressHeader3(
          decoder.get(), data, bytes.size(), &width, &height, &sampling, &colours) != 0) {
    throw refuse();
  }
  expect_size(static_cast<std::size_t>(width), static_cast<std::size_t>(height), name);
  std::vector<std::uint8_t> lightness(static_cast<std::size_t>(width) *
                                      static_cast<std::size_t>(height));
  if (tjDecompress2(decoder.get(),
                    data,
                    bytes.size(),
                    lightness.data(),
                    width,
                    width,
                    height,
                    TJPF_GRAY,
                    TJFLAG_STOPONWARNING) != 0) {
    throw refuse();
  }
  return oriented(
      image_from(static_cast<std::size_t>(width), static_cast<std::size_t>(height), lightness),
      exif_orientation(bytes));
}

/// Returns the number that `count` bytes at the position `at` encode; nothing if `bytes` ends
/// before them.
std::optional<std::uint32_t> number_at(std::string_view bytes,
                                       std::size_t at,
                                       std::size_t count,
                                       bool is_big_endian) {
  if (at > bytes.size() || count > bytes.size() - at) return std::nullopt;
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t byte = is_big_endian ? at + i : at + count - 1 - i;
    value = (value << 8U) | static_cast<std::uint8_t>(bytes[byte]);
  }
  return value;
}

/// Returns the orientation that TIFF data give. The EXIF data of a JPEG contain TIFF data.
int tiff_orientation(std::string_view tiff) {
  constexpr std::uint32_t kOrientation = 0x0112;
  constexpr std::size_t kEntryBytes = 12;
  const bool is_big = tiff.starts_with("MM");
  const auto directory = number_at(tiff, 4, 4, is_big);
  const auto entries = directory ? number_at(tiff, *directory, 2, is_big) : std::nullopt;
  for (std::uint32_t i = 0; i < entries.value_or(0); ++i) {
    const std::size_t entry = *directory + 2 + i * kEntryBytes;
    if (number_at(tiff, entry, 2, is_big) != kOrientation) continue;
    return static_cast<int>(number_at(tiff, entry + 8, 2, is_big).value_or(1));
  }
  return 1;
}

}  // namespace

void expect_size(std::size_t width, std::size_t height, const std::string& name) {
  if (width == 0 || height == 0) throw refusal(name, "the picture has no pixels");
  if (width <= kMaxImagePixels / height) return;
  throw refusal(name,
                fmt::format("the picture has {} x {} pixels; make it smaller than {} in all",
                            width,
                            height,
                            kMaxImagePixels));
}

GreyImage read_image(std::string_view bytes, const std::string& name) {
  if (bytes.starts_with(kPngStart)) return read_png_image(bytes, name);
  if (bytes.starts_with(kJpegStart)) return read_jpeg_image(bytes, name);
  if (bytes.starts_with(kBmpStart)) return read_bmp(bytes, name);
  throw refusal(name, "is no PNG, JPEG or BMP picture; save it in one of these formats");
}

int exif_orientation(std::string_view jpeg) {
  constexpr std::string_view kExif{"Exif\0\0", 6};
  constexpr std::uint32_t kApplication1 = 0xFFE1;
  constexpr std::uint32_t kFirstSegment = 0xFFE0;
  std::size_t at = 2;
  while (const auto marker = number_at(jpeg, at, 2, true)) {
    const auto length = number_at(jpeg, at + 2, 2, true);
    if (*marker < kFirstSegment || !length || *length < 2) return 1;
    const std::string_view segment = jpeg.substr(std::min(at + 4, jpeg.size()), *length - 2);
    if (*marker == kApplication1 && segment.starts_with(kExif)) {
      return tiff_orientation(segment.substr(kExif.size()));
    }
    at += 2 + *length;
  }
  return 1;
}

GreyImage oriented(GreyImage image, int orientation) {
  constexpr int kFirst = 2;
  constexpr int kFirstTurned = 5;
  constexpr int kLast = 8;
  if (orientation < kFirst || orientation > kLast) return image;
  const bool is_turned = orientation >= kFirstTurned;
  const bool flips_x = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
  const bool flips_y = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
  GreyImage seen{image.width,
                 image.height,
                 std::vector<float>(image.darkness.size()),
                 std::vector<float>(image.cover.size())};
  if (is_turned) std::swap(seen.width, seen.height);
  for (std::size_t y = 0; y < seen.height; ++y) {
    for (std::size_t x = 0; x < seen.width; ++x) {
      std::size_t column = is_turned ? y : x;
      std::size_t row = is_turned ? x : y;
      if (flips_x) column = image.width - 1 - column;
      if (flips_y) row = image.height - 1 - row;
      const std::size_t to = y * seen.width + x;
      const std::size_t from = row * image.width + column;
      seen.darkness[to] = image.darkness[from];
      if (!seen.cover.empty()) seen.cover[to] = image.cover[from];
    }
  }
  return seen;
}

}  // namespace sim::picture
