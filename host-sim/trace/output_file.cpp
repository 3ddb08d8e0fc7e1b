#include "host-sim/trace/output_file.hpp"

#include <utility>

namespace sim {

OutputFile::OutputFile(std::string path) : file_{std::move(path)} {
  buffer_.reserve(kDrainAt + kDrainAt / 4);
}

void OutputFile::close() {
  drain();
  file_.commit();
}

void OutputFile::drain() {
  file_.write({buffer_.data(), buffer_.size()});
  buffer_.clear();
}

void write_file(const std::string& path, std::string_view content) {
  OutputFile file{path};
  file.buffer().append(content);
  file.close();
}

}  // namespace sim
