#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "host-sim/trace/output_file.hpp"
#include "host-sim/trace/trace_row.hpp"
#include "planner/base/axes.hpp"

namespace sim {

struct VcdOptions {
  /// How long a step pulse stays high. The rows do not carry it; 2 µs is what
  /// common drivers ask for and still falls before the next pulse at 200 kHz.
  std::uint64_t pulse_width_ns = 2'000;
  /// Motor positions before the first row, in steps.
  cnc::AxisArray<std::int32_t> start_position{};
};

/// Writes the edges of the trace as a Value Change Dump (IEEE 1364-2001, 18.2)
/// for logic-analyser viewers, 1 ns per tick (`--vcd FILE`).
///
/// | variable        | kind        | meaning                                     |
/// |-----------------|-------------|---------------------------------------------|
/// | `X.step` …      | wire        | rises at the row, falls a pulse width later |
/// | `X.dir` …       | wire        | 1 when the motor runs negative              |
/// | `X.position` …  | integer, 32 | motor position in steps                     |
/// | `duty`          | real        | beam or spindle output, 0…1                 |
///
/// A pulse that would still be high at the next step of its axis falls half way
/// between that step and the instant written before it. Direction changes are
/// written with the step they belong to; the set-up time is not shown. Errors
/// as in TraceWriter.
class VcdWriter final : public TraceSink {
 public:
  explicit VcdWriter(const std::string& path, const VcdOptions& options = {});

  void on_row(const TraceRow& row) override;
  void on_end(std::uint64_t time_ns) override;

 private:
  struct AxisState {
    std::int32_t position = 0;
    bool negative = false;
    std::optional<std::uint64_t> falls_at_ns;  ///< Set while `step` is high.
  };

  void write_declarations();
  void write_start_values();
  /// Lowers every pulse that ends at or before this time, in order of time.
  void lower_pulses_until(std::uint64_t time_ns);
  void lower(std::size_t axis, std::uint64_t time_ns);
  /// Lowers the pulses that the row at this time would find still high.
  void shorten_pulses_of(const TraceRow& row);
  void write_step(std::size_t axis, std::int32_t position);
  void write_duty(float duty);
  void write_position(std::size_t axis);
  void write_time(std::uint64_t time_ns);
  void write_wire(bool high, char code);

  VcdOptions options_;
  OutputFile file_;
  std::uint64_t written_ns_ = 0;  ///< The last `#time` in the file.
  std::array<AxisState, cnc::kAxisCount> axes_{};
  float duty_ = 0.0F;
};

}  // namespace sim
