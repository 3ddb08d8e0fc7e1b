#include "host-sim/machine/machine_reading.hpp"

#include <utility>

#include "host-sim/measure/driven_path.hpp"

namespace sim {
namespace {

ReadOptions reading_options(const cnc::Settings& settings,
                            KerfQuestion& kerf,
                            FiveAxisQuestion& five_axes) {
  ReadOptions options = read_options_for(settings);
  options.on_statement = [&kerf, &five_axes](std::string_view statement) {
    kerf.hear(statement);
    five_axes.hear(statement);
  };
  options.tool_centre = [&five_axes](const Point& place, double tool_length_mm, bool begins) {
    return begins ? five_axes.program_for(place, tool_length_mm)
                  : five_axes.axes_for(place, tool_length_mm);
  };
  options.kerf_width = [&kerf](const CutCondition& condition) { return kerf.width(condition); };
  return options;
}

ReadOptions with_sink(ReadOptions options, BesideWay& beside) {
  options.on_piece = [&beside](const PathPiece& piece) { beside.put(piece); };
  return options;
}

}  // namespace

ProgrammedPath read_for_machine(const std::string& text, const cnc::Settings& settings) {
  KerfQuestion kerf{settings};
  FiveAxisQuestion five_axes{settings};
  return beside_path(read_program(text, reading_options(settings, kerf, five_axes)));
}

MachineReading::MachineReading(const cnc::Settings& settings, PieceSink sink)
    : kerf_{settings},
      five_axes_{settings},
      beside_{std::move(sink)},
      reader_{with_sink(reading_options(settings, kerf_, five_axes_), beside_)} {}

}  // namespace sim
