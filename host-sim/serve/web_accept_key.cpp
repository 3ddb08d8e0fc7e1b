#include "host-sim/serve/web_accept_key.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace sim {
namespace {

constexpr std::string_view kFixedText = "258EAFA5-E914-47DA-95CA-C5AB0DC85B11";
constexpr std::size_t kBlockBytes = 64;
constexpr std::size_t kRounds = 80;

using Sha1State = std::array<std::uint32_t, 5>;

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i) word = word << 8 | static_cast<unsigned char>(bytes[at + i]);
  return word;
}

struct RoundTerms {
  std::uint32_t mixed;
  std::uint32_t constant;
};

/// The function and the constant of a round (FIPS 180-4, 4.1.1 and 4.2.1).
RoundTerms terms_of(std::size_t round, const Sha1State& state) {
  const auto [a, b, c, d, e] = state;
  if (round < 20) return {(b & c) ^ (~b & d), 0x5A82'7999};
  if (round < 40) return {b ^ c ^ d, 0x6ED9'EBA1};
  if (round < 60) return {(b & c) ^ (b & d) ^ (c & d), 0x8F1B'BCDC};
  return {b ^ c ^ d, 0xCA62'C1D6};
}

void take_block(std::string_view block, Sha1State& sum) {
  std::array<std::uint32_t, kRounds> words{};
  for (std::size_t i = 0; i < 16; ++i) words[i] = word_at(block, 4 * i);
  for (std::size_t i = 16; i < kRounds; ++i) {
    words[i] = std::rotl(words[i - 3] ^ words[i - 8] ^ words[i - 14] ^ words[i - 16], 1);
  }
  Sha1State state = sum;
  for (std::size_t round = 0; round < kRounds; ++round) {
    const RoundTerms terms = terms_of(round, state);
    const std::uint32_t next =
        std::rotl(state[0], 5) + terms.mixed + state[4] + terms.constant + words[round];
    state = {next, state[0], std::rotl(state[1], 30), state[2], state[3]};
  }
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += state[i];
}

std::string sha1_of(std::string text) {
  const std::uint64_t bits = 8 * std::uint64_t{text.size()};
  text += '\x80';
  while (text.size() % kBlockBytes != kBlockBytes - 8) text += '\0';
  for (int shift = 56; shift >= 0; shift -= 8) {
    text += static_cast<char>(bits >> static_cast<unsigned>(shift));
  }
  Sha1State sum{0x6745'2301, 0xEFCD'AB89, 0x98BA'DCFE, 0x1032'5476, 0xC3D2'E1F0};
  for (std::size_t at = 0; at < text.size(); at += kBlockBytes) {
    take_block(std::string_view{text}.substr(at, kBlockBytes), sum);
  }
  std::string digest;
  for (const std::uint32_t word : sum) {
    for (unsigned shift = 32; shift > 0; shift -= 8)
      digest += static_cast<char>(word >> (shift - 8));
  }
  return digest;
}

std::string base64_of(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - at);
    std::uint32_t group = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      group = group << 8 | (i < count ? static_cast<unsigned char>(bytes[at + i]) : 0U);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      text += i <= count ? kDigits[group >> (18 - 6 * i) & 0x3FU] : '=';
    }
  }
  return text;
}

}  // namespace

std::string web_accept_key(std::string_view client_key) {
  return base64_of(sha1_of(std::string{client_key}.append(kFixedText)));
}

}  // namespace sim
