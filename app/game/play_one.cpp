#include "app/game/play_one.hpp"

#include <fmt/format.h>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "app/game/page_recorder.hpp"
#include "app/output_file.hpp"
#include "app/shared_options.hpp"
#include "experiments/results/game_report.hpp"
#include "game/loop/chain_log.hpp"
#include "game/loop/event_log.hpp"
#include "game/loop/game_configuration.hpp"
#include "game/loop/game_event_fields.hpp"
#include "game/loop/log_recorder.hpp"
#include "game/team_programs/program_games.hpp"
#include "io/build_id.hpp"
#include "io/csv.hpp"
#include "io/errors.hpp"
#include "io/table.hpp"
#include "io/terminal.hpp"
#include "io/words.hpp"
#include "league/simulator/simulator_command.hpp"
#include "live/frame_pacer.hpp"

namespace autoref::app {
namespace {

bool is_file_or_missing(const std::string& path) {
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(path, ignored);
  return !std::filesystem::exists(status) || std::filesystem::is_regular_file(status);
}

// The output files of a game.
struct GameFiles {
  GameFiles(const GameOutput& output, Appears appears)
      : events("--events", output.events, appears),
        game_events("--game-events", output.game_events, appears),
        chains("--chains", output.chains, appears),
        actions("--actions", output.actions, appears) {
    // At the end, a page that has grown is replaced by a smaller one.
    const bool grows = appears == Appears::kAtOnce && is_file_or_missing(output.view);
    if (grows) open_output(growing_view, "--view", output.view, io::FileKind::kGrowing);
    open_output(view, "--view", growing_view ? growing_view->path().string() : output.view,
                growing_view ? io::FileKind::kFile : io::FileKind::kFileOrPipe);
  }

  void begin() {
    for (LineOutput* file : {&events, &game_events, &chains, &actions}) file->begin();
  }

  void commit() {
    for (LineOutput* file : {&events, &game_events, &chains, &actions}) file->commit();
  }

