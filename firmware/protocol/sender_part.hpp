#pragma once

#include <string_view>
#include <utility>

namespace cnc {

/// State of the sender's participation in a manual tool change: whether the sender takes part
/// (0xA3), and whether it has sent `~`, which ends the change.
class SenderPart {
 public:
  /// Begin and end the participation. The lines that were kept back are executed after its end.
  void begin() { is_taken_ = true; }
  void end() { is_taken_ = false; }
  [[nodiscard]] bool taken() const { return is_taken_; }

  /// Notes that `~` was received. Lines that were received before `~` are executed first.
  void note_resume() { resumes_ = true; }
  /// Ends the wait for the lines that were received before `~`.
  void end_resume() { resumes_ = false; }
  [[nodiscard]] bool resumes() const { return resumes_; }

  /// Refuses the participation.
  /// @param reason text for the sender; must stay valid until it is reported
  void refuse(std::string_view reason) { refusal_ = reason; }
  [[nodiscard]] bool has_refusal() const { return !refusal_.empty(); }
  /// Returns the reason of the refusal, and forgets it.
  [[nodiscard]] std::string_view take_refusal() { return std::exchange(refusal_, {}); }

 private:
  bool is_taken_ = false;
  bool resumes_ = false;
  std::string_view refusal_{};
};

}  // namespace cnc
