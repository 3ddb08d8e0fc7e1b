#pragma once

#include <sys/types.h>

#include <string>

namespace hal::host {

/// Call system functions that are declared with an ellipsis. On failure they return -1 and set
/// errno.
[[nodiscard]] int open_file(const std::string& path, int flags, ::mode_t mode = 0);
[[nodiscard]] int control_file(int descriptor, int command, int argument = 0);

}  // namespace hal::host