  LineOutput events;
  LineOutput game_events;
  LineOutput chains;
  LineOutput actions;
  std::optional<io::PendingFile> view;
  std::optional<io::PendingFile> growing_view;
};

// When the user interrupted, in milliseconds of the steady clock; 0: never.
std::atomic<std::int64_t> interrupted_ms{0};
static_assert(std::atomic<std::int64_t>::is_always_lock_free);  // the handler uses it

// Programs such as timeout pass on a signal twice: to AutoRef and to its process group.
constexpr std::int64_t kSameInterrupt_ms = 500;

void end_soon(int signal) {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  const std::int64_t now_ms = 1000 * std::int64_t{now.tv_sec} + now.tv_nsec / 1'000'000;
  std::int64_t first_ms = 0;
  if (interrupted_ms.compare_exchange_strong(first_ms, now_ms)) return;
  if (now_ms - first_ms < kSameInterrupt_ms) return;
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

// Writes the game's files while it is played.
class GameOutputs final : public game::Observer {
 public:
  // `checks_interrupt`: whether on_frame() throws Interrupted after Ctrl-C.
  GameOutputs(GameFiles& files, const game::GameConfiguration& game, bool checks_interrupt)
      : files_(&files),
        checks_interrupt_(checks_interrupt),
        events_(game::event_game_of(game)),
        chain_columns_(game::chain_columns(events_, game.sim.frame_rate_hz)),
        action_columns_(game::action_columns(events_, game.sim.frame_rate_hz)) {
    note_interrupts();
    files.chains.add(io::csv_line(io::heads_of(chain_columns_)));
    files.actions.add(io::csv_line(io::heads_of(action_columns_)));
  }
  void on_frame(const Frame& frame, const RefereeSignal& /*signal*/,
                const sim::World& /*world*/) override {
    if (checks_interrupt_) check_interrupt();
    // The first frame may wait for teams without a limit; until then, no game has been played.
    if (frame.number > 0) files_->begin();
  }
  void on_decision(const referee::Decision& decision) override {
    if (files_->events.is_open()) files_->events.add(game::decision_json(decision, events_));
    if (files_->game_events.is_open()) add_game_event(decision);
  }
  void on_action(const game::BallAction& action) override {
    if (files_->actions.is_open())
      files_->actions.add(io::csv_line(io::cells_of(action_columns_, action)));
  }
  void on_chain(const game::PossessionChain& chain) override {
    if (!files_->chains.is_open()) return;
    const game::ChainRow row{++chains_, chain};
    files_->chains.add(io::csv_line(io::cells_of(chain_columns_, row)));
  }

 private:
  void add_game_event(const referee::Decision& decision) {
    const std::optional<GameEvent> event = game::game_event_of(decision);
    if (event) files_->game_events.add(game::game_event_json(*event));
  }

  GameFiles* files_;
  bool checks_interrupt_;
  game::EventGame events_;
  io::TableColumns<game::ChainRow> chain_columns_;
  io::TableColumns<game::BallAction> action_columns_;
  int chains_ = 0;  // number of chains so far
};

void check_record(const game::GameConfiguration& game) {
  if (!game::has_programs(game))
    throw io::InputError(
        {"--record"}, "",
        "neither team is a program or on the network, so there is nothing to record");
  if (game.match.control == referee::Control::kGameController)
    throw io::InputError({"--record"}, "",
                         "the game controller's commands are not recorded, so the game could not "
                         "be repeated; use --log");
}

void check_files(const game::GameConfiguration& game, const GameOutput& output,
                 const std::vector<std::string>& inputs) {
  if (!output.record.empty()) check_record(game);
  check_outputs({{"--events", output.events},
                 {"--game-events", output.game_events},
                 {"--chains", output.chains},
                 {"--actions", output.actions},
                 {"--log", output.log},
                 {"--view", output.view},
                 {"--record", output.record}},
                inputs);
}

void print_report(const experiments::GameReport& report, bool as_json) {
  fmt::print("{}\n", as_json ? experiments::json_of(report)
                             : io::wrapped(experiments::text_of(report), io::text_width(stdout)));
  std::fflush(stdout);
}

// Writes the page of the whole game.
void write_page(const game::GameRecord& record, PageRecorder& recorder, GameFiles& files) {
  if (!files.view) return;
  if (files.growing_view && recorder.is_full()) return recorder.grow();
  files.view->commit(recorder.page(record));
}

game::GamePrograms programs_of(const game::GameConfiguration& game, const GameOutput& output,
                               const RecordedCommands& commands, const GamePlayer& player) {
  if (!commands.file.empty() && game.match.control == referee::Control::kGameController)
    throw io::InputError({"--commands"}, "",
                         "recorded commands cannot repeat a game that a game controller commands");
  if (!commands.file.empty())
    return game::GamePrograms::recorded(game, commands.file, commands.kind);
  game::ProgramFiles files;
  files.commands = output.record;
  files.commands_kind = player.play ? io::FileKind::kGrowing : io::FileKind::kFileOrPipe;
  files.show_stderr = true;
  return game::GamePrograms::live(game, files, player.make_network_team);
}

}  // namespace

double speed_factor_in(const std::string& text, std::string_view others) {
  const std::optional<double> factor = io::number_in(text);
  if (factor && *factor >= league::kSlowestSimulation && *factor <= league::kFastestSimulation)
    return *factor;
  const char* separator = others.find(" or ") == std::string_view::npos ? " or " : ", ";
  throw io::InputError(
      {"--speed"}, "",
      fmt::format("expected a factor from {} to {}{}{}, found '{}'", league::kSlowestSimulation,
                  league::kFastestSimulation, separator, others, text));
}

// A signal handler may do very little, so it only sets a flag, which check_interrupt() reads. The
// exception unwinds the stack, which removes pending files.
void note_interrupts() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, end_soon);
}

bool is_interrupted() { return interrupted_ms != 0; }

void check_interrupt() {
  if (is_interrupted()) throw io::Interrupted();
}

