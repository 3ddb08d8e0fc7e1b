#include "host-sim/engrave/engrave_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace sim::engrave {
namespace {

using drawing::Place;

/// Least length of a run of one power that gets a separate line, pixels.
constexpr std::size_t kLongRun = 6;
/// Greatest number of powers in one line (a controller accepts 64), and greatest number of
/// characters of these powers (a controller accepts lines of 256 characters).
constexpr std::size_t kMaxPowers = 48;
constexpr std::size_t kMaxPowerText = 200;

std::string trimmed_number(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" ? "0" : text;
}

/// Writes the rows of a raster one after another.
class RowWriter {
 public:
  RowWriter(const BurnRaster& raster,
            const EngraveSettings& settings,
            const cnc::order::RapidLimits& limits)
      : raster_{raster}, settings_{settings}, rapid_{limits} {}

  void write(std::size_t row) {
    const auto [first, end] = burnt_columns(row);
    if (first == end) return;
    const bool is_backwards = !settings_.is_one_way && figures_.rows % 2 == 1;
    way_ = is_backwards ? -1.0 : 1.0;
    const double y = settings_.at_mm.y() + (static_cast<double>(row) + 0.5) * raster_.interval_mm;
    const std::size_t from = is_backwards ? end : first;
    const std::size_t to = is_backwards ? first : end;
    go_to({x_of(from) - way_ * settings_.overscan_mm, y});
    motion(from, "0");
    texts_.clear();
    for (std::size_t i = first; i < end; ++i) {
      const std::size_t column = is_backwards ? first + end - 1 - i : i;
      texts_.push_back(power_text(raster_.at(column, row)));
    }
    write_pixels(from);
    const double last = x_of(to) + way_ * settings_.overscan_mm;
    if (settings_.overscan_mm > 0.0) line(last, "0");
    rows_.push_back({y, x_of(from) - way_ * settings_.overscan_mm, x_of(from), x_of(to), last});
    ++figures_.rows;
  }

  EngravedRows finish() && {
    if (!text_.empty() && settings_.overscan_mm <= 0.0) text_ += "S0\n";
    figures_.lines = static_cast<std::size_t>(std::ranges::count(text_, '\n'));
    return {std::move(text_), figures_, std::move(rows_)};
  }

 private:
  /// Returns the first burnt column of a row, and the column after the last burnt column.
  [[nodiscard]] std::pair<std::size_t, std::size_t> burnt_columns(std::size_t row) const {
    std::size_t first = 0;
    std::size_t end = raster_.columns;
    while (first < end && raster_.at(first, row) <= 0.0F) ++first;
    while (end > first && raster_.at(end - 1, row) <= 0.0F) --end;
    return {first, end};
  }

  /// Returns the X coordinate of the left side of a column.
  [[nodiscard]] double x_of(std::size_t column) const {
    const double shift = way_ < 0.0 ? settings_.reverse_shift_mm : 0.0;
    return settings_.at_mm.x() + static_cast<double>(column) * raster_.pixel_mm + shift;
  }

  [[nodiscard]] std::string power_text(float power) const {
    return trimmed_number(static_cast<double>(power) * settings_.full_power_s, 1);
  }

  void go_to(const Place& place) {
    const int decimals = settings_.decimals;
    text_ += fmt::format(
        "G0X{}Y{}\n", trimmed_number(place.x(), decimals), trimmed_number(place.y(), decimals));
    const Place way = place - here_;
    figures_.estimated_s += rapid_(way.x(), way.y());
    note(place);
    is_rapid_ = true;
  }

  void note(const Place& place) {
    here_ = place;
    const bool is_first = figures_.rows == 0 && !has_place_;
    figures_.low = is_first ? place : Place{figures_.low.cwiseMin(place)};
    figures_.high = is_first ? place : Place{figures_.high.cwiseMax(place)};
    has_place_ = true;
  }

  void motion(std::size_t column, const std::string& power) { line(x_of(column), power); }

