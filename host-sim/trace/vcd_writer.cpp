#include "host-sim/trace/vcd_writer.hpp"

#include <fmt/compile.h>

#include <algorithm>

namespace sim {
namespace {

// Return identifier codes for the step, the direction and the position of an axis. Codes are
// printable characters from `!` on, three for each axis.
constexpr char step_code(std::size_t axis) { return static_cast<char>('!' + 3 * axis); }
constexpr char dir_code(std::size_t axis) { return static_cast<char>('!' + 3 * axis + 1); }
constexpr char position_code(std::size_t axis) { return static_cast<char>('!' + 3 * axis + 2); }
constexpr char kDutyCode = static_cast<char>('!' + 3 * cnc::kAxisCount);

constexpr std::string_view kAxisDeclarations = R"($scope module {} $end
$var wire 1 {} step $end
$var wire 1 {} dir $end
$var integer 32 {} position $end
$upscope $end
)";

}  // namespace

VcdWriter::VcdWriter(const std::string& path, const VcdOptions& options)
    : options_{options}, file_{path} {
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    axes_[axis].position = options.start_position[axis];
  }
  write_declarations();
  write_start_values();
}

void VcdWriter::on_row(const TraceRow& row) {
  if (row.time_ns > 0) lower_pulses_until(row.time_ns - 1);
  shorten_pulses_of(row);
  lower_pulses_until(row.time_ns);
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    if (row.position[axis] == axes_[axis].position) continue;
    write_time(row.time_ns);
    write_step(axis, row.position[axis]);
  }
  if (row.duty != duty_) {
    write_time(row.time_ns);
    write_duty(row.duty);
  }
  file_.drain_when_full();
}

void VcdWriter::on_end(std::uint64_t time_ns) {
  lower_pulses_until(std::uint64_t{0} - 1);
  if (time_ns > written_ns_) write_time(time_ns);
  file_.close();
}

void VcdWriter::write_declarations() {
  const fmt::appender out{file_.buffer()};
  fmt::format_to(out, "$version Kerfline $end\n$timescale 1 ns $end\n");
  fmt::format_to(out, "$scope module kerfline $end\n");
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    fmt::format_to(out,
                   kAxisDeclarations,
                   cnc::kAxisLetters[axis],
                   step_code(axis),
                   dir_code(axis),
                   position_code(axis));
  }
  fmt::format_to(out, "$var real 64 {} duty $end\n", kDutyCode);
  fmt::format_to(out, "$upscope $end\n$enddefinitions $end\n");
}

void VcdWriter::write_start_values() {
  const fmt::appender out{file_.buffer()};
  fmt::format_to(out, "#0\n$dumpvars\n");
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    write_wire(false, step_code(axis));
    write_wire(false, dir_code(axis));
    write_position(axis);
  }
  write_duty(0.0F);
  fmt::format_to(out, "$end\n");
}

void VcdWriter::lower_pulses_until(std::uint64_t time_ns) {
  for (std::size_t pulses = 0; pulses < cnc::kAxisCount; ++pulses) {
    std::optional<std::size_t> first;
    for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
      const auto& falls_at_ns = axes_[axis].falls_at_ns;
      if (!falls_at_ns || *falls_at_ns > time_ns) continue;
      if (!first || *falls_at_ns < *axes_[*first].falls_at_ns) first = axis;
    }
    if (!first) return;
    lower(*first, *axes_[*first].falls_at_ns);
  }
}

void VcdWriter::lower(std::size_t axis, std::uint64_t time_ns) {
  write_time(time_ns);
  write_wire(false, step_code(axis));
  axes_[axis].falls_at_ns.reset();
}

void VcdWriter::shorten_pulses_of(const TraceRow& row) {
  const std::uint64_t half_way_ns = written_ns_ + (row.time_ns - written_ns_) / 2;
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    const bool steps_again = row.position[axis] != axes_[axis].position;
    if (steps_again && axes_[axis].falls_at_ns) lower(axis, half_way_ns);
  }
}

void VcdWriter::write_step(std::size_t axis, std::int32_t position) {
  AxisState& state = axes_[axis];
  const bool negative = position < state.position;
  if (negative != state.negative) write_wire(negative, dir_code(axis));
  state.negative = negative;
  state.position = position;
  state.falls_at_ns = written_ns_ + options_.pulse_width_ns;
  write_position(axis);
  write_wire(true, step_code(axis));
}

void VcdWriter::write_duty(float duty) {
  duty_ = duty;
  fmt::format_to(fmt::appender(file_.buffer()), FMT_COMPILE("r{} {}\n"), duty, kDutyCode);
}

// Writes the position in two's complement. Leading zeros are omitted, because a viewer adds them.
void VcdWriter::write_position(std::size_t axis) {
  const auto bits = static_cast<std::uint32_t>(axes_[axis].position);
  fmt::format_to(
      fmt::appender(file_.buffer()), FMT_COMPILE("b{:b} {}\n"), bits, position_code(axis));
}

void VcdWriter::write_time(std::uint64_t time_ns) {
  if (time_ns == written_ns_) return;
  written_ns_ = time_ns;
  fmt::format_to(fmt::appender(file_.buffer()), FMT_COMPILE("#{}\n"), time_ns);
}

void VcdWriter::write_wire(bool high, char code) {
  const std::array<char, 3> line{high ? '1' : '0', code, '\n'};
  file_.buffer().append(line.begin(), line.end());
}

}  // namespace sim
