// The driver's side of the core's model.

#include "tests/hal/stm32f405/usb/otg_bits.hpp"
#include "tests/hal/stm32f405/usb/otg_model.hpp"

namespace hal::stm32f405 {

using namespace otg_bits;  // NOLINT(google-build-using-namespace): this file uses these names.

std::uint32_t OtgModel::max_bytes(const Endpoint& endpoint, unsigned number) {
  return number == 0 ? 64U >> (endpoint.control & 3U) : endpoint.control & 0x7FFU;
}

std::size_t OtgModel::fifo_depth(unsigned number) const { return memory_[number] >> 16; }

std::size_t OtgModel::memory_used() const {
  std::size_t words = current_.size();
  for (const Entry& entry : entries_) words += 1 + entry.words.size();
  return words;
}

std::uint32_t OtgModel::endpoint_flags() const {
  std::uint32_t flags = 0;
  for (unsigned i = 0; i < kEndpoints; ++i) {
    if ((in_[i].status & in_mask_) != 0) flags |= one(i);
    if ((out_[i].status & out_mask_) != 0) flags |= one(16 + i);
  }
  return flags;
}

std::uint32_t OtgModel::status_word() const {
  const std::uint32_t asking = endpoint_flags() & endpoints_mask_;
  return latched_ | (entries_.empty() ? 0 : one(4)) | ((asking & 0xFFFFU) != 0 ? one(18) : 0) |
         (asking >> 16 != 0 ? one(19) : 0);
}

bool OtgModel::interrupts() const { return (ahb_ & 1U) != 0 && (status_word() & mask_) != 0; }

void OtgModel::look_at_clock() {
  if ((ModelBus::chip().cells[0x4002'3834] & one(7)) == 0) blame("a register without its clock");
}

/// Returns a register that only keeps what is written to it.
std::uint32_t* OtgModel::cell(std::uint32_t offset) {
  switch (offset) {
    case 0x008:
      return &ahb_;
    case 0x00C:
      return &usb_;
    case 0x018:
      return &mask_;
    case 0x024:
      return &receive_words_;
    case 0x028:
      return memory_.data();
    case 0x038:
      return &general_;
    case 0x104:
    case 0x108:
    case 0x10C:
      return &memory_[(offset - 0x100) / 4];
    case 0x800:
      return &device_;
    case 0x804:
      return &device_control_;
    case 0x810:
      return &in_mask_;
    case 0x814:
      return &out_mask_;
    case 0x81C:
      return &endpoints_mask_;
    case 0xE00:
      return &power_;
    default:
      return nullptr;
  }
}

std::uint32_t OtgModel::read(std::uint32_t address) {
  const std::uint32_t offset = address & 0x3FFFFU;
  look_at_clock();
  if (offset >= 0x1000) return pop_word();
  if (is_endpoint(offset)) return read_endpoint(offset);
  switch (offset) {
    case 0x010:
      return answers ? one(31) : 0;
    case 0x014: {
      const bool host = looks_as_host > 0 && (usb_ & one(30)) != 0;
      if (host) --looks_as_host;
      return status_word() | (host ? 1U : 0U);
    }
    case 0x020:
      return pop_entry();
    case 0x818:
      return endpoint_flags();
    default:
      break;
  }
  const std::uint32_t* const kept = cell(offset);
  if (kept == nullptr) blame("a register that is not there");
  return kept != nullptr ? *kept : 0;
}

std::uint32_t OtgModel::pop_word() {
  if (current_.empty()) {
    blame("a word that was not received");
    return 0;
  }
  const std::uint32_t word = current_.front();
  current_.pop_front();
  return word;
}

std::uint32_t OtgModel::read_endpoint(std::uint32_t offset) const {
  const unsigned number = offset >> 5 & 3U;
  const Endpoint& endpoint = offset < 0xA00 ? in_[number] : out_[number];
  switch (offset & 0x1FU) {
    case 0x00:
      return endpoint.control;
    case 0x08:
      return endpoint.status;
    case 0x10:
      return endpoint.size;
    case 0x18:
      return static_cast<std::uint32_t>(fifo_depth(number) - endpoint.fifo.size());
    default:
      return 0;
  }
}

void OtgModel::write(std::uint32_t address, std::uint32_t value) {
  const std::uint32_t offset = address & 0x3FFFFU;
  look_at_clock();
  if (offset >= 0x1000) return push((offset >> 12) - 1, value);
  if (is_endpoint(offset)) return write_endpoint(offset, value);
  if (offset == 0x010) return write_resets(value);
  if (offset == 0x014) {
    latched_ &= ~value;
    return;
  }
  std::uint32_t* const kept = cell(offset);
  if (kept == nullptr) return blame("a register that is not there");
  *kept = value;
  if (offset == 0x800 && (value >> 4 & 0x7FU) == 0) address_ = 0;
}

void OtgModel::write_endpoint(std::uint32_t offset, std::uint32_t value) {
  const unsigned number = offset >> 5 & 3U;
  const bool in = offset < 0xA00;
  Endpoint& endpoint = in ? in_[number] : out_[number];
  switch (offset & 0x1FU) {
    case 0x00:
      return write_control(endpoint, value, in, number);
    case 0x08:
      endpoint.status &= ~value;
      break;
    case 0x10:
      if ((endpoint.control & kEpEnabled) != 0 && (in || number != 0)) {
        blame("the size of a transfer that is under way");
      }
      endpoint.size = value;
      break;
    default:
      blame("a register that is not there");
  }
}

void OtgModel::write_resets(std::uint32_t value) {
  if ((value & 1U) != 0) {
    const bool answered = answers;
    const int looks = looks_as_host;
    const std::vector<std::string> noted = misuse;
    *this = {};
    answers = answered;
    looks_as_host = looks;
    misuse = noted;
  }
  if ((value & one(4)) != 0) {
    entries_.clear();
    current_.clear();
  }
  if ((value & one(5)) == 0) return;
  for (unsigned i = 0; i < kEndpoints; ++i) {
    const unsigned which = value >> 6 & 0x1FU;
    if (which != 0x10 && which != i) continue;
    const bool sending = (in_[i].control & kEpEnabled) != 0 && !in_[i].fifo.empty();
    if (sending && which != 0x10) blame("the memory of a packet that may be on the wire");
    in_[i].fifo.clear();
  }
}

void OtgModel::write_control(Endpoint& endpoint, std::uint32_t value, bool in, unsigned number) {
  constexpr std::uint32_t kKept = 0x07EC'87FF & ~kEpNakking;
  const std::uint32_t core = endpoint.control & (kEpEnabled | kEpNakking);
  endpoint.control = (value & kKept & ~(kEpCnak)) | core | (number == 0 ? kEpActive : 0);
  if ((value & kEpSnak) != 0) {
    endpoint.control |= kEpNakking;
    if (in) endpoint.status |= kEpInepne;
  }
  if ((value & kEpCnak) != 0) {
    endpoint.control &= ~kEpNakking;
    endpoint.status &= ~kEpInepne;
  }
  if (number != 0 && (value & kEpData0) != 0) endpoint.data1 = false;
  if ((value & kEpDisable) != 0) {
    if ((core & kEpEnabled) == 0) blame("disables an endpoint that is not enabled");
    if (!in) blame("disables an OUT endpoint while packets may come");
    if ((endpoint.control & kEpNakking) == 0) blame("disables an endpoint that may be answering");
    endpoint.control &= ~kEpEnabled;
    endpoint.status |= kEpDisd;
    return;
  }
  if ((value & kEpEnabled) == 0) return;
  const bool begins = (core & kEpEnabled) == 0;
  endpoint.control |= kEpEnabled;
  if (!begins) return;
  if (packets_of(endpoint.size) == 0) blame("enables a transfer of no packet");
  if (in && !endpoint.fifo.empty()) blame("words of an old packet before a new one");
  if (in && number != 0 && (value >> 22 & 0xFU) != number) blame("another endpoint's memory");
  if (!in && bytes_left(endpoint.size) < max_bytes(endpoint, number)) {
    blame("room for less than a packet");
  }
}

void OtgModel::push(unsigned number, std::uint32_t word) {
  if (number >= kEndpoints) return blame("no such endpoint");
  Endpoint& endpoint = in_[number];
  if ((endpoint.control & kEpEnabled) == 0) blame("data before the transfer");
  if (endpoint.fifo.size() >= words_for(bytes_left(endpoint.size))) blame("more data than said");
  if (endpoint.fifo.size() >= fifo_depth(number)) return blame("more data than there is memory");
  endpoint.fifo.push_back(word);
}

std::uint32_t OtgModel::pop_entry() {
  if (!current_.empty()) blame("an entry before the words of the one before");
  if (entries_.empty()) {
    blame("an entry that is not there");
    return 0;
  }
  const Entry entry = entries_.front();
  entries_.pop_front();
  current_.assign(entry.words.begin(), entry.words.end());
  Endpoint& endpoint = out_[entry.status & 3U];
  const unsigned kind = entry.status >> 17 & 0xFU;
  if (kind == kSetUpOverEntry) endpoint.status |= kEpStup;
  if (kind == kOutOverEntry) {
    endpoint.control &= ~kEpEnabled;
    endpoint.status |= kEpXfrc;
  }
  return entry.status;
}

}  // namespace hal::stm32f405
