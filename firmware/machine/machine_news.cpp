#include "firmware/machine/machine_news.hpp"

namespace cnc {

std::optional<compensation::Fault> MachineNews::take_path_fault() {
  const std::optional<compensation::Fault> fault = path_fault;
  path_fault.reset();
  return fault;
}

}  // namespace cnc
