/// libFuzzer: any bytes as a project of LightBurn.

#include <cstddef>
#include <cstdint>

#include "tests/fuzz/drawing_judge.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::judge_drawing(data, size);
}
