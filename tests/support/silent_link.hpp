#pragma once

#include "hal/interface/byte_stream.hpp"

namespace proof {

/// A link without a sender, for tests that call the machine directly.
class SilentLink final : public hal::ByteStream {
 public:
  [[nodiscard]] std::size_t read(std::span<std::byte>) override { return 0; }
  [[nodiscard]] std::size_t write(std::span<const std::byte> from) override { return from.size(); }
};

}  // namespace proof
