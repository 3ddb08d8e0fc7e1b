#include "host-sim/import/gunzip.hpp"

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace sim::drawing {
namespace {

constexpr std::size_t kChunkBytes = std::size_t{1} << 16;
// The windowBits argument of zlib: 15 selects the largest window, and adding 16 requires the gzip
// format.
constexpr int kGzipWindow = 15 + 16;

/// A stream of zlib that unpacks data. The destructor closes it.
class Inflater {
 public:
  explicit Inflater(std::string_view bytes) : bytes_{bytes} {
    stream_.next_in = reinterpret_cast<Bytef*>(bytes_.data());
    const std::size_t most = std::numeric_limits<uInt>::max();
    stream_.avail_in = static_cast<uInt>(std::min(bytes_.size(), most));
    is_open_ = inflateInit2(&stream_, kGzipWindow) == Z_OK;
  }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  ~Inflater() {
    if (is_open_) inflateEnd(&stream_);
  }

  /// Appends the next unpacked bytes to `text`. Returns the status of zlib.
  int next(std::string& text) {
    if (!is_open_) return Z_STREAM_ERROR;
    stream_.next_out = chunk_.data();
    stream_.avail_out = static_cast<uInt>(chunk_.size());
    const int status = inflate(&stream_, Z_NO_FLUSH);
    text.append(reinterpret_cast<const char*>(chunk_.data()), chunk_.size() - stream_.avail_out);
    return status;
  }

 private:
  /// Copy of the packed bytes, because zlib requires bytes that are not const.
  std::string bytes_;
  std::vector<Bytef> chunk_ = std::vector<Bytef>(kChunkBytes);
  z_stream stream_{};
  bool is_open_ = false;
};

}  // namespace

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1F\x8B"); }

std::optional<std::string> gunzip(std::string_view bytes, std::size_t max_bytes) {
  Inflater inflater{bytes};
  std::string text;
  while (text.size() <= max_bytes) {
    const int status = inflater.next(text);
    if (status == Z_STREAM_END) break;
    if (status != Z_OK) return {};
  }
  if (text.size() > max_bytes) return {};
  return text;
}

}  // namespace sim::drawing
