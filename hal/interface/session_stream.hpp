#pragma once

#include <cstdint>

#include "hal/interface/byte_stream.hpp"

namespace hal {

/// A stream that knows whether somebody is at its other end, as USB does and a
/// pair of wires does not. Main loop context.
class SessionStream : public ByteStream {
 public:
  /// Who is there: 0 nobody; else a number that no one had before, so that a host
  /// that closed and opened again between two looks is told from one that stayed.
  /// What was received for an earlier session is never read in a later one: the next
  /// read() drops it. What was written to it and is not out is dropped, too.
  [[nodiscard]] virtual std::uint32_t session() const = 0;

 protected:
  ~SessionStream() = default;
};

}  // namespace hal
