#pragma once

#include <cstdint>

#include "hal/interface/byte_stream.hpp"

namespace hal {

/// A stream that knows whether a host is connected, as USB does and a pair of wires does not. Main
/// loop context.
class SessionStream : public ByteStream {
 public:
  /// Returns the number of the present session; 0 if no host is connected. Each session has a new
  /// number, so a host that closed and opened the stream between two calls is recognised. Bytes
  /// that were received in an earlier session are never read in a later one: the next read() drops
  /// them. Bytes that were written to an earlier session and not yet sent are dropped, too.
  [[nodiscard]] virtual std::uint32_t session() const = 0;

 protected:
  ~SessionStream() = default;
};

}  // namespace hal
