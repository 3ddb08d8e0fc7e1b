#include "host-sim/surface/xyz_table.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>

#include "host-sim/surface/read_surface.hpp"
#include "host-sim/surface/refusal.hpp"
#include "host-sim/surface/text_lines.hpp"
#include "host-sim/surface/xyz_dialect.hpp"
#include "host-sim/surface/xyz_header.hpp"

namespace sim::surface {
namespace {

/// Maximum number of lines before the first point that are not points.
constexpr std::size_t kMaxHeaderLines = 20;

class XyzTableReader {
 public:
  XyzTableReader(std::string_view text, const std::string& name)
      : name_{name}, lines_{text}, dialect_{dialect_of(text)} {}

  XyzTable read() {
    while (const auto next = lines_.next()) {
      const std::string_view line = without_comment(*next);
      const XyzFields fields = dialect_.split(line);
      if (fields.count > 0) {
        take(fields);
      } else if (next->empty() || !line.empty()) {
        blank_ = true;  // A blank line separates rows; a line with only a comment does not.
      }
    }
    if (table_.points.empty()) {
      refuse(name_, 0, "has no line of three numbers", "give X, Y and Z of a point on each line");
    }
    if (counts_points()) {
      drop_point_numbers();
    } else if (width_ > 3 && !header_ && !labelled_) {
      table_.notes.push_back(
          fmt::format("{}: {} columns; the first three are read as X, Y and Z", name_, width_));
    }
    return std::move(table_);
  }

 private:
  void take(const XyzFields& fields) {
    if (width_ == 0 && !begins_points(fields)) return take_header(fields);
    if (width_ == 0) choose_columns(fields);
    require_width(fields);
    std::array<double, 4> values{};
    for (std::size_t i = 0; i < 3; ++i) values[i] = value_of(fields, columns_[i]);
    if (may_count_) values[3] = value_of(fields, 3);
    add(values);
  }

  /// Returns whether a line is the first point: at least three fields are numbers, and a name may
  /// precede them.
  [[nodiscard]] bool begins_points(const XyzFields& fields) const {
    std::size_t numbers = 0;
    for (std::size_t i = 0; i < fields.listed(); ++i) {
      const bool filled = !fields.fields[i].empty();
      const bool is_number = filled && dialect_.number(fields.fields[i]).has_value();
      if (is_number) ++numbers;
      if (filled && !is_number && i > 0) return false;
    }
    return numbers >= 3;
  }

  void take_header(const XyzFields& fields) {
    if (dialect_.number(fields.fields[0]) && !fields.fields[0].empty()) {
      refuse(name_,
             lines_.number(),
             fmt::format("`{}` begins a line that is not a point", shown(fields.fields[0])),
             "give three numbers on each line, or mark comments with #");
    }
    if (++header_lines_ > kMaxHeaderLines) {
      refuse(name_, 0, "has no points on its first lines", "export it as XYZ text or CSV");
    }
    header_fields_ = fields.count;
    header_ = columns_of_header(fields);
  }

  void choose_columns(const XyzFields& fields) {
    width_ = fields.count;
    labelled_ = !dialect_.number(fields.fields[0]).has_value();
    // If the header and the points have different numbers of fields, the header does not name the
    // points' fields.
    if (header_ && header_fields_ != width_) header_.reset();
    if (header_) {
      columns_ = *header_;
    } else if (labelled_) {
      columns_ = {1, 2, 3};
    }
    may_count_ = !header_ && !labelled_ && width_ > 3;
  }

  void require_width(const XyzFields& fields) const {
    // A spreadsheet leaves out empty fields at the end of a line. Here, the empty field is a height
    // that was not measured.
    const bool short_of_height = dialect_.separator != ' ' && fields.count + 1 == width_;
    if (fields.count == width_ || short_of_height) return;
    refuse(name_,
           lines_.number(),
           fmt::format("has {} numbers, but the first point has {}", fields.count, width_),
           "give the same number on each line");
  }

  [[nodiscard]] double value_of(const XyzFields& fields, std::size_t column) const {
    const std::string_view field =
        column < fields.listed() ? fields.fields[column] : std::string_view{};
    if (const auto value = dialect_.number(field)) return *value;
    refuse(name_,
           lines_.number(),
           fmt::format("`{}` is not a number", shown(field)),
           "correct it, or mark comments with #");
  }

  void add(const std::array<double, 4>& values) {
    if (table_.points.size() >= kMaxPoints) {
      refuse(name_, lines_.number(), "too many points", "thin them out");
    }
    if (blank_ && !table_.points.empty()) table_.breaks.push_back(table_.points.size());
    blank_ = false;
    table_.points.emplace_back(values[0], values[1], values[2]);
    table_.lines.push_back(static_cast<std::uint32_t>(lines_.number()));
    if (may_count_) fourth_.push_back(values[3]);
  }

  /// Returns whether the first column numbers the points: there are four or more columns, and the
  /// value in the first column increases by one from point to point.
  [[nodiscard]] bool counts_points() const {
    if (!may_count_ || table_.points.size() < 2) return false;
    for (std::size_t i = 1; i < table_.points.size(); ++i) {
      if (table_.points[i].x() != table_.points[i - 1].x() + 1.0) return false;
    }
    return true;
  }

  void drop_point_numbers() {
    for (std::size_t i = 0; i < table_.points.size(); ++i) {
      table_.points[i] = {table_.points[i].y(), table_.points[i].z(), fourth_[i]};
    }
    table_.notes.push_back(
        fmt::format("{}: the first column counts the points and is left out", name_));
  }

  const std::string& name_;
  TextLines lines_;
  XyzDialect dialect_;
  XyzTable table_;
  bool blank_ = false;
  std::size_t header_lines_ = 0;
  std::size_t header_fields_ = 0;
  std::optional<XyzColumns> header_;  ///< Columns of X, Y and Z according to the last header line.
  std::size_t width_ = 0;             ///< Number of fields of each line; 0 before the first point.
  /// Whether the first field of each line contains the name of the point.
  bool labelled_ = false;
  /// Whether the first field of each line may contain the number of the point.
  bool may_count_ = false;
  XyzColumns columns_{0, 1, 2};
  std::vector<double> fourth_;  ///< Fourth field of each line; used only if may_count_.
};

}  // namespace

XyzTable read_xyz_table(std::string_view text, const std::string& name) {
  return XyzTableReader{text, name}.read();
}

}  // namespace sim::surface
