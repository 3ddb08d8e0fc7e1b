#include "host-sim/serve/record_file.hpp"

#include <system_error>

#include "host-sim/serve/lost_output.hpp"

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

bool RecordFile::close(const Session& session) {
  if (!recorder_) return true;
  recorder_->finish();
  append(end_text(session.controller().now_ticks() * VirtualController::kNanosecondsPerTick));
  attempt([](OutputFile& file) { file.close(); });
  return !lost_;
}

void RecordFile::append(const std::string& text) {
  attempt([&text](OutputFile& file) {
    file.buffer().append(text);
    file.drain_when_full();
  });
}

template <typename Write>
void RecordFile::attempt(Write&& write) {
  if (!file_) return;
  try {
    write(*file_);
  } catch (const std::system_error& error) {
    report_lost_output("--record", error);
    file_.reset();
    lost_ = true;
  }
}

}  // namespace sim
