#include "host-sim/serve/served_trace.hpp"

#include <system_error>

#include "host-sim/serve/lost_output.hpp"

namespace sim {

ServedTrace::ServedTrace(const std::string& path, const cnc::AxisArray<float>& steps_per_mm)
    : file_{std::in_place, path, steps_per_mm} {}

template <typename Write>
void ServedTrace::attempt(Write&& write) {
  if (!file_) return;
  try {
    write(*file_);
  } catch (const std::system_error& error) {
    report_lost_output("--trace", error);
    file_.reset();
  }
}

void ServedTrace::on_row(const TraceRow& row) {
  attempt([&row](TraceWriter& file) { file.on_row(row); });
}

void ServedTrace::on_end(std::uint64_t time_ns) {
  attempt([time_ns](TraceWriter& file) { file.on_end(time_ns); });
}

}  // namespace sim
