#pragma once

#include <cstdint>
#include <string_view>

namespace sim {

/// Returns the 64-bit FNV-1a hash of a text. It distinguishes different texts, but does not protect
/// against deliberate collisions.
/// @param hash hash of the preceding text, if `text` continues it
[[nodiscard]] constexpr std::uint64_t text_hash(std::string_view text,
                                                std::uint64_t hash = 0xCBF29CE484222325) {
  constexpr std::uint64_t kPrime = 0x100000001B3;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * kPrime;
  return hash;
}

}  // namespace sim
