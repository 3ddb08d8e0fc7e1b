#pragma once

#include "hal/interface/byte_stream.hpp"

namespace sim {

/// A link whose other end is in the same thread. Therefore it can report whether a byte waits.
class KnownLink : public hal::ByteStream {
 public:
  /// Returns whether read() would return a byte.
  [[nodiscard]] virtual bool has_byte() const = 0;

 protected:
  ~KnownLink() = default;
};

}  // namespace sim
