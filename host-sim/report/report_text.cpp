#include "host-sim/report/report_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host-sim/report/duration_text.hpp"
#include "host-sim/report/printable.hpp"
#include "host-sim/report/stock_text.hpp"
#include "host-sim/report/terminal.hpp"
#include "host-sim/report/text_table.hpp"
#include "host-sim/report/utf8.hpp"

namespace sim {
namespace {

constexpr std::string_view kBold = "\033[1m";
constexpr std::string_view kYellow = "\033[33m";
constexpr std::string_view kRed = "\033[31m";

std::string styled(std::string_view text, std::string_view style, bool colour) {
  return colour ? fmt::format("{}{}\033[0m", style, text) : std::string{text};
}

/// Returns a jerk or an acceleration as text. Their values span decades. Therefore values from 100
/// on have no decimals, and smaller values have one.
std::string rate_text(double value) { return fmt::format("{:.{}f}", value, value < 100.0 ? 1 : 0); }

void add_fact(std::string& out, std::string_view name, std::string_view value) {
  out += "  " + pad_right(name, 11) + std::string{value} + "\n";
}

std::string facts_text(const Report& report) {
  std::string out;
  add_fact(out, "time", duration_text(report.job_time_s));
  add_fact(
      out,
      "path",
      fmt::format("{:.1f} mm, {:.1f} mm of it cut", report.path_length_mm, report.cut_length_mm));
  add_fact(out, "program", fmt::format("{} lines, {} blocks", report.lines, report.blocks));
  add_fact(out,
           "deviation",
           fmt::format("{:.4f} mm at {}",
                       report.max_path_deviation_mm,
                       duration_text(report.max_path_deviation_at_s)));
  if (report.max_shaping_error_mm > 0.0) {
    add_fact(out, "shaping", fmt::format("{:.4f} mm off the path", report.max_shaping_error_mm));
  }
  if (std::isfinite(report.mean_energy_ratio)) {
    add_fact(out,
             "energy/mm",
             fmt::format("{:.3f} to {:.3f} of programmed, {:.3f} on average",
                         report.min_energy_ratio,
                         report.greatest_energy_ratio,
                         report.mean_energy_ratio));
  }
  if (report.tip) {
    const TipReport& tip = *report.tip;
    add_fact(out,
             "tip",
             fmt::format("X {:.3f} to {:.3f}, Y {:.3f} to {:.3f}, Z {:.3f} to {:.3f} mm, tilted up "
                         "to {:.2f} deg",
                         tip.min_mm[0],
                         tip.greatest_mm[0],
                         tip.min_mm[1],
                         tip.greatest_mm[1],
                         tip.min_mm[2],
                         tip.greatest_mm[2],
                         tip.greatest_tilt_deg));
  }
  if (report.stock) {
    for (const auto& [name, value] : stock_facts(*report.stock)) add_fact(out, name, value);
  }
  return out;
}

void add_axis_row(TextTable& table, char letter, const AxisReport& axis) {
  table.add_row({std::string{letter},
                 fmt::format("{:.3f}", axis.min_mm),
                 fmt::format("{:.3f}", axis.greatest_mm),
                 fmt::format("{}", axis.steps),
                 fmt::format("{:.2f}", axis.max_speed_mm_s),
                 fmt::format("{:.0f}", 60.0 * axis.max_speed_mm_s),
                 rate_text(axis.max_acceleration_mm_s2),
                 rate_text(axis.max_jerk_mm_s3)});
}

bool is_rotary(std::size_t axis) { return axis >= cnc::kLinearAxisCount; }

/// Returns a line with the possible measuring errors of the figures in a table. Each error is the
/// greatest of all axes in the table.
std::string errors_text(const Report& report, bool rotary, const char* unit) {
  AxisReport most;
  for (std::size_t i = 0; i < cnc::kAxisCount; ++i) {
    if (is_rotary(i) != rotary) continue;
    const AxisReport& axis = report.axes[i];
    most.speed_error_mm_s = std::max(most.speed_error_mm_s, axis.speed_error_mm_s);
    most.acceleration_error_mm_s2 =
        std::max(most.acceleration_error_mm_s2, axis.acceleration_error_mm_s2);
    most.jerk_error_mm_s3 = std::max(most.jerk_error_mm_s3, axis.jerk_error_mm_s3);
    most.bounds_error_mm = std::max(most.bounds_error_mm, axis.bounds_error_mm);
  }
  if (most.speed_error_mm_s == 0.0) return "";
  return fmt::format(
      "  read from steps: up to {:.2f} {}/s, {} {}/s² and {} {}/s³ may be measuring errors, "
      "positions are within {:.4f} {}\n",
      most.speed_error_mm_s,
      unit,
      rate_text(most.acceleration_error_mm_s2),
      unit,
      rate_text(most.jerk_error_mm_s3),
      unit,
      most.bounds_error_mm,
      unit);
}

/// Returns a table of the linear or of the rotary axes that moved; an empty text if none of them
/// moved.
std::string axes_text(const Report& report, bool rotary, bool colour) {
  const char* unit = rotary ? "deg" : "mm";
  TextTable table{{{"axis", TextTable::Align::kLeft},
                   {fmt::format("from {}", unit)},
                   {fmt::format("to {}", unit)},
                   {"steps"},
                   {fmt::format("{}/s", unit)},
                   {fmt::format("{}/min", unit)},
                   {fmt::format("{}/s²", unit)},
                   {fmt::format("{}/s³", unit)}}};
  bool has_moved = false;
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    if (is_rotary(axis) != rotary || report.axes[axis].steps == 0) continue;
    add_axis_row(table, cnc::kAxisLetters[axis], report.axes[axis]);
    has_moved = true;
  }
  if (!has_moved) return "";
  return "\n" + table.text(2, colour ? kBold : "") + errors_text(report, rotary, unit);
}

std::string messages_text(const Report& report, bool colour) {
  std::string out;
  for (const std::string& warning : report.warnings) {
    out += fmt::format("{} {}\n", styled("warning:", kYellow, colour), printable_line(warning));
  }
  for (const Fault& fault : report.faults) {
    out += fmt::format("{} {}\n", styled("fault:", kRed, colour), to_string(fault));
  }
  return out;
}

double greatest(const Report& report, double AxisReport::*value) {
  double result = 0.0;
  for (std::size_t axis = 0; axis < cnc::kLinearAxisCount; ++axis) {
    result = std::max(result, report.axes[axis].*value);
  }
  return result;
}

std::vector<std::string> summary_row(const Report& report) {
  return {report.job,
          duration_text(report.job_time_s),
          fmt::format("{:.1f}", report.path_length_mm),
          fmt::format("{:.1f}", report.cut_length_mm),
          fmt::format("{}", report.lines),
          fmt::format("{}", report.blocks),
          fmt::format("{:.0f}", 60.0 * greatest(report, &AxisReport::max_speed_mm_s)),
          rate_text(greatest(report, &AxisReport::max_acceleration_mm_s2)),
          fmt::format("{:.4f}", report.max_path_deviation_mm)};
}

}  // namespace

