// Writes games as logs, reads them back, and cuts them into pieces that begin anywhere. Checks
// whether AutoRef, running alongside the recorded referee, makes the same calls in a piece as in
// the whole game.
//
//   log_pieces FOLDER [GAMES]     GAMES per rule book and camera preset (default 3); logs go to
//   FOLDER
//
// Prints the Markdown tables of results/reference/log-pieces.md and, on stderr, every call that
// differs. The exit code is 1 if fewer than 99 % of the calls agree, or if a call was made in a
// stop without a signal.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "game/loop/game.hpp"
#include "game/loop/game_configuration.hpp"
#include "game/loop/log_recorder.hpp"
#include "game/settings/fields.hpp"
#include "game/settings/game_settings.hpp"
#include "logs/log_game.hpp"
#include "logs/log_referee.hpp"
#include "soccer/random.hpp"
#include "tools/log_pieces/piece_calls.hpp"

namespace autoref::tools {
namespace {

constexpr double kShortest_s = 10;
constexpr double kLongest_s = 60;
constexpr double kHalf_s = 120;
const std::vector<std::string> kBooks = {"paper", "2014", "2026-b"};
const std::vector<std::string> kTeams = {"cobalt1", "counter", "possession", "zone", "shadow"};

// Writes a game's log and stores its calls.
class Recorder final : public game::LogRecorder {
 public:
  using LogRecorder::LogRecorder;
  void on_decision(const referee::Decision& decision) override {
    LogRecorder::on_decision(decision);
    calls.add(decision);
  }

  CallList calls;
};

game::GameSettings settings_of(const std::string& book, const std::string& camera, int number) {
  game::GameSettings game;
  game::choose_rules(book, game);
  game::set_by_path(game, "sim.camera", camera);
  game.match.half_s = kHalf_s;
  const auto index = static_cast<std::size_t>(number);
  game.a.strategy = kTeams[index % kTeams.size()];
  game.b.strategy = kTeams[(index / kTeams.size() + index + 1) % kTeams.size()];
  game.seed = mix_bits(static_cast<std::uint64_t>(number) + 1);
  return game;
}

// The records from `from_s` to `to_s`, counted from the first record of the log.
void cut(const std::string& log, double from_s, double to_s, const std::string& piece) {
  league::LogReader reader(log);
  league::LogWriter writer(piece);
  league::LogRecord record;
  std::optional<std::int64_t> first_ns;
  while (reader.read(record)) {
    if (!first_ns) first_ns = record.time_ns;
    const double time_s = static_cast<double>(record.time_ns - *first_ns) / 1e9;
    if (time_s < from_s - 1e-6 || time_s >= to_s) continue;
    writer.write(record.time_ns, static_cast<league::MessageKind>(record.kind), record.message);
  }
  writer.close();
}

CallList judged(const std::string& log, const std::string& book, const std::string& camera) {
  const logs::RecordedFacts facts = logs::facts_of(log);
  game::GameSettings game = logs::logged_game(book, facts, facts.games.front());
  game::set_by_path(game, "sim.camera", camera);
  CallList calls;
  logs::referee_log(log, facts, {game::referee_configuration(game::resolved(game))},
                    [&calls](const referee::Decision& decision) { calls.add(decision); });
  return calls;
}

// Judges a game's log as a whole and in pieces.
void judge_game(const std::string& folder, const std::string& book, const std::string& camera,
                int number, Tally& whole, Tally& pieces) {
  const game::GameSettings game = settings_of(book, camera, number);
  const game::GameConfiguration configuration = game::resolved(game);
  const std::string log = folder + "/whole.log";
  Recorder recorder(log, configuration);
  const game::GameRecord record = game::play(configuration, &recorder);
  recorder.close();
  whole.add(recorder.calls, judged(log, book, camera), {0, record.sim_s, 0});
  RandomStream chance(game.seed);
  double from_s = chance.uniform() * kShortest_s;
  while (from_s + kShortest_s < record.sim_s) {
    const double length_s = kShortest_s + chance.uniform() * (kLongest_s - kShortest_s);
    // A frame's number determines its time, so a piece begins with a frame.
    const double first_s =
        std::ceil(from_s * configuration.sim.frame_rate_hz) / configuration.sim.frame_rate_hz;
    const std::string piece = folder + "/piece.log";
    cut(log, first_s, from_s + length_s, piece);
    const double to_s = std::min(from_s + length_s, record.sim_s);
    pieces.name = fmt::format("{} {} {} at {:.3f}", book, camera, number, first_s);
    pieces.add(recorder.calls, judged(piece, book, camera).later(first_s), {first_s, to_s, 2});
    from_s += length_s;
  }
}

// Prints a table and returns the sum of its rows.
Tally print_table(const std::map<std::string, Tally>& tallies) {
  Tally all;
  fmt::print("{}", Tally::heading());
  for (const auto& [name, tally] : tallies) {
    fmt::print("{}", tally.row(name));
    all += tally;
  }
  fmt::print("{}", all.row("all | "));
  return all;
}

bool print_tables(const std::map<std::string, Tally>& whole,
                  const std::map<std::string, Tally>& pieces) {
  fmt::print(
      "# Calls from logs beside the recorded referee\n\n"
      "Written by `scripts/judge-log-pieces`. Games of two halves of {} s between different teams "
      "are\n"
      "written as logs. AutoRef judges each log with `match.control: human`, whole and cut into "
      "pieces.\n"
      "Its calls are compared with those of the game as it was played: the same event and side "
      "within\n"
      "0.1 s. In a piece, calls count from its third second on. Calls whose evidence begins before "
      "the\n"
      "piece are counted apart; for pushing and dribbling this takes an upper bound of their "
      "duration,\n"
      "so AutoRef may know more than is assumed.\n\n"
      "## Whole logs\n\n",
      kHalf_s);
  const bool whole_is_good = print_table(whole).is_good();
  fmt::print("\n## Pieces of {} to {} s\n\n", kShortest_s, kLongest_s);
  return print_table(pieces).is_good() && whole_is_good;
}

int main_of(const std::string& folder, int games) {
  std::filesystem::create_directories(folder);
  std::map<std::string, Tally> whole;
  std::map<std::string, Tally> pieces;
  int number = 0;
  for (const std::string& book : kBooks) {
    for (const std::string& camera : camera_names()) {
      const std::string name = fmt::format("{} | {}", book, camera);
      for (int i = 0; i < games; ++i)
        judge_game(folder, book, camera, number++, whole[name], pieces[name]);
    }
  }
  return print_tables(whole, pieces) ? 0 : 1;
}

}  // namespace
}  // namespace autoref::tools

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  return autoref::tools::main_of(argv[1], argc > 2 ? std::atoi(argv[2]) : 3);
}
