#include "host-sim/surface/asc_reader.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

#include "host-sim/surface/number_text.hpp"
#include "host-sim/surface/raster.hpp"
#include "host-sim/surface/refusal.hpp"
#include "host-sim/surface/text_lines.hpp"

namespace sim::surface {
namespace {

/// Header of an ASCII grid, in the file's unit.
struct AscHeader {
  double columns = 0.0;
  double rows = 0.0;
  Eigen::Vector2d corner{0.0, 0.0};
  Eigen::Vector2d cell{0.0, 0.0};
  /// Offset in cells from the file's point to the middle of its cell, for X and Y: 0.5 if the file
  /// gives the corner of the cell, 0 if it gives the middle.
  Eigen::Vector2d to_middle{0.0, 0.0};
  double no_data = -9999.0;

  /// Stores the value of a key. The key may have capital or small letters. Returns whether the key
  /// is known.
  bool take(std::string_view key, double value) {
    const auto is = [&](std::string_view small) { return equals_in_small_letters(key, small); };
    if (is("ncols")) return columns = value, true;
    if (is("nrows")) return rows = value, true;
    if (is("xllcorner")) return corner.x() = value, to_middle.x() = 0.5, true;
    if (is("yllcorner")) return corner.y() = value, to_middle.y() = 0.5, true;
    if (is("xllcenter")) return corner.x() = value, to_middle.x() = 0.0, true;
    if (is("yllcenter")) return corner.y() = value, to_middle.y() = 0.0, true;
    if (is("cellsize")) return cell = {value, value}, true;
    if (is("dx")) return cell.x() = value, true;
    if (is("dy")) return cell.y() = value, true;
    if (is("nodata_value")) return no_data = value, true;
    return false;
  }
};

class AscReader {
 public:
  AscReader(std::string_view text, const std::string& name, const ReadOptions& options)
      : name_{name}, options_{options}, words_{text, 1} {}

  GridDraft read() {
    read_header();
    require_header();
    raster_.rows = static_cast<std::size_t>(header_.rows);
    raster_.columns = static_cast<std::size_t>(header_.columns);
    place();
    read_heights();
    GridDraft draft = draft_of(std::move(raster_), name_);
    draft.height_span_mm = options_.height_mm;
    return draft;
  }

 private:
  void read_header() {
    word_ = words_.next();
    while (!word_.empty() && ((word_.front() >= 'a' && word_.front() <= 'z') ||
                              (word_.front() >= 'A' && word_.front() <= 'Z'))) {
      const auto as_number = parsed_number(word_);
      // The word `nan` is not a key. It is the first height, which was not measured.
      if (as_number && std::isnan(*as_number)) return;
      const std::size_t line = words_.line();
      const std::string_view value = words_.next();
      const auto number = parsed_number(value);
      if (!number || !header_.take(word_, *number)) {
        refuse(name_,
               line,
               fmt::format("`{} {}` is not a line of a header", shown(word_), shown(value)),
               "use the keys ncols, nrows, xllcorner, yllcorner, cellsize and NODATA_value");
      }
      word_ = words_.next();
    }
  }

  void require_header() const {
    const auto is_count = [](double value) {
      return value >= 0.0 && value <= 1.0e9 && value == std::floor(value);
    };
    if (!is_count(header_.rows) || !is_count(header_.columns)) {
      refuse(name_, 0, "ncols or nrows is not a whole number", "correct the header");
    }
    require_raster_size(static_cast<std::uint64_t>(header_.rows),
                        static_cast<std::uint64_t>(header_.columns),
                        name_);
    const bool has_cells = header_.cell.minCoeff() > 0.0 && header_.cell.allFinite();
    if (!has_cells && options_.pitch_mm <= 0.0) {
      refuse(name_, 0, "the header has no cellsize above 0", "correct the header, or give --pitch");
    }
    if (!header_.corner.allFinite())
      refuse(name_, 0, "xllcorner or yllcorner is not finite", "correct the header");
    // A height takes at least two bytes: a digit and a blank.
    if (header_.rows * header_.columns > static_cast<double>(words_.rest().size()) / 2.0 + 2.0) {
      refuse(name_,
             0,
             fmt::format("the header announces {} heights, but the file is too short",
                         header_.rows * header_.columns),
             "the file is cut off; export it again");
    }
  }

  void place() {
    if (options_.pitch_mm > 0.0) {
      raster_.pitch = {options_.pitch_mm, options_.pitch_mm};
      return;
    }
    raster_.pitch = header_.cell * options_.unit_mm;
    raster_.origin =
        (header_.corner + header_.to_middle.cwiseProduct(header_.cell)) * options_.unit_mm;
  }

  void read_heights() {
    const std::size_t count = raster_.rows * raster_.columns;
    raster_.heights.reserve(count);
    raster_.lines.reserve(count);
    for (; !word_.empty(); word_ = words_.next()) {
      if (raster_.heights.size() == count) {
        refuse(name_,
               words_.line(),
               fmt::format("has more than {} heights", count),
               "correct the header");
      }
      raster_.heights.push_back(height());
      raster_.lines.push_back(static_cast<std::uint32_t>(words_.line()));
    }
    if (raster_.heights.size() == count) return;
    refuse(name_,
           words_.line(),
           fmt::format("ends in row {}, after {} heights of {}",
                       raster_.heights.size() / raster_.columns + 1,
                       raster_.heights.size(),
                       count),
           "export it again, or correct the header");
  }

  /// Returns the current word as a height in mm; NaN if the height was not measured.
  [[nodiscard]] double height() const {
    const auto value = parsed_number(word_);
    if (!value || std::isinf(*value)) {
      refuse(name_,
             words_.line(),
             fmt::format("`{}` in row {}, column {} is not a finite number",
                         shown(word_),
                         raster_.heights.size() / raster_.columns + 1,
                         raster_.heights.size() % raster_.columns + 1),
             "write the NODATA_value for a missing height");
    }
    if (*value == header_.no_data) return std::numeric_limits<double>::quiet_NaN();
    return *value * options_.unit_mm;
  }

  const std::string& name_;
  const ReadOptions& options_;
  TextWords words_;
  std::string_view word_;
  AscHeader header_;
  Raster raster_;
};

}  // namespace

GridDraft read_asc(std::string_view text, const std::string& name, const ReadOptions& options) {
  return AscReader{text, name, options}.read();
}

}  // namespace sim::surface
