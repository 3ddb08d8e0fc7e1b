#include "host-sim/trace/output_file.hpp"

#include <cerrno>
#include <system_error>
#include <utility>

namespace sim {

OutputFile::OutputFile(std::string path)
    : path_{std::move(path)}, file_{std::fopen(path_.c_str(), "wb")} {
  if (!file_) fail("cannot create");
  std::setvbuf(file_.get(), nullptr, _IONBF, 0);  // `buffer_` is the buffer.
  buffer_.reserve(kDrainAt + kDrainAt / 4);
}

OutputFile::~OutputFile() {
  if (file_) static_cast<void>(std::fwrite(buffer_.data(), 1, buffer_.size(), file_.get()));
}

void OutputFile::close() {
  if (!file_) return;
  drain();
  if (std::fclose(file_.release()) != 0) fail("cannot write");
}

void OutputFile::drain() {
  if (std::fwrite(buffer_.data(), 1, buffer_.size(), file_.get()) != buffer_.size()) {
    fail("cannot write");
  }
  buffer_.clear();
}

void OutputFile::fail(const char* action) const {
  throw std::system_error{errno, std::generic_category(), fmt::format("{} {}", action, path_)};
}

void write_file(const std::string& path, std::string_view content) {
  OutputFile file{path};
  file.buffer().append(content);
  file.close();
}

}  // namespace sim
