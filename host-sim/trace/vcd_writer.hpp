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
  /// Duration for which a step pulse stays high, ns. A trace does not contain it. Common drivers
  /// require 2 µs. At 200 kHz, such a pulse still falls before the next pulse.
  std::uint64_t pulse_width_ns = 2'000;
  /// Motor positions before the first row, steps.
  cnc::AxisArray<std::int32_t> start_position{};
};

/// Writes the edges of a trace as a Value Change Dump (IEEE 1364-2001, 18.2) for viewers of logic
/// analysers, with 1 ns per tick (`--vcd FILE`).
///
/// | variable        | kind        | meaning                                     |
/// |-----------------|-------------|---------------------------------------------|
/// | `X.step` …      | wire        | rises at the row, falls a pulse width later |
/// | `X.dir` …       | wire        | 1 when the motor runs negative              |
/// | `X.position` …  | integer, 32 | motor position in steps                     |
/// | `duty`          | real        | beam or spindle output, 0…1                 |
///
/// If a pulse would still be high at the next step of its axis, it falls earlier: in the middle
/// between the last written time and that step. A change of direction is written together with its
/// step, without a set-up time. Throws the exceptions of TraceWriter.
class VcdWriter final : public TraceSink {
 public:
  explicit VcdWriter(const std::string& path, const VcdOptions& options = {});

  void on_row(const TraceRow& row) override;
  void on_end(std::uint64_t time_ns) override;

 private:
  struct AxisState {
    std::int32_t position = 0;
    bool negative = false;
    /// Time at which `step` falls, ns; empty while `step` is low.
    std::optional<std::uint64_t> falls_at_ns;
  };

  void write_declarations();
  void write_start_values();
  /// Lowers every pulse that ends at or before this time, in order of time.
  void lower_pulses_until(std::uint64_t time_ns);
  void lower(std::size_t axis, std::uint64_t time_ns);
  /// Lowers the pulses that are still high at the time of the row if their axis steps in the row.
  void shorten_pulses_of(const TraceRow& row);
  void write_step(std::size_t axis, std::int32_t position);
  void write_duty(float duty);
  void write_position(std::size_t axis);
  void write_time(std::uint64_t time_ns);
  void write_wire(bool high, char code);

  VcdOptions options_;
  OutputFile file_;
  std::uint64_t written_ns_ = 0;  ///< The last `#time` in the file, ns.
  std::array<AxisState, cnc::kAxisCount> axes_{};
  float duty_ = 0.0F;
};

}  // namespace sim
