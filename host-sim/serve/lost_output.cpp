#include "host-sim/serve/lost_output.hpp"

#include <cstdio>

#include "host-sim/report/terminal.hpp"

namespace sim {

void report_lost_output(std::string_view option, const std::system_error& reason) {
  terminal::print(
      stderr, "kerfline: {}: {}; the machine continues without this file\n", option, reason.what());
}

}  // namespace sim
