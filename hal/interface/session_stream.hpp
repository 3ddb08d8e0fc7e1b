#pragma once

#include <cstdint>

#include "hal/interface/byte_stream.hpp"

namespace hal {

/// A stream that reports whether a host is connected. USB can report this; a pair of wires cannot.
/// Main loop context.
class SessionStream : public ByteStream {
 public:
  /// Returns the number of the present session; 0 if no host is connected. Each session has a new
  /// number, so the caller notices that a host closed and reopened the stream between two calls.
  /// Bytes from an earlier session are never read in a later session: the next read() drops them.
  /// Unsent bytes to an earlier session are dropped, too.
  [[nodiscard]] virtual std::uint32_t session() const = 0;

 protected:
  ~SessionStream() = default;
};

}  // namespace hal
