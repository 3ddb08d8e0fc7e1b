#include "hal/host/file_store.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <iomanip>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "hal/host/replacing_file.hpp"
#include "hal/host/system_call.hpp"

namespace hal::host {
namespace {

constexpr std::string_view kHead = "kerfline store 2\n";
constexpr std::string_view kEnd = "end ";

/// Reads a number in the given base. Returns false if `text` is not exactly one number.
template <typename Number>
bool read_number(std::string_view text, int base, Number& number) {
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number, base);
  return read.ec == std::errc{} && read.ptr == text.data() + text.size();
}

/// Reads one record from a line of the file. Returns false if the line is not a record.
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

/// Returns the CRC-32 of IEEE 802.3, as zlib computes it.
std::uint32_t crc_of(std::string_view text) {
  constexpr std::uint32_t kPolynomial = 0xEDB8'8320;
  std::uint32_t crc = 0xFFFF'FFFF;
  for (const char letter : text) {
    crc ^= static_cast<unsigned char>(letter);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1U) != 0 ? kPolynomial : 0U);
  }
  return ~crc;
}

/// Returns the last line of a file whose earlier lines are `text`.
std::string end_of(std::string_view text) {
  const auto records = std::count(text.begin(), text.end(), '\n') - 1;
  std::ostringstream line;
  line << kEnd << records << ' ' << std::hex << std::setfill('0') << std::setw(8) << crc_of(text);
  return line.str() + '\n';
}

std::string text_of(const MemoryStore::Records& records) {
  std::ostringstream text;
  text << kHead;
  for (const auto& [number, record] : records) {
    text << std::dec << number << ':' << std::hex << std::setfill('0');
    for (const std::byte byte : record) text << std::setw(2) << std::to_integer<unsigned>(byte);
    text << '\n';
  }
  return text.str() + end_of(text.str());
}

std::string read_whole(int file) {
  std::string text;
  std::array<char, 4096> part{};
  for (;;) {
    const ::ssize_t count = ::read(file, part.data(), part.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw std::system_error{errno, std::generic_category()};
    if (count == 0) return text;
    text.append(part.data(), static_cast<std::size_t>(count));
  }
}

/// Removes the last line of a file of the second format from `text`. Returns the reason if that
/// line is wrong.
std::optional<std::string> wrong_end(std::string_view& text) {
  const std::size_t last = text.substr(0, text.size() - 1).rfind('\n') + 1;
  const std::string_view line = text.substr(last);
  if (!line.starts_with(kEnd) || !line.ends_with('\n')) return "the file is cut off";
  text = text.substr(0, last);
  if (line != end_of(text)) return "the file is damaged: its checksum is another";
  return std::nullopt;
}

constexpr const char* kRemedy =
    "; put a copy in its place, or remove it to begin with the delivered settings";

}  // namespace

FileStore::FileStore(std::string path) : path_{std::move(path)} {
  try {
    if (open_and_lock()) read();
  } catch (const std::exception& error) {
    release();
    // A reason that concerns a line of the file begins with a colon and the number of the line.
    const std::string reason = error.what();
    throw std::runtime_error(path_ + (reason.starts_with(':') ? "" : ": ") + reason);
  }
}

FileStore::~FileStore() { release(); }

void FileStore::release() {
  if (lock_ >= 0) static_cast<void>(::close(lock_));
  lock_ = -1;
}

bool FileStore::open_and_lock() {
  // Another process may replace the file between opening and locking, so both are repeated.
  constexpr int kMaxTries = 100;
  const std::string target = without_links(path_);
  for (int i = 0; i < kMaxTries; ++i) {
    release();
    lock_ = open_file(target, O_RDWR | O_CLOEXEC | O_NOCTTY);
    if (lock_ < 0 && errno == ENOENT) {
      if (create()) return false;
      continue;
    }
    if (lock_ < 0) throw std::system_error{errno, std::generic_category(), "cannot open"};
    struct ::stat locked {};
    struct ::stat named {};
    if (::fstat(lock_, &locked) != 0 || !S_ISREG(locked.st_mode)) {
      throw std::runtime_error("is no regular file");
    }
    if (::flock(lock_, LOCK_EX | LOCK_NB) != 0) {
      if (errno != EWOULDBLOCK) throw std::system_error{errno, std::generic_category(), "no lock"};
      throw std::runtime_error("another server uses it; end that one, or name another file");
    }
    if (::stat(target.c_str(), &named) == 0 && named.st_ino == locked.st_ino) return true;
  }
  throw std::runtime_error("it is replaced again and again by another process");
}

/// Locks and completes the file before it gets its name, so that a killed process leaves no empty
/// file under that name.
bool FileStore::create() {
  ReplacingFile fresh{path_};
  fresh.write(text_of(records_));
  if (::flock(fresh.descriptor(), LOCK_EX | LOCK_NB) != 0) {
    throw std::system_error{errno, std::generic_category(), "no lock"};
  }
  if (!fresh.commit_as_new()) return false;
  lock_ = control_file(fresh.descriptor(), F_DUPFD_CLOEXEC);
  return true;
}

void FileStore::read() {
  const std::string whole = read_whole(lock_);
  std::string_view text = whole;
  if (text.empty()) throw std::runtime_error(std::string{"the file is empty"} + kRemedy);
  const bool has_end = text.starts_with(kHead);
  if (has_end) {
    if (const auto wrong = wrong_end(text)) throw std::runtime_error(*wrong + kRemedy);
    text.remove_prefix(kHead.size());
  }
  for (int at = has_end ? 2 : 1; !text.empty(); ++at) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    unsigned number = 0;
    std::vector<std::byte> record;
    if (!read_record(text.substr(0, end), number, record)) {
      throw std::runtime_error(":" + std::to_string(at) + ": not a stored record" + kRemedy);
    }
    records_[static_cast<std::uint16_t>(number)] = record;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

bool FileStore::save(std::uint16_t number, std::span<const std::byte> record) {
  Records before = records_;
  if (!MemoryStore::save(number, record)) return false;
  if (records_ == before || write()) return true;
  records_ = std::move(before);
  return false;
}

/// Writes all records into a new file and locks that file before it gets the name of the old file.
bool FileStore::write() {
  try {
    ReplacingFile fresh{path_};
    fresh.write(text_of(records_));
    if (::flock(fresh.descriptor(), LOCK_EX | LOCK_NB) != 0) return false;
    fresh.commit();
    release();
    lock_ = control_file(fresh.descriptor(), F_DUPFD_CLOEXEC);
    return true;
  } catch (const std::system_error&) {
    return false;
  }
}

}  // namespace hal::host
