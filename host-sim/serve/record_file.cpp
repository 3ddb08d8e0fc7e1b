#include "host-sim/serve/record_file.hpp"

namespace sim {

RecordFile::RecordFile(const std::string& path,
                       const ConversationSetting& setting,
                       Session& session) {
  if (path.empty()) return;
  file_.emplace(path);
  append(head_text(setting));
  recorder_.emplace(session.controller(),
                    [this](const Exchange& exchange) { append(to_text(exchange)); });
  session.link().tell(&*recorder_);
}

void RecordFile::close(const Session& session) {
  if (!file_) return;
  recorder_->finish();
  append(end_text(session.controller().now_ticks() * VirtualController::kNanosecondsPerTick));
  file_->close();
}

void RecordFile::append(const std::string& text) {
  file_->buffer().append(text);
  file_->drain_when_full();
}

}  // namespace sim