  void line(double x, const std::string& power) {
    if (x == here_.x()) return;
    text_ += fmt::format("{}X{}", is_rapid_ ? "G1" : "", trimmed_number(x, settings_.decimals));
    if (!has_feed_) text_ += fmt::format("F{}", trimmed_number(settings_.feed_mm_min, 3));
    text_ += fmt::format("S{}\n", power);
    has_feed_ = true;
    is_rapid_ = false;
    const double length = std::abs(x - here_.x());
    figures_.estimated_s += 60.0 * length / settings_.feed_mm_min;
    if (power != "0") figures_.burnt_mm += length;
    note({x, here_.y()});
  }

  [[nodiscard]] std::size_t run_at(std::size_t index) const {
    std::size_t end = index + 1;
    while (end < texts_.size() && texts_[end] == texts_[index]) ++end;
    return end - index;
  }

  void write_pixels(std::size_t from) {
    for (std::size_t i = 0; i < texts_.size();) {
      const std::size_t run = run_at(i);
      if (settings_.is_plain || run >= kLongRun) {
        motion(column_of(from, i + run), texts_[i]);
        i += run;
        continue;
      }
      const std::size_t end = end_of_cluster(i);
      write_cluster(from, i, end);
      i = end;
    }
  }

  [[nodiscard]] std::size_t column_of(std::size_t from, std::size_t index) const {
    return way_ < 0.0 ? from - index : from + index;
  }

  /// Returns the index after the last pixel that fits into the line which begins at `begin`. The
  /// line ends earlier at a long run.
  [[nodiscard]] std::size_t end_of_cluster(std::size_t begin) const {
    std::size_t end = begin;
    std::size_t characters = 0;
    while (end < texts_.size() && end - begin < kMaxPowers && characters < kMaxPowerText) {
      const std::size_t run = run_at(end);
      if (run >= kLongRun) break;
      for (std::size_t k = 0; k < run && end - begin < kMaxPowers; ++k) {
        characters += texts_[end].size() + 1;
        ++end;
      }
    }
    return end;
  }

  void write_cluster(std::size_t from, std::size_t begin, std::size_t end) {
    std::string powers;
    double burnt_mm = figures_.burnt_mm;
    for (std::size_t i = begin; i < end; ++i) {
      if (i > begin) powers += ':';
      powers += texts_[i];
      if (texts_[i] != "0") burnt_mm += raster_.pixel_mm;
    }
    motion(column_of(from, end), powers);
    figures_.burnt_mm = burnt_mm;
  }

  const BurnRaster& raster_;
  const EngraveSettings& settings_;
  cnc::order::RapidTime rapid_;
  EngraveFigures figures_;
  std::string text_;
  std::vector<EngravedRow> rows_;
  std::vector<std::string> texts_;  ///< Powers of the row's pixels, in the order of the motion.
  Place here_{0.0, 0.0};
  double way_ = 1.0;  ///< Direction of the row: 1 to the right, -1 to the left.
  bool has_place_ = false;
  bool has_feed_ = false;
  bool is_rapid_ = false;  ///< Whether the last line was a G0.
};

}  // namespace

std::optional<EngravedRows> engrave_rows(const BurnRaster& raster,
                                         const EngraveSettings& settings,
                                         const cnc::order::RapidLimits& limits) {
  RowWriter writer{raster, settings, limits};
  for (std::size_t row = 0; row < raster.rows; ++row) writer.write(row);
  EngravedRows rows = std::move(writer).finish();
  if (rows.rows.empty()) return std::nullopt;
  return rows;
}

std::optional<EngraveProgram> engrave_program(const BurnRaster& raster,
                                              const EngraveSettings& settings,
                                              const cnc::order::RapidLimits& limits,
                                              const std::vector<std::string>& heading) {
  const std::optional<EngravedRows> rows = engrave_rows(raster, settings, limits);
  if (!rows) return std::nullopt;
  EngraveProgram program{{}, rows->figures};
  for (const std::string& line : heading) program.text += line;
  program.text += "G21 G90 G17 G94 G54\n";
  if (!settings.air.empty()) program.text += settings.air + "\n";
  program.text += settings.follows_speed ? "M4 S0\n" : "M3 S0\n";
  program.text += rows->text;
  program.text += settings.air.empty() ? "M5\n" : "M5\nM9\n";
  program.text += "G0X0Y0\nM2\n";
  return program;
}

}  // namespace sim::engrave
