#pragma once

#include <tiffio.h>

#include <cstdarg>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sim::surface {

/// Number format and order of the pixels of a TIFF file.
struct TiffSamples {
  std::uint32_t rows = 0;
  std::uint32_t columns = 0;
  int bits = 0;    ///< Number of bits of a sample.
  int format = 0;  ///< Number format, one of the SAMPLEFORMAT_… values.
  int per_pixel = 1;
  bool is_upright = true;  ///< Whether the first row is the top row and begins on the left.

  [[nodiscard]] bool are_real() const { return format == SAMPLEFORMAT_IEEEFP; }
  [[nodiscard]] std::size_t bytes() const { return static_cast<std::size_t>(bits) / 8; }
};

/// A TIFF file in memory, read with libtiff.
class TiffFile {
 public:
  /// @pre the bytes live longer than this object
  explicit TiffFile(std::string_view bytes);
  TiffFile(const TiffFile&) = delete;
  TiffFile& operator=(const TiffFile&) = delete;
  ~TiffFile() = default;

  [[nodiscard]] bool is_open() const { return tiff_ != nullptr; }
  /// Returns the last error that libtiff reported.
  [[nodiscard]] const std::string& complaint() const { return source_.complaint; }

  [[nodiscard]] TiffSamples samples() const;
  /// Returns the numbers of a tag that is unknown to libtiff. Returns an empty vector if the file
  /// does not have the tag or its numbers have another type.
  template <typename Number>
  [[nodiscard]] std::vector<Number> numbers(std::uint32_t tag) const {
    const TIFFField* const field = TIFFFindField(tiff_.get(), tag, TIFF_ANY);
    if (field == nullptr || TIFFFieldDataType(field) != kind_of(Number{})) return {};
    std::uint32_t count = 0;
    const Number* first = nullptr;
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): libtiff has no other way to a tag.
    if (TIFFGetField(tiff_.get(), tag, &count, &first) != 1 || first == nullptr) return {};
    return {first, first + count};
  }
  /// Returns the text of a tag; an empty text if the file does not have the tag.
  [[nodiscard]] std::string text(std::uint32_t tag) const;

  /// Reads the pixels row by row, in this computer's byte order.
  /// @param bytes receives the bytes of all samples
  /// @return whether all rows could be read
  [[nodiscard]] bool read(const TiffSamples& samples, std::vector<std::uint8_t>& bytes);

 private:
  struct Source {
    std::string_view bytes;
    std::uint64_t at = 0;
    std::string complaint;
  };
  struct Close {
    void operator()(TIFF* tiff) const { TIFFClose(tiff); }
  };

  static constexpr TIFFDataType kind_of(double) { return TIFF_DOUBLE; }
  static constexpr TIFFDataType kind_of(std::uint16_t) { return TIFF_SHORT; }
  static constexpr TIFFDataType kind_of(char) { return TIFF_ASCII; }

  static tmsize_t give(thandle_t handle, void* into, tmsize_t count);
  static tmsize_t take_none(thandle_t, void*, tmsize_t) { return 0; }
  static toff_t seek(thandle_t handle, toff_t way, int from);
  static int close(thandle_t) { return 0; }
  static toff_t size(thandle_t handle);
  static int note(TIFF*, void* source, const char*, const char* format, std::va_list values);
  static int pass_over(TIFF*, void*, const char*, const char*, std::va_list) { return 1; }

  bool read_rows(const TiffSamples& samples, std::vector<std::uint8_t>& bytes);
  bool read_tiles(const TiffSamples& samples, std::vector<std::uint8_t>& bytes);

  Source source_;
  std::unique_ptr<TIFF, Close> tiff_;
};

}  // namespace sim::surface
