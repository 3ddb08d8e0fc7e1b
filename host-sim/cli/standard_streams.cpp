#include "host-sim/cli/standard_streams.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <initializer_list>

#include "hal/host/system_call.hpp"
#include "host-sim/report/printable.hpp"

namespace sim {

void prepare_standard_streams() {
  for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (hal::host::control_file(number, F_GETFD) >= 0) continue;
    // Opening /dev/null in the opposite direction yields a stream whose use fails. The stream gets
    // the lowest free number, which is the number of the closed stream.
    const int mode = number == STDIN_FILENO ? O_WRONLY : O_RDONLY;
    if (hal::host::open_file("/dev/null", mode) != number) ::_exit(2);
  }
  static_cast<void>(std::signal(SIGPIPE, SIG_IGN));
  static_cast<void>(std::signal(SIGXFSZ, SIG_IGN));
}

bool standard_output_failed() { return std::ferror(stdout) != 0; }

bool finish_standard_output(int reason) {
  const bool failed_before = standard_output_failed();
  errno = 0;
  if (std::fflush(stdout) == 0 && !failed_before) return true;
  if (reason == 0) reason = errno;
  print_error(fmt::format("standard output: {}",
                          reason == 0 ? "not all was written" : std::strerror(reason))
                  .c_str());
  return false;
}

void print_error(const char* reason) {
  static_cast<void>(
      std::fputs(fmt::format("kerfline: {}\n", printable_line(reason)).c_str(), stderr));
}

}  // namespace sim
