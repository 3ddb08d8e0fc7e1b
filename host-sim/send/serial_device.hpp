#pragma once

#include <string>

#include "hal/host/descriptor.hpp"

namespace sim {

/// A serial port, raw, 8N1, non-blocking, for this process alone. Throws std::system_error naming
/// the device, std::invalid_argument for a rate that no port has.
[[nodiscard]] hal::host::Descriptor open_serial_device(const std::string& device, unsigned baud);

}  // namespace sim
