#include "host-sim/knowledge/experiment_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

namespace sim {
namespace {

enum Column : std::size_t {
  kMaterial,
  kLaser,
  kGasPressure,
  kThickness,
  kPower,
  kSpeed,
  kKerfTop,
  kKerfBottom,
  kDross,
  kStraightness,
  kColumnCount,
};

/// Range of the numbers in a column.
struct ColumnRange {
  std::string_view name;
  double least;
  double most;
};

constexpr std::array<ColumnRange, kColumnCount> kColumns{{
    {"material", 0, 0},
    {"laser", 0, 0},
    {"gas_pressure_mpa", 0, 10},
    {"thickness_mm", 0.001, cnc::kerf::kMaxThicknessUm / 1e3},
    {"power_w", 0.001, cnc::kerf::kMaxPowerMw / 1e3},
    {"speed_mm_min", cnc::kerf::kMinSpeedUmMin / 1e3, cnc::kerf::kMaxSpeedUmMin / 1e3},
    {"kerf_top_mm", 0, cnc::kerf::kMaxKerfNm / 1e6},
    {"kerf_bottom_mm", 0, cnc::kerf::kMaxKerfNm / 1e6},
    {"dross_area_mm2", 0, 1e6},
    {"straightness_mm", 0, 1e3},
}};

using Fields = std::vector<std::string>;

std::string_view trimmed_field(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// Returns a line without its CR; empty if the line is blank. Tabs are kept, because they may
/// separate fields.
std::string_view without_return(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  return trimmed_field(line).empty() ? std::string_view{} : line;
}

class CsvReader {
 public:
  CsvReader(const std::string& file, const std::string& laser) : file_{file}, laser_{laser} {}

  ExperimentFile read(std::string_view text) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
    ExperimentFile found;
    while (!text.empty()) {
      const std::size_t end = text.find('\n');
      const std::string_view line = without_return(text.substr(0, end));
      text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
      ++line_;
      if (line.empty() || line.front() == '#' || is_separator_line(line)) continue;
      if (!has_header_) choose_separator(line);
      const Fields fields = without_empty_end(split(line), has_header_ ? width_ : 0);
      if (std::ranges::all_of(fields, &std::string::empty)) continue;
      if (!has_header_) {
        read_header(fields);
      } else if (is_unmeasured(fields)) {
        ++found.unmeasured;
      } else {
        found.cuts.push_back(read_cut(fields));
      }
    }
    if (!has_header_) fail(fmt::format("no header; it is: {}", kExperimentHeader));
    if (found.cuts.empty() && found.unmeasured != 0) {
      fail("no line has a measurement; fill in kerf_top_mm and kerf_bottom_mm");
    }
    if (found.cuts.empty()) fail("no test cut below the header");
    return found;
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw std::invalid_argument(
        fmt::format("{}:{}: {}", file_, std::max<std::size_t>(line_, 1), reason));
  }
  [[noreturn]] void fail(std::string_view column, const std::string& reason) const {
    fail(fmt::format("column {}: {}", column, reason));
  }

  /// Returns whether a line names the separator, as in `sep=;`. Some spreadsheets write such a line
  /// first.
  bool is_separator_line(std::string_view line) const {
    return !has_header_ && line.size() == 5 && line.starts_with("sep=");
  }

  /// Chooses the separator of fields by the header, because spreadsheets write semicolons if the
  /// decimal mark is a comma.
  void choose_separator(std::string_view header) {
    for (const char candidate : {';', '\t'}) {
      if (std::ranges::count(header, candidate) > std::ranges::count(header, separator_)) {
        separator_ = candidate;
      }
    }
  }

  /// Removes empty fields at the end of a line, because spreadsheets may write separators for
  /// columns without content.
  static Fields without_empty_end(Fields fields, std::size_t width) {
    while (fields.size() > std::max<std::size_t>(width, 1) && fields.back().empty()) {
      fields.pop_back();
    }
    return fields;
  }

  /// Splits a line. A separator within quotes is text, and two quotes within quotes stand for one.
  Fields split(std::string_view line) const {
    Fields fields{""};
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
      const bool twice = quoted && line[i] == '"' && i + 1 < line.size() && line[i + 1] == '"';
      if (twice) {
        fields.back() += line[i++];
      } else if (line[i] == '"') {
        quoted = !quoted;
      } else if (line[i] == separator_ && !quoted) {
        fields.emplace_back();
      } else {
        fields.back() += line[i];
      }
    }
    if (quoted) fail("a quotation mark is not closed");
    for (std::string& field : fields) field = std::string{trimmed_field(field)};
    return fields;
  }

