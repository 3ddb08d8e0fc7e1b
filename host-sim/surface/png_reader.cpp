#include "host-sim/surface/png_reader.hpp"

#include <fmt/format.h>
#include <png.h>

#include <array>
#include <csetjmp>
#include <cstring>
#include <utility>
#include <vector>

#include "host-sim/surface/raster.hpp"
#include "host-sim/surface/refusal.hpp"

namespace sim::surface {
namespace {

/// The bytes that libpng reads, and its last error message. libpng passes a pointer to this object
/// to the callbacks.
struct PngSource {
  std::string_view rest;
  std::array<char, 100> complaint{};
};

void give_bytes(png_structp png, png_bytep into, png_size_t count) {
  auto& source = *static_cast<PngSource*>(png_get_io_ptr(png));
  if (count > source.rest.size()) png_error(png, "ends too early");
  std::memcpy(into, source.rest.data(), count);
  source.rest.remove_prefix(count);
}

[[noreturn]] void note_complaint(png_structp png, png_const_charp text) {
  auto& complaint = static_cast<PngSource*>(png_get_error_ptr(png))->complaint;
  std::strncpy(complaint.data(), text, complaint.size() - 1);
  png_longjmp(png, 1);
}

void pass_over_warning(png_structp, png_const_charp) {}

/// Reads a PNG picture with libpng. On errors libpng returns by longjmp. So no object with a
/// destructor may be created between setjmp() and the last call of libpng.
class PngReader {
 public:
  explicit PngReader(std::string_view bytes) : source_{bytes} {
    png_ =
        png_create_read_struct(PNG_LIBPNG_VER_STRING, &source_, note_complaint, pass_over_warning);
    info_ = png_create_info_struct(png_);
    png_set_read_fn(png_, &source_, give_bytes);
    png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    // Faults that libpng would repair or ignore are errors here, because the heights must be
    // exactly the heights in the file.
    png_set_benign_errors(png_, 0);
    png_set_crc_action(png_, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
  }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }

  [[nodiscard]] bool read_header() {
    // NOLINTNEXTLINE(cert-err52-cpp): libpng has no other way out of an error.
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_read_info(png_, info_);
    return true;
  }
  /// Reads all rows. Returns false if libpng reported an error.
  /// @param rows pointers to buffers of bytes_of_row() bytes each
  [[nodiscard]] bool read_pixels(png_bytep* rows) {
    // NOLINTNEXTLINE(cert-err52-cpp): libpng has no other way out of an error.
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_read_image(png_, rows);
    png_read_end(png_, nullptr);
    return true;
  }

  [[nodiscard]] std::size_t columns() const { return png_get_image_width(png_, info_); }
  [[nodiscard]] std::size_t rows() const { return png_get_image_height(png_, info_); }
  [[nodiscard]] std::size_t bytes_of_row() const { return png_get_rowbytes(png_, info_); }
  [[nodiscard]] int depth() const { return png_get_bit_depth(png_, info_); }
  [[nodiscard]] int kind() const { return png_get_color_type(png_, info_); }
  [[nodiscard]] bool is_interlaced() const {
    return png_get_interlace_type(png_, info_) != PNG_INTERLACE_NONE;
  }
  [[nodiscard]] std::string complaint() const { return source_.complaint.data(); }

 private:
  PngSource source_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

void require_grey(const PngReader& png, const std::string& name) {
  if (png.kind() != PNG_COLOR_TYPE_GRAY && png.kind() != PNG_COLOR_TYPE_GRAY_ALPHA) {
    refuse(name, 0, "is a colour picture", "export it as grey of 8 or 16 bit");
  }
  if ((png.depth() != 8 && png.depth() != 16) || png.is_interlaced()) {
    refuse(name,
           0,
           fmt::format("has {} bit{}", png.depth(), png.is_interlaced() ? ", interlaced" : ""),
           "export it as grey of 8 or 16 bit, without interlacing");
  }
}

}  // namespace

GridDraft read_png(std::string_view bytes, const std::string& name, const ReadOptions& options) {
  PngReader png{bytes};
  constexpr std::string_view kAgain = "export the picture again";
  if (!png.read_header()) refuse(name, 0, "its header is damaged: " + png.complaint(), kAgain);
  require_grey(png, name);
  require_raster_size(png.rows(), png.columns(), name);
  // The compression ratio of pixels is at most about 1,000. A file that is too short for its
  // picture is refused before memory is allocated.
  constexpr std::size_t kMaxInflation = 1'100;
  const std::size_t size = png.rows() * png.bytes_of_row();
  if (size / kMaxInflation > bytes.size()) {
    refuse(name, 0, "its pixels are damaged: most of them are missing", kAgain);
  }
  std::vector<png_byte> pixels(size);
  std::vector<png_bytep> rows(png.rows());
  for (std::size_t r = 0; r < rows.size(); ++r) rows[r] = pixels.data() + r * png.bytes_of_row();
  if (!png.read_pixels(rows.data())) {
    refuse(name, 0, "its pixels are damaged: " + png.complaint(), kAgain);
  }
  const std::size_t sample = static_cast<std::size_t>(png.depth()) / 8;
  const bool has_opacity = png.kind() == PNG_COLOR_TYPE_GRAY_ALPHA;
  const std::size_t step = has_opacity ? 2 * sample : sample;
  Raster grey{.rows = png.rows(), .columns = png.columns()};
  grey.heights.reserve(grey.rows * grey.columns);
  for (std::size_t i = 0; i < size; i += step) {
    grey.heights.push_back(sample == 1 ? pixels[i] : pixels[i] * 256 + pixels[i + 1]);
  }
  GridDraft draft = picture_draft(std::move(grey), sample == 1 ? 255.0 : 65'535.0, name, options);
  if (has_opacity) draft.notes.push_back(name + ": its opacity is ignored");
  return draft;
}

}  // namespace sim::surface
