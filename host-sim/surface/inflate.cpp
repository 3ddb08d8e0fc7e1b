#include "host-sim/surface/inflate.hpp"

#include <boost/beast/zlib/inflate_stream.hpp>

#include "host-sim/surface/byte_reader.hpp"

namespace sim::surface {
namespace {

/// Bytes that one byte of deflate can become, at most (258 of two bits, and a margin).
constexpr std::size_t kMaxInflation = 1'100;
/// Header of two bytes and check sum of four.
constexpr std::size_t kZlibFrame = 6;

/// Returns the check sum Adler-32 of RFC 1950.
std::uint32_t adler_of(const std::vector<std::uint8_t>& bytes) {
  constexpr std::uint32_t kModulus = 65'521;
  constexpr std::size_t kRun = 5'000;  // So many bytes do not overflow 32 bits.
  std::uint32_t low = 1;
  std::uint32_t high = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    low += bytes[i];
    high += low;
    if (i % kRun == kRun - 1) {
      low %= kModulus;
      high %= kModulus;
    }
  }
  return high % kModulus << 16U | low % kModulus;
}

/// Returns whether the first two bytes are a header without a dictionary.
bool is_zlib_header(std::string_view stream) {
  ByteReader reader{stream, ByteOrder::kBigEndian};
  const auto header = reader.take<std::uint16_t>();
  return (header >> 8U & 0xFU) == 8 && header % 31 == 0 && (header & 0x20U) == 0;
}

}  // namespace

std::optional<std::vector<std::uint8_t>> inflated(std::string_view stream, std::size_t size) {
  namespace zlib = boost::beast::zlib;
  if (stream.size() < kZlibFrame || size / kMaxInflation > stream.size()) return {};
  if (!is_zlib_header(stream)) return {};
  // The inflater reads ahead of the last code by up to two bytes: those of the check sum.
  const std::string_view body = stream.substr(2);
  // One byte more, for which the inflater looks for the end of the stream.
  std::vector<std::uint8_t> bytes(size + 1);
  zlib::inflate_stream inflater;
  zlib::z_params state;
  state.next_in = body.data();
  state.avail_in = body.size();
  state.next_out = bytes.data();
  state.avail_out = bytes.size();
  boost::beast::error_code error;
  inflater.write(state, zlib::Flush::finish, error);
  if (error != zlib::error::end_of_stream || state.avail_out != 1) return {};
  bytes.pop_back();
  ByteReader sum{stream.substr(stream.size() - 4), ByteOrder::kBigEndian};
  if (sum.take<std::uint32_t>() != adler_of(bytes)) return {};
  return bytes;
}

}  // namespace sim::surface
