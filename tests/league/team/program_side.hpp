// The program's side of the encodings: reads what the simulator sends, and writes outputs.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "league/team/team_codec.hpp"

namespace autoref::league {

class ProgramSide {
 public:
  ProgramSide() = default;
  ProgramSide(const ProgramSide&) = delete;
  ProgramSide& operator=(const ProgramSide&) = delete;
  virtual ~ProgramSide() = default;

  // Each reads exactly one message and throws an exception if there is anything else.
  virtual TeamStart read_start(std::string_view bytes) const = 0;
  virtual TeamFrame read_frame(std::string_view bytes) const = 0;
  virtual TeamEnd read_end(std::string_view bytes) const = 0;

  // The encoded output with its delimiter or length.
  virtual std::string written(const TeamOutput& output) const = 0;
};

std::unique_ptr<ProgramSide> make_flat_side();
std::unique_ptr<ProgramSide> make_json_side();

}  // namespace autoref::league