  void read_header(const Fields& fields) {
    has_header_ = true;
    place_.fill(fields.size());
    width_ = fields.size();
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const auto* const found =
          std::find_if(kColumns.begin(), kColumns.end(), [&](const ColumnRange& column) {
            return column.name == fields[i];
          });
      if (found == kColumns.end()) {
        fail(fields[i], fmt::format("unknown; the header is: {}", kExperimentHeader));
      }
      std::size_t& place = place_[static_cast<std::size_t>(found - kColumns.begin())];
      if (place != width_) fail(fields[i], "occurs twice; remove one");
      place = i;
    }
    for (std::size_t column = 0; column < kColumnCount; ++column) {
      if (place_[column] == width_) {
        fail(kColumns[column].name, "is missing in the header");
      }
    }
  }

  [[nodiscard]] bool is_unmeasured(const Fields& fields) const {
    if (fields.size() != width_) return false;
    return std::ranges::all_of(std::array{kKerfTop, kKerfBottom, kDross, kStraightness},
                               [&](Column column) { return fields[place_[column]].empty(); });
  }

  std::string text_of(const Fields& fields, Column column) const {
    const std::string& text = fields[place_[column]];
    if (text.empty()) fail(kColumns[column].name, "is empty");
    return text;
  }

  double number_of(const Fields& fields, Column column) const {
    const ColumnRange& range = kColumns[column];
    std::string text = text_of(fields, column);
    if (separator_ != ',' && text.find('.') == std::string::npos) {
      std::ranges::replace(text, ',', '.');
    }
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, value);
    if (result.ec != std::errc{} || result.ptr != end || !std::isfinite(value)) {
      fail(range.name, fmt::format("`{}` is not a number", text));
    }
    if (value < range.least || value > range.most) {
      fail(range.name,
           fmt::format("{:g} is out of range, {:g} to {:g}", value, range.least, range.most));
    }
    return value;
  }

  std::optional<double> number_or_none(const Fields& fields, Column column) const {
    if (fields[place_[column]].empty()) return std::nullopt;
    return number_of(fields, column);
  }

  Experiment read_cut(const Fields& fields) const {
    if (fields.size() != width_) {
      fail(fmt::format("{} fields, the header has {}", fields.size(), width_));
    }
    Experiment cut;
    cut.material = text_of(fields, kMaterial);
    if (!cnc::kerf::fits_name(cut.material)) {
      fail(kColumns[kMaterial].name,
           fmt::format("`{}`: a name has 1 to {} letters, digits, blanks and - _ . /",
                       cut.material,
                       cnc::kerf::kLongestName));
    }
    cut.laser = fields[place_[kLaser]];
    if (cut.laser.empty()) cut.laser = laser_;
    cut.gas_pressure_mpa = number_of(fields, kGasPressure);
    cut.condition = {to_thousandths(number_of(fields, kThickness)),
                     to_thousandths(number_of(fields, kPower)),
                     to_thousandths(number_of(fields, kSpeed))};
    cut.kerf_top_mm = number_of(fields, kKerfTop);
    cut.kerf_bottom_mm = number_of(fields, kKerfBottom);
    cut.dross_area_mm2 = number_or_none(fields, kDross);
    cut.straightness_mm = number_or_none(fields, kStraightness);
    cut.file = file_;
    cut.line = line_;
    return cut;
  }

  const std::string& file_;
  const std::string& laser_;
  std::size_t line_ = 0;
  char separator_ = ',';
  bool has_header_ = false;
  std::size_t width_ = 0;
  std::array<std::size_t, kColumnCount> place_{};
};

}  // namespace

ExperimentFile read_experiment_file(std::string_view text,
                                    const std::string& file,
                                    const std::string& laser) {
  return CsvReader{file, laser}.read(text);
}

std::vector<Experiment> read_experiments(std::string_view text, const std::string& file) {
  return read_experiment_file(text, file).cuts;
}

}  // namespace sim