void add_output_options(CLI::App& verb, GameOutput& output) {
  add_decision_outputs(verb, output.events, output.game_events);
  add_play_outputs(verb, output.chains, output.actions);
  verb.add_option("--log", output.log,
                  "Write the game to FILE as an SSL log; compressed if FILE ends in .gz.")
      ->type_name("FILE");
  verb.add_option("--view", output.view, "Write the game to FILE as an HTML page.")
      ->type_name("FILE");
  verb.add_option("--record", output.record,
                  "Write the commands of teams that are programs or on the network to FILE, for "
                  "play --commands.")
      ->type_name("FILE");
  add_web_flags(verb, output.web,
                "Show the game in browsers, at this address of this computer, such as "
                "127.0.0.1:8090; without an address, only for browsers on this computer.");
  add_json_flag(verb, output.json);
}

void add_speed_option(CLI::App& verb, GameOutput& output) {
  verb.add_option("--speed", output.speed,
                  "Speed relative to real time; max: as fast as possible. By default 1 with --web, "
                  "otherwise max.")
      ->type_name("FACTOR|max");
}

std::optional<double> pace_of(const game::GameConfiguration& game, const GameOutput& output) {
  const bool is_paced = !output.speed.empty() || !output.web.address.empty();
  if (!is_paced || output.speed == "max") return std::nullopt;
  return game.sim.frame_rate_hz * speed_factor_in(output.speed.empty() ? "1" : output.speed, "max");
}

game::PlayedGame play_game(const game::GameConfiguration& configuration,
                           const game::Observers& observers, game::GamePrograms& programs,
                           std::optional<double> frames_per_s) {
  game::Game game(programs.configured(configuration), observers, programs.maker());
  live::SteadyFrameClock clock;
  std::optional<live::FramePacer> pacer;
  if (frames_per_s) pacer.emplace(clock, *frames_per_s);
  do {
    if (pacer) pacer->wait();
    if (!programs.before_step(game)) return {game.record(), true};
  } while (game.step());
  return {game.record()};
}

game::GameRecord play_one(const game::GameConfiguration& game, const GameOutput& output,
                          const std::vector<std::string>& inputs, const RecordedCommands& commands,
                          const GamePlayer& player) {
  check_files(game, output, inputs);
  const std::optional<double> frames_per_s = pace_of(game, output);
  const bool is_repeatable = !player.play;
  GameFiles files(output, is_repeatable ? Appears::kAtEnd : Appears::kAtOnce);
  PageRecorder page(game, files.growing_view ? &*files.growing_view : nullptr);
  GameOutputs outputs(files, game, is_repeatable);
  GameOnWeb game_on_web(game, output.web);
  game::GamePrograms programs = programs_of(game, output, commands, player);
  // The log is opened last, since this truncates it.
  std::optional<game::LogRecorder> log;
  if (!output.log.empty()) log.emplace(output.log, game);
  game::Observers observers(game_on_web.observer());
  if (files.view) observers.add(&page);
  if (log) observers.add(&*log);
  observers.add(&outputs);
  const auto start = std::chrono::steady_clock::now();
  const game::PlayedGame played = player.play ? player.play(observers, programs)
                                              : play_game(game, observers, programs, frames_per_s);
  if (!programs.finish(played.record, played.is_interrupted)) {
    throw io::InputError({commands.file.string()}, "",
                         "its commands lead to a different final state: they come from another "
                         "game, other settings or another build");
  }
  const double wall_s =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  // Print before the files are completed, which may fail.
  print_report({game, played.record, wall_s, io::build_id(), played.is_interrupted}, output.json);
  game_on_web.end();
  if (log) log->close();
  write_page(played.record, page, files);
  files.commit();
  if (programs.is_truncated()) {
    io::write_message(stderr, fmt::format("autoref: {} is truncated, so the final state was not "
                                          "compared\n",
                                          commands.file.string()));
  }
  if (played.is_interrupted && commands.file.empty()) throw io::Interrupted();
  return played.record;
}

}  // namespace autoref::app
