#include "host-sim/serve/served_program.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string_view>

#include "host-sim/job/program_text.hpp"
#include "host-sim/job/text_hash.hpp"

namespace sim {
namespace {

std::string id_of(std::string_view name, std::string_view file) {
  return fmt::format("{:016x}", text_hash(file, text_hash(name)));
}

std::string text_of(const LineNote& note) {
  return fmt::format("line {}: {}", note.line, note.text);
}

constexpr std::size_t kMaxBarriers = 20;

void add_barriers(const ProgramText& prepared, ServedProgram& program) {
  for (const LineNote& fault : prepared.faults) {
    if (program.barriers.size() == kMaxBarriers) {
      program.barriers.push_back(
          fmt::format("and {} more lines like this", prepared.faults.size() - kMaxBarriers));
      return;
    }
    program.barriers.push_back(text_of(fault));
  }
}

}  // namespace

std::shared_ptr<const ServedProgram> prepare_served(std::string name,
                                                    std::string file,
                                                    bool block_delete) {
  auto program = std::make_shared<ServedProgram>();
  program->id = id_of(name, file);
  program->name = std::move(name);
  program->block_delete = block_delete;
  ProgramText prepared = prepare_program(std::move(file), block_delete);
  add_barriers(prepared, *program);
  for (const LineNote& note : prepared.notes) {
    program->notes.push_back(text_of(note));
    program->has_slashes = program->has_slashes || note.text.starts_with("lines that begin with /");
  }
  program->text = std::move(prepared.text);
  program->lines = read_job(program->text, true);
  constexpr std::size_t kMax = kLongestSentLine - kSentNumber;
  if (const auto line = line_too_long(program->lines, kMax)) {
    program->barriers.push_back(fmt::format(
        "line {}: longer than {} characters without comments and blanks", line->number, kMax));
  }
  return program;
}

std::string judgement_key(const ServedProgram& program, const Standpoint& standpoint) {
  std::string key = program.id;
  const cnc::gcode::Interpreter& reader = standpoint.reader;
  for (const cnc::Position& position :
       {reader.position(), reader.places().g28, reader.places().g30}) {
    for (const cnc::Coordinate one : position) key += fmt::format(" {}", one.nanometres());
  }
  for (const std::string& line : state_lines(standpoint)) key += "\n" + line;
  return key + fmt::format("\n{} {} {}",
                           standpoint.homed,
                           standpoint.settings.revision(),
                           standpoint.block_delete());
}

}  // namespace sim
