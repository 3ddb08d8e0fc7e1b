#include "hal/host/file_store.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <charconv>
#include <cstdio>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace hal::host {
namespace {

/// Reads `number` in the base; false when the text holds anything else.
bool read_number(std::string_view text, int base, unsigned& number) {
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number, base);
  return read.ec == std::errc{} && read.ptr == text.data() + text.size();
}

/// One line of the file; false when it is none.
bool read_record(std::string_view line, unsigned& number, std::vector<std::byte>& record) {
  const std::size_t colon = line.find(':');
  if (colon == std::string_view::npos) return false;
  if (!read_number(line.substr(0, colon), 10, number) || number > 0xFFFFU) return false;
  const std::string_view digits = line.substr(colon + 1);
  const bool fits = digits.size() % 2 == 0 && digits.size() <= 2 * RecordStore::kLongestRecord;
  if (!fits || digits.empty()) return false;
  for (std::size_t i = 0; i < digits.size(); i += 2) {
    unsigned byte = 0;
    if (!read_number(digits.substr(i, 2), 16, byte)) return false;
    record.push_back(static_cast<std::byte>(byte));
  }
  return true;
}

std::string text_of(const MemoryStore::Records& records) {
  std::ostringstream text;
  for (const auto& [number, record] : records) {
    text << std::dec << number << ':' << std::hex << std::setfill('0');
    for (const std::byte byte : record) text << std::setw(2) << std::to_integer<unsigned>(byte);
    text << '\n';
  }
  return text.str();
}

/// Writes and waits until the disk has it.
bool write_through(const std::string& path, const std::string& text) {
  const int file = ::creat(path.c_str(), 0666);
  if (file < 0) return false;
  const bool written = ::write(file, text.data(), text.size()) == std::ssize(text);
  const bool kept = written && ::fsync(file) == 0;
  return ::close(file) == 0 && kept;
}

}  // namespace

FileStore::FileStore(std::string path) : path_{std::move(path)} { read(); }

void FileStore::read() {
  std::ifstream file{path_};
  std::string line;
  for (int at = 1; std::getline(file, line); ++at) {
    unsigned number = 0;
    std::vector<std::byte> record;
    if (!read_record(line, number, record)) {
      throw std::runtime_error(path_ + ":" + std::to_string(at) + ": not a stored record");
    }
    records_[static_cast<std::uint16_t>(number)] = record;
  }
}

bool FileStore::save(std::uint16_t number, std::span<const std::byte> record) {
  Records before = records_;
  if (!MemoryStore::save(number, record)) return false;
  if (records_ == before || write()) return true;
  records_ = std::move(before);
  return false;
}

bool FileStore::write() const {
  const std::string fresh = path_ + ".new";
  return write_through(fresh, text_of(records_)) && std::rename(fresh.c_str(), path_.c_str()) == 0;
}

}  // namespace hal::host
