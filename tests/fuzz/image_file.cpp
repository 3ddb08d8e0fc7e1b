/// libFuzzer: any bytes as a picture to engrave.

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string_view>

#include "host-sim/picture/grey_image.hpp"
#include "tests/fuzz/drawing_judge.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sim::picture;
  const std::string_view bytes{reinterpret_cast<const char*>(data), size};
  try {
    const GreyImage image = read_image(bytes, "fuzz");
    fuzz::require_drawn(image.width > 0 && image.height > 0, "a picture has pixels");
    fuzz::require_drawn(image.width * image.height <= kMaxImagePixels, "their number is bounded");
    fuzz::require_drawn(image.darkness.size() == image.width * image.height, "each has a darkness");
    for (const float darkness : image.darkness) {
      fuzz::require_drawn(darkness >= 0.0F && darkness <= 1.0F, "from white to black");
    }
  } catch (const std::invalid_argument& refusal) {
    fuzz::require_refusal(refusal);
  }
  return 0;
}
