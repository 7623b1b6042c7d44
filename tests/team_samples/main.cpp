// Writes and reads the messages of teams' programs, for team_samples.py:
//
//   team_samples write ENCODING   a START, frames of both kinds in turn, and an END
//   team_samples read ENCODING    outputs from the standard input, each described on one line
#include <fmt/format.h>

#include <cstdio>
#include <iostream>
#include <iterator>

#include "league/team/team_codec.hpp"
#include "tests/league/team/random_messages.hpp"

namespace {

using namespace autoref::league;

void write(TeamCodec& codec) {
  constexpr int kFrames = 200;
  RandomMessages random(11);
  std::string bytes;
  codec.append(random.start(), bytes);
  for (int i = 0; i < kFrames; ++i)
    codec.append(i % 2 == 0 ? random.frame() : random.frame_with_detections(), bytes);
  codec.append(random.end(), bytes);
  std::fwrite(bytes.data(), 1, bytes.size(), stdout);
}

// Doubles are printed in hexadecimal.
void describe(const TeamOutput& output) {
  fmt::print("{} {} {} {} {}", output.frame, output.requests.keeper,
             output.requests.leaves.value_or(-1), output.requests.timeout ? 1 : 0, output.text);
  for (const autoref::RobotCommand& c : output.commands) {
    fmt::print(" {:a} {:a} {:a} {:a} {:d} {:d}", c.velocity_mps.x(), c.velocity_mps.y(),
               c.angular_velocity_radps, c.kick_mps, c.chip, c.dribble);
  }
  fmt::print("\n");
}

int read(TeamCodec& codec) {
  OutputDecoder decoder(codec);
  decoder.add(std::string(std::istreambuf_iterator<char>(std::cin), {}));
  TeamOutput output;
  OutputDecoder::Result result = decoder.next(output);
  for (; result == OutputDecoder::Result::kOutput; result = decoder.next(output)) describe(output);
  if (!decoder.fault().empty()) fmt::print(stderr, "{}\n", decoder.fault());
  return result == OutputDecoder::Result::kFault || decoder.bytes_left() > 0 ? 1 : 0;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) return 2;
  const auto encoding = autoref::find_named<TeamEncoding>(arguments[2]);
  if (!encoding) return 2;
  const std::unique_ptr<TeamCodec> codec = make_team_codec(*encoding);
  if (std::string(arguments[1]) == "read") return read(*codec);
  write(*codec);
  return 0;
}
