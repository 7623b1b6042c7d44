#include "benchmarks/program_costs.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>

#include "experiments/statistics/sample.hpp"
#include "game/loop/game.hpp"
#include "game/team_programs/program_games.hpp"
#include "io/errors.hpp"
#include "league/team/flat_records.hpp"
#include "league/team/team_codec.hpp"

namespace autoref::benchmarks {
namespace {

using ProgramsClock = std::chrono::steady_clock;

constexpr int kProgramsRounds = 5;
constexpr double kProgramsHalf_s = 60;
constexpr int kBenchedRobots = 6;

double us_since(ProgramsClock::time_point start) {
  return std::chrono::duration<double, std::micro>(ProgramsClock::now() - start).count();
}

// A program behind two bare, blocking pipes.
class BareProgram {
 public:
  explicit BareProgram(const std::vector<std::string>& command) {
    std::array<int, 2> in{};
    std::array<int, 2> out{};
    if (pipe2(in.data(), O_CLOEXEC) != 0 || pipe2(out.data(), O_CLOEXEC) != 0)
      throw io::io_error("cannot open a pipe", errno);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, in[0], STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, out[1], STDOUT_FILENO);
    std::vector<std::string> words = command;
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const int error =
        posix_spawn(&pid_, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(in[0]);
    close(out[1]);
    in_ = in[1];
    out_ = out[0];
    if (error != 0) throw io::io_error("cannot start " + command[0], error);
  }
  ~BareProgram() {
    close(in_);
    close(out_);
    waitpid(pid_, nullptr, 0);
  }
  BareProgram(const BareProgram&) = delete;
  BareProgram& operator=(const BareProgram&) = delete;

  void write(std::string_view bytes) const {
    if (::write(in_, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size()))
      throw io::io_error("cannot write to a pipe", errno);
  }
  void read(std::size_t size) {
    received_.resize(size);
    for (std::size_t got = 0; got < size;) {
      const ssize_t more = ::read(out_, received_.data() + got, size - got);
      if (more <= 0) throw io::io_error("cannot read from a pipe", errno);
      got += static_cast<std::size_t>(more);
    }
  }

 private:
  pid_t pid_ = -1;
  int in_ = -1;
  int out_ = -1;
  std::string received_;
};

// A FRAME of the size used in games of six against six.
std::string frame_bytes() {
  league::TeamFrame frame;
  for (int i = 0; i < kBenchedRobots; ++i) {
    frame.view.own.push_back({.number = i});
    frame.view.opponents.push_back({.number = i});
  }
  std::string bytes;
  league::make_team_codec(league::TeamEncoding::kFlat)->append(frame, bytes);
  return bytes;
}

double us_per_echo(const std::vector<std::string>& command, std::int64_t frames) {
  constexpr std::string_view kGreeting = "autoref-team 1 flat\n";
  constexpr std::size_t kAnswer_bytes =
      sizeof(league::FlatOutput) + kBenchedRobots * sizeof(league::FlatCommand);
  const std::string frame = frame_bytes();
  BareProgram a(command);
  BareProgram b(command);
  for (BareProgram* program : {&a, &b}) program->read(kGreeting.size());
  const ProgramsClock::time_point start = ProgramsClock::now();
  for (std::int64_t i = 0; i < frames; ++i) {
    a.write(frame);
    b.write(frame);
    a.read(kAnswer_bytes);
    b.read(kAnswer_bytes);
  }
  return us_since(start) / static_cast<double>(frames);
}

game::GameConfiguration game_between(const std::vector<std::string>& command) {
  game::GameConfiguration game;
  game.match.half_s = kProgramsHalf_s;
  game::TeamProgram program;
  program.command = command;
  game.a.program = game.b.program = program;
  return game;
}

constexpr std::size_t kMostCommands = 16;

struct Answer {
  league::FlatOutput output;
  std::array<league::FlatCommand, kMostCommands> commands;
};

// The robots drive in curves, so that they move in these games.
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

ProgramCosts measure_programs(int rounds, const std::vector<std::string>& command) {
  const game::GameConfiguration game = game_between(command);
  std::vector<double> games_us, echoes_us, ratios;
  for (int i = 0; i < rounds; ++i) {
    const ProgramsClock::time_point start = ProgramsClock::now();
    const game::GameRecord record =
        game::play(game, nullptr, game::make_program_or_registered_team);
    if (record.status != game::Status::kOk) throw std::logic_error(record.void_reason);
    games_us.push_back(us_since(start) / static_cast<double>(record.frames));
    echoes_us.push_back(us_per_echo(command, record.frames));
    ratios.push_back(games_us.back() / echoes_us.back());
  }
  ProgramCosts result{experiments::median(games_us), experiments::median(echoes_us),
                      experiments::median(ratios)};
  result.x_real_time = 1e6 / game.sim.frame_rate_hz / result.us_per_frame;
  return result;
}

void print_program_costs(const std::vector<std::string>& command) {
  const ProgramCosts result = measure_programs(kProgramsRounds, command);
  fmt::print("two programs          {:9.2f} us per frame, {:.0f} x real time\n",
             result.us_per_frame, result.x_real_time);
  fmt::print("bare pipes            {:9.2f} us per frame\n", result.echo_us_per_frame);
  fmt::print("ratio                 {:9.3f}   (median of {} rounds)\n", result.ratio,
             kProgramsRounds);
}

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

}  // namespace autoref::benchmarks
