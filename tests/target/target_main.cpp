/// Runs the job on the emulated chip and prints its digest.

#include <array>
#include <cstdint>

#include "tests/target/same_bits.hpp"
#include "tests/target/start_up.hpp"

namespace {

/// Writes hexadecimal digits, without a library function.
template <typename Number>
char* put(char* at, Number number) {
  for (int shift = static_cast<int>(8 * sizeof(Number)) - 4; shift >= 0; shift -= 4) {
    *at++ = "0123456789abcdef"[number >> shift & 0xFU];
  }
  *at++ = ' ';
  return at;
}

void print(const Digest& digest) {
  std::array<char, 48> text{};
  char* at = put(text.data(), digest.hash);
  at = put(at, digest.edges);
  at = put(at, digest.answers);
  at[-1] = '\n';
  write_text(text.data());
}

}  // namespace

void run_on_target() { print(digest_of_a_job()); }
