#include "runner/bench/answering_program.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>

#include "league/team/flat_records.hpp"

namespace autoref::runner {
namespace {

constexpr std::size_t kMostCommands = 16;

struct Answer {
  league::FlatOutput output;
  std::array<league::FlatCommand, kMostCommands> commands;
};

// Drives in curves, so that games with it differ from those in which nothing moves.
void fill(Answer& answer, const league::FlatFrame& frame) {
  const std::size_t robots = std::min<std::size_t>(frame.own_robots, kMostCommands);
  answer.output.length =
      static_cast<std::uint32_t>(sizeof(league::FlatOutput) + robots * sizeof(league::FlatCommand));
  answer.output.kind = league::FlatKind::kOutput;
  answer.output.frame = frame.frame;
  answer.output.leaves = -1;
  answer.output.commands = static_cast<std::uint16_t>(robots);
  for (std::size_t i = 0; i < robots; ++i) {
    answer.commands[i].robot = static_cast<std::int32_t>(i);
    answer.commands[i].vx_mps = 0.5;
    answer.commands[i].angular_velocity_radps = static_cast<double>(frame.frame % 50) / 10;
  }
}

bool read_all(char* bytes, std::size_t size) { return std::fread(bytes, 1, size, stdin) == size; }

}  // namespace

int answer_frames() {
  static std::array<char, 1U << 16U> record;
  Answer answer{};
  std::puts("autoref-team 1 flat");
  std::fflush(stdout);
  while (read_all(record.data(), sizeof(std::uint32_t))) {
    std::uint32_t length = 0;
    std::memcpy(&length, record.data(), sizeof length);
    if (length < sizeof(league::FlatEnd) || length > record.size()) return 1;
    if (!read_all(record.data() + sizeof length, length - sizeof length)) return 1;
    league::FlatKind kind{};
    std::memcpy(&kind, record.data() + sizeof length, sizeof kind);
    if (kind == league::FlatKind::kEnd) return 0;
    if (kind != league::FlatKind::kFrame) continue;
    league::FlatFrame frame;
    std::memcpy(&frame, record.data(), sizeof frame);
    fill(answer, frame);
    std::fwrite(&answer, 1, answer.output.length, stdout);
    std::fflush(stdout);
  }
  return 1;
}

}  // namespace autoref::runner
