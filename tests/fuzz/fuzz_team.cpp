// Fuzzes the greetings and outputs of teams' programs with arbitrary bytes. The first byte selects
// the encoding, unless it begins a greeting. However the bytes arrive, they must give the same
// outputs and the same fault.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

#include "league/team/greeting.hpp"
#include "league/team/team_codec.hpp"
#include "league/team/team_fault.hpp"

namespace {

using namespace autoref;
using namespace autoref::league;

// Frames of the outputs, and the fault.
using Decoded = std::pair<std::vector<std::int64_t>, std::string>;

// All numbers that passed the checks are finite.
void check(const TeamOutput& output) {
  for (const RobotCommand& command : output.commands) {
    if (!is_finite(command)) std::abort();
  }
}

Decoded decoded(TeamEncoding encoding, std::string_view bytes, std::size_t piece) {
  const std::unique_ptr<TeamCodec> codec = make_team_codec(encoding);
  OutputDecoder decoder(*codec);
  Decoded result;
  TeamOutput output;
  while (!bytes.empty() && decoder.fault().empty()) {
    decoder.add(bytes.substr(0, piece));
    bytes.remove_prefix(std::min(piece, bytes.size()));
    while (decoder.next(output) == OutputDecoder::Result::kOutput) {
      check(output);
      result.first.push_back(output.frame);
    }
  }
  result.second = decoder.fault();
  return result;
}

void greet(std::string_view bytes) {
  try {
    find_greeting(bytes);
  } catch (const TeamFault&) {  // refused with a message
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  greet(bytes);
  constexpr auto kEncodings = names_of(TeamEncoding{});
  const TeamEncoding encoding = kEncodings[data[0] % kEncodings.size()].value;
  const Decoded at_once = decoded(encoding, bytes.substr(1), size);
  constexpr std::size_t kPiece = 7;
  if (decoded(encoding, bytes.substr(1), kPiece) != at_once) std::abort();
  return 0;
}
