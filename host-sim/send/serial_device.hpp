#pragma once

#include <string>

#include "hal/host/descriptor.hpp"

namespace sim {

/// Opens a serial port: raw, 8N1, non-blocking, for this process alone. Throws std::system_error
/// naming the device, or std::invalid_argument for a baud rate that no port has.
[[nodiscard]] hal::host::Descriptor open_serial_device(const std::string& device, unsigned baud);

}  // namespace sim
