#pragma once

#include <optional>
#include <string>

#include "host-sim/serve/conversation.hpp"
#include "host-sim/serve/recorder.hpp"
#include "host-sim/serve/session.hpp"
#include "host-sim/trace/output_file.hpp"

namespace sim {

/// Records the conversation of a session in a file, for replay(). With an empty path nothing is
/// recorded. If the file cannot be written any more, as on a full disk, the recording ends with a
/// message and the session continues.
class RecordFile {
 public:
  /// Throws std::system_error naming the file.
  RecordFile(const std::string& path, const ConversationSetting& setting, Session& session);
  RecordFile(const RecordFile&) = delete;
  RecordFile& operator=(const RecordFile&) = delete;
  ~RecordFile() = default;

  /// Ends the file. Call it after the last cycle. Returns false if the file could not be written to
  /// its end.
  [[nodiscard]] bool close(const Session& session);

 private:
  void append(const std::string& text);
  template <typename Write>
  void attempt(Write&& write);

  std::optional<OutputFile> file_;
  std::optional<Recorder> recorder_;
  bool lost_ = false;
};

}  // namespace sim
