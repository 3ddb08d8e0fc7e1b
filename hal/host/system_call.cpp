#include "hal/host/system_call.hpp"

#include <fcntl.h>

namespace hal::host {

int open_file(const std::string& path, int flags, ::mode_t mode) {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): that is how open is declared.
  return ::open(path.c_str(), flags, mode);
}

int control_file(int descriptor, int command, int argument) {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): that is how fcntl is declared.
  return ::fcntl(descriptor, command, argument);
}

}  // namespace hal::host
