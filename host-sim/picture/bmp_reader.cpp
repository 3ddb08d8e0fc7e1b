#include "host-sim/picture/bmp_reader.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <stdexcept>

namespace sim::picture {
namespace {

constexpr std::size_t kFileHeader = 14;
constexpr std::size_t kMinInfoHeader = 40;
constexpr std::size_t kColourBytes = 4;

/// Reads numbers of a file whose least significant byte comes first.
class LittleEndian {
 public:
  LittleEndian(std::string_view bytes, const std::string& name) : bytes_{bytes}, name_{name} {}

  [[nodiscard]] std::uint32_t number(std::size_t at, std::size_t count) const {
    if (at + count > bytes_.size()) refuse("ends too early; save it again");
    std::uint32_t value = 0;
    for (std::size_t i = count; i-- > 0;) {
      value = (value << 8U) | static_cast<std::uint8_t>(bytes_[at + i]);
    }
    return value;
  }

  [[noreturn]] void refuse(const std::string& reason) const {
    throw std::invalid_argument(fmt::format("{}: the BMP {}", name_, reason));
  }

 private:
  std::string_view bytes_;
  const std::string& name_;
};

/// Returns the darkness of a colour, 0 to 1, with the weights of ITU-R BT.601.
float darkness_of(std::uint32_t blue, std::uint32_t green, std::uint32_t red) {
  const double light = 0.299 * red + 0.587 * green + 0.114 * blue;
  return static_cast<float>(1.0 - light / 255.0);
}

/// Reads a BMP file and converts its pixels to darkness.
class BmpReader {
 public:
  BmpReader(std::string_view bytes, const std::string& name) : file_{bytes, name}, name_{name} {}

  GreyImage read() {
    read_header();
    const std::size_t row_bytes = (image_.width * bits_ + 31) / 32 * 4;
    const std::size_t begin = file_.number(10, 4);
    // Reading the last byte throws if the file is cut off, before memory for its pixels is
    // allocated.
    static_cast<void>(file_.number(begin + row_bytes * image_.height - 1, 1));
    image_.darkness.resize(image_.width * image_.height);
    for (std::size_t y = 0; y < image_.height; ++y) {
      const std::size_t row = is_from_top_ ? y : image_.height - 1 - y;
      for (std::size_t x = 0; x < image_.width; ++x) {
        image_.darkness[row * image_.width + x] = pixel(begin + y * row_bytes, x);
      }
    }
    return std::move(image_);
  }

 private:
  void read_header() {
    const std::size_t info = file_.number(kFileHeader, 4);
    if (info < kMinInfoHeader) file_.refuse("is of OS/2; save it as PNG");
    const auto width = static_cast<std::int32_t>(file_.number(18, 4));
    const auto height = static_cast<std::int32_t>(file_.number(22, 4));
    bits_ = file_.number(28, 2);
    const std::uint32_t compression = file_.number(30, 4);
    constexpr std::uint32_t kBitFields = 3;
    if (compression != 0 && !(compression == kBitFields && bits_ == 32)) {
      file_.refuse("is compressed; save it as PNG");
    }
    const bool has_palette = bits_ == 1 || bits_ == 4 || bits_ == 8;
    if (!has_palette && bits_ != 24 && bits_ != 32) {
      file_.refuse(fmt::format("has {} bits for a pixel; save it as PNG", bits_));
    }
    if (width <= 0 || height == 0 || height == INT32_MIN) file_.refuse("has no pixels");
    is_from_top_ = height < 0;
    image_.width = static_cast<std::size_t>(width);
    image_.height = static_cast<std::size_t>(is_from_top_ ? -height : height);
    expect_size(image_.width, image_.height, name_);
    if (has_palette) read_palette(kFileHeader + info);
  }

  void read_palette(std::size_t begin) {
    const std::uint32_t written = file_.number(46, 4);
    const std::uint32_t most = 1U << bits_;
    const std::uint32_t count = written == 0 || written > most ? most : written;
    for (std::uint32_t i = 0; i < count; ++i) palette_.push_back(colour(begin + i * kColourBytes));
  }

  [[nodiscard]] float colour(std::size_t at) const {
    return darkness_of(file_.number(at, 1), file_.number(at + 1, 1), file_.number(at + 2, 1));
  }

  [[nodiscard]] float pixel(std::size_t row, std::size_t x) const {
    if (palette_.empty()) return colour(row + x * (bits_ / 8));
    const std::size_t per_byte = 8 / bits_;
    const auto shift = static_cast<std::uint32_t>(8 - bits_ * (x % per_byte + 1));
    const std::uint32_t index =
        (file_.number(row + x / per_byte, 1) >> shift) & ((1U << bits_) - 1U);
    if (index >= palette_.size()) file_.refuse("has a pixel without a colour; save it again");
    return palette_[index];
  }

  LittleEndian file_;
  const std::string& name_;
  GreyImage image_;
  std::size_t bits_ = 0;
  bool is_from_top_ = false;
  std::vector<float> palette_;
};

}  // namespace

GreyImage read_bmp(std::string_view bytes, const std::string& name) {
  return BmpReader{bytes, name}.read();
}

}  // namespace sim::picture
