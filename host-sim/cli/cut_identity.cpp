#include "host-sim/cli/cut_identity.hpp"

#include <string_view>
#include <vector>

#include "host-sim/knowledge/flash_lines.hpp"

namespace sim {

ProgramDigest digest_of(const MaterialRecord& record) {
  const std::vector<std::byte> image = flash_image(record, "job");
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes as text.
  const std::string_view bytes{reinterpret_cast<const char*>(image.data()), image.size()};
  return {"kerf", digest_of(bytes), record.name};
}

ProgramDigest settings_digest(const cnc::Settings& settings, bool is_given) {
  return {"settings", digest_of(settings), is_given ? "given" : "default"};
}

}  // namespace sim
