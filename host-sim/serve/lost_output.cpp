#include "host-sim/serve/lost_output.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "host-sim/report/printable.hpp"

namespace sim {

void report_lost_output(std::string_view option, const std::system_error& reason) {
  fmt::print(stderr,
             "kerfline: {}: {}; the machine goes on without it\n",
             option,
             printable(reason.what()));
}

}  // namespace sim
