#pragma once

#include <string_view>
#include <utility>

namespace cnc {

/// The part that the sender takes in a tool change by hand: whether it takes part (0xA3), and
/// whether `~` has come, which ends the change.
class SenderPart {
 public:
  /// Begins and ends the part: the lines that were kept back are done after it.
  void begin() { is_taken_ = true; }
  void end() { is_taken_ = false; }
  [[nodiscard]] bool taken() const { return is_taken_; }

  /// Notes that `~` was received. Lines that were received before it are done first.
  void note_resume() { resumes_ = true; }
  /// Ends the wait for the lines that were received before `~`.
  void end_resume() { resumes_ = false; }
  [[nodiscard]] bool resumes() const { return resumes_; }

  /// Refuses the part.
  /// @param reason must outlive its report
  void refuse(std::string_view reason) { refusal_ = reason; }
  [[nodiscard]] bool has_refusal() const { return !refusal_.empty(); }
  /// Returns the reason, once.
  [[nodiscard]] std::string_view take_refusal() { return std::exchange(refusal_, {}); }

 private:
  bool is_taken_ = false;
  bool resumes_ = false;
  std::string_view refusal_{};
};

}  // namespace cnc