std::string to_string(const Fault& fault) {
  const std::string file = printable_line(fault.file);
  const std::string message = printable_line(fault.message);
  if (fault.column == 0) return fmt::format("{}:{}: {}", file, fault.line, message);
  return fmt::format("{}:{}:{}: {}", file, fault.line, fault.column, message);
}

std::string report_text(const Report& report, bool colour) {
  std::string out = styled(printable_line(report.job), kBold, colour) + "\n" + facts_text(report);
  for (const bool rotary : {false, true}) out += axes_text(report, rotary, colour);
  const std::string messages = messages_text(report, colour);
  return messages.empty() ? out : out + "\n" + messages;
}

std::string summary_text(std::span<const Report> reports, bool colour) {
  TextTable table{{{"job", TextTable::Align::kLeft},
                   {"time"},
                   {"path mm"},
                   {"cut mm"},
                   {"lines"},
                   {"blocks"},
                   {"mm/min"},
                   {"mm/s²"},
                   {"deviation mm"}}};
  std::string messages;
  for (const Report& report : reports) {
    table.add_row(summary_row(report));
    messages += messages_text(report, colour);
  }
  const std::string text = table.text(0, colour ? kBold : "");
  return messages.empty() ? text : text + "\n" + messages;
}

void print_table(std::FILE* stream, std::span<const Report> reports, bool colour) {
  const std::string text =
      reports.size() == 1 ? report_text(reports.front(), colour) : summary_text(reports, colour);
  terminal::print_styled(stream, text);
}

}  // namespace sim
