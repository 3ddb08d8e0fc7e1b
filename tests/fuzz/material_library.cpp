/// libFuzzer: any bytes as a library of materials of LightBurn.

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "host-sim/import/clb_reader.hpp"
#include "tests/fuzz/drawing_judge.hpp"

namespace {

void judge_library(const std::string& text) {
  using namespace sim::drawing;
  const MaterialLibrary library = read_clb(text, "fuzz");
  fuzz::require_drawn(library.entries.size() <= kMaxLibraryEntries, "settings are bounded");
  for (const LibraryEntry& entry : library.entries) {
    fuzz::require_drawn(entry.line > 0 && entry.column > 0, "a setting has a place");
    fuzz::require_drawn(entry.material.size() <= kLongestMaterialName, "a name is bounded");
    const double thickness_mm = entry.thickness_mm.value_or(1.0);
    fuzz::require_drawn(thickness_mm > 0.0 && thickness_mm <= kGreatestThicknessMm, "and thick");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text{reinterpret_cast<const char*>(data), size};
  try {
    judge_library(text);
  } catch (const std::invalid_argument& refusal) {
    fuzz::require_refusal(refusal);
  }
  return 0;
}
