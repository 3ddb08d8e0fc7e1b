#include "host-sim/report/terminal.hpp"

#include <unistd.h>

namespace sim::terminal {

void print_lines(std::FILE* stream, std::string_view lines) {
  print_styled(stream, printable(lines));
}

void print_styled(std::FILE* stream, std::string_view lines) { fmt::print(stream, "{}", lines); }

void write_data(std::string_view data) {
  const bool is_read = ::isatty(::fileno(stdout)) == 1;
  is_read ? print_lines(stdout, data) : print_styled(stdout, data);
}

}  // namespace sim::terminal
