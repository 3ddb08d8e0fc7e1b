/// libFuzzer: any bytes as an SVG drawing, or the JSON of one.

#include <cstddef>
#include <cstdint>

#include "tests/fuzz/drawing_judge.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::judge_drawing(data, size);
}
