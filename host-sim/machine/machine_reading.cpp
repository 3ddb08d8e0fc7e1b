#include "host-sim/machine/machine_reading.hpp"

#include "host-sim/machine/kerf_question.hpp"
#include "host-sim/measure/beside_path.hpp"
#include "host-sim/measure/driven_path.hpp"

namespace sim {

ProgrammedPath read_for_machine(const std::string& text, const cnc::Settings& settings) {
  KerfQuestion kerf{settings};
  ReadOptions options = read_options_for(settings);
  options.on_statement = [&kerf](std::string_view statement) { kerf.hear(statement); };
  options.kerf_width = [&kerf](const CutCondition& condition) { return kerf.width(condition); };
  return beside_path(read_program(text, options));
}

}  // namespace sim
