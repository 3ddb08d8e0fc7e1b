#pragma once

#include <cstdint>
#include <string_view>

namespace sim {

/// Returns the FNV-1a hash of 64 bits. It distinguishes texts, but gives no protection against
/// forged ones.
/// @param hash hash of the text before, which this text continues
[[nodiscard]] constexpr std::uint64_t text_hash(std::string_view text,
                                                std::uint64_t hash = 0xCBF29CE484222325) {
  constexpr std::uint64_t kPrime = 0x100000001B3;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * kPrime;
  return hash;
}

}  // namespace sim
