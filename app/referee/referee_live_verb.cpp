#include <fmt/format.h>
#include <unistd.h>
#include <CLI/CLI.hpp>
#include <chrono>
#include <deque>
#include <memory>
#include <optional>

#include "app/game/page_recorder.hpp"
#include "app/game/play_one.hpp"
#include "app/network_flags.hpp"
#include "app/output_file.hpp"
#include "app/referee_game.hpp"
#include "app/shared_options.hpp"
#include "app/verbs.hpp"
#include "game/loop/event_log.hpp"
#include "game/loop/game_event_fields.hpp"
#include "game/settings/game_settings.hpp"
#include "io/errors.hpp"
#include "io/terminal.hpp"
#include "live/referee/referee_outputs.hpp"
#include "live/web/live_page.hpp"
#include "logs/log_game.hpp"
#include "logs/user_log.hpp"
#include "soccer/rules/rule_changes.hpp"

namespace autoref::app {
namespace {

struct RefereeLiveArguments : RefereeArguments {
  live::LiveRefereeOptions live;  // options except the controller
  bool broadcasts = false;        // broadcast instead of sending to multicast groups
  std::string game_controller;    // auto or HOST[:PORT]; empty: none
  WebFlags web;                   // where to show the game on the network
};

constexpr std::size_t kShownCalls = 8;
constexpr double kLongest_s = 1e9;
constexpr std::chrono::milliseconds kRedrawEvery{500};
constexpr const char* kNetwork = "network";  // names the source of settings in messages

// Shows the referee's work: a continuously redrawn view on a terminal, otherwise one line per call.
class RefereeScreen {
 public:
  explicit RefereeScreen(std::string prefix) : prefix_(std::move(prefix)) {}

  void report(const referee::Decision& decision) {
    const std::string line = live::call_line(decision);
    if (line.empty()) return;
    ++calls_;
    if (!is_terminal_) return io::write_message(stdout, fmt::format("{}{}\n", prefix_, line));
    if (lines_.size() == kShownCalls) lines_.pop_front();
    lines_.push_back(prefix_ + line);
  }

  void show(const live::LiveRefereeStatus& status) {
    const bool is_other_new =
        latest_.faults.of_other_referee == 0 && status.faults.of_other_referee > 0;
    latest_ = status;
    if (is_other_new && !is_terminal_) print_faults();
    const auto now = std::chrono::steady_clock::now();
    if (!is_terminal_ || now < due_) return;
    due_ = now + kRedrawEvery;
    io::write_message(stdout,
                      "\033[H\033[2J" + live::status_text(status, lines_, io::text_width(stdout)));
  }

  void end() const {
    io::write_message(stderr, fmt::format("autoref: {} frames, {} calls; {}\n", latest_.frames,
                                          calls_, live::text_of(latest_.vision)));
    print_faults();
    if (latest_.controller)
      io::write_message(stderr, fmt::format("autoref: game controller: {}\n",
                                            live::controller_line(*latest_.controller)));
  }

 private:
  void print_faults() const {
    for (const std::string& fault : logs::texts_of(latest_.faults))
      io::write_message(stderr, fmt::format("autoref: {}\n", fault));
  }

  std::string prefix_;  // such as "would call "
  bool is_terminal_ = ::isatty(STDOUT_FILENO) == 1;
  std::chrono::steady_clock::time_point due_{};
  std::deque<std::string> lines_;
  int calls_ = 0;
  live::LiveRefereeStatus latest_;
};

// Opens the page for watching the game. `names` and `field` are the initial values.
void open_page(std::optional<live::WebView>& page, const WebFlags& web, const Field& field,
               const PerSide<std::string>& names, const std::string& rules) {
  if (web.address.empty()) return;
  const view::GameRecording nothing_yet;
  page.emplace(web_options_of(web),
               view::PageContent{nothing_yet, field, names, {{"rules", rules}}});
  io::write_message(stderr, fmt::format("autoref: watch at {}\n", page->url()));
}

// Reports every few seconds that no packets are arriving.
class WaitingNote {
 public:
  explicit WaitingNote(const live::LiveRefereeOptions& options) : options_(options) {}

  void say(std::int64_t packets) {
    check_interrupt();
    const auto now = std::chrono::steady_clock::now();
    if (packets > 0) return;
    const std::chrono::duration<double> waited = now - begun_;
    if (options_.seconds > 0 && waited.count() > options_.seconds)
      throw io::InputError({"--seconds"}, "", fmt::format("no vision for {} s", options_.seconds));
    if (now < due_) return;
    due_ = now + std::chrono::seconds(5);
    io::write_message(
        stderr,
        fmt::format("autoref: waiting for vision at {}:{} on {} (--interface, --vision-port)\n",
                    live::kVisionGroup, options_.ports.vision, options_.interface));
  }

 private:
  const live::LiveRefereeOptions& options_;
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point due_ = begun_ + std::chrono::seconds(2);
};

// The outputs of a live referee's decisions.
class LiveRefereeOutput {
 public:
  LiveRefereeOutput(const RefereeLiveArguments& arguments, std::string prefix)
      : events_("--events", arguments.events, Appears::kAtOnce),
        game_events_("--game-events", arguments.game_events, Appears::kAtOnce),
        screen_(std::move(prefix)) {}

  // Shows the game to browsers at `web`, unless its address is empty.
  void show_page(const WebFlags& web, const Field& field, const PerSide<std::string>& names,
                 const RuleBook& rules) {
    events_of_game_ = logs::event_game_of(names, rules);
    open_page(page_, web, field, names,
              name_with_changes(rules.name, events_of_game_.rule_changes));
  }

  live::LiveRefereeCallbacks watch() {
    events_.begin();
    game_events_.begin();
    live::LiveRefereeCallbacks watch;
    watch.on_game_event = [this](const GameEvent& event) {
      game_events_.add(game::game_event_json(event));
    };
    watch.on_decision = [this](const referee::Decision& decision) {
      screen_.report(decision);
      events_.add(game::decision_json(decision, events_of_game_));
      if (page_) page_->add(recorded(decision));
    };
    watch.on_frame = [this](const Frame& frame, const RefereeSignal& signal) {
      if (page_) page_->add(frame, signal);
    };
    watch.on_idle = [this](const live::LiveRefereeStatus& status) {
      screen_.show(status);
      check_interrupt();
    };
    return watch;
  }

  void end() {
    if (page_) page_->end();
    screen_.end();
    events_.commit();
    game_events_.commit();
  }

 private:
  LineOutput events_;
  LineOutput game_events_;
  RefereeScreen screen_;
  game::EventGame events_of_game_;
  std::optional<live::WebView> page_;
};

game::GameSettings live_game_of(const RefereeLiveArguments& arguments, const std::string& book,
                                const game::Assignments& assignments,
                                const logs::RecordedFacts& facts) {
  RefereeLiveArguments chosen = arguments;
  if (chosen.control.empty()) chosen.control = "human";
  game::GameSettings game =
      game_of(chosen, book, assignments, facts, facts.games.front(), kNetwork);
  print_gaps(chosen, assignments, facts, game, kNetwork);
  if (!facts.last_signal && chosen.control == "human") {
    io::write_message(stderr,
                      fmt::format("autoref: no referee packets yet at {}:{}; AutoRef makes "
                                  "no calls before they arrive (or use --control autoref)\n",
                                  live::kRefereeGroup, arguments.live.ports.referee));
  }
  return game;
}

live::LiveRefereeOptions options_of(const RefereeLiveArguments& arguments) {
  live::LiveRefereeOptions options = arguments.live;
  options.commands = arguments.control == "autoref";
  if (!arguments.game_controller.empty())
    options.controller = event_address(arguments.game_controller);
  if (arguments.broadcasts) options.unicast = broadcast_of(options.interface);
  if (options.commands && options.controller)
    throw io::InputError({"--game-controller"}, "",
                         "AutoRef commands the game (--control autoref)");
  if (arguments.source == "tracker") options.source = league::FrameSource::kTracker;
  return options;
}

std::string call_prefix(const live::LiveRefereeOptions& options) {
  return options.commands || options.controller ? "" : "would call: ";
}

int referee_live_verb(const RefereeLiveArguments& arguments) {
  const game::Assignments assignments = game::assignments_in(arguments.sets);
  refuse_book_among(assignments);
  check_outputs({{"--events", arguments.events}, {"--game-events", arguments.game_events}}, {});
  const live::LiveRefereeOptions options = options_of(arguments);
  LiveRefereeOutput output(arguments, call_prefix(options));
  note_interrupts();
  live::LiveReferee referee(options);
  try {
    WaitingNote waiting(options);
    const logs::RecordedFacts facts =
        referee.gather([&](std::int64_t packets) { waiting.say(packets); });
    const std::string book = book_of(arguments, facts, kNetwork);
    const game::GameSettings game = live_game_of(arguments, book, assignments, facts);
    output.show_page(arguments.web, game.field, facts.names, game.match.rules);
    referee.run(game::referee_configuration(game::resolved(game)), facts, output.watch());
  } catch (const io::Interrupted&) {
    // The verb usually ends with this exception.
  }
  output.end();
  return io::kDone;
}

void add_referee_network_options(CLI::App& verb, RefereeLiveArguments& arguments) {
  live::LiveRefereeOptions& live = arguments.live;
  verb.add_option("--interface", live.interface,
                  "Address of the network interface; by default this computer only.")
      ->type_name("ADDRESS");
  const auto port = [&verb](const char* flag, int& number, const char* about) {
    verb.add_option(flag, number, about)->type_name("PORT")->check(CLI::Range(1, 65535));
  };
  port("--vision-port", live.ports.vision, "Port for vision packets, 10006 by default.");
  port("--referee-port", live.ports.referee, "Port of the referee packets, 10003 by default.");
  port("--tracker-port", live.ports.tracker, "Port of the tracker packets, 10010 by default.");
  verb.add_flag("--broadcast", arguments.broadcasts,
                "Send to all hosts of the interface's network instead of the multicast groups.");
  verb.add_option("--game-controller", arguments.game_controller,
                  "Report calls to the league's game controller at this address (port 10007); "
                  "auto: the computer that sends the referee packets.")
      ->type_name("auto|HOST[:PORT]");
  add_web_flags(verb, arguments.web,
                "Show the game to browsers at this address, such as 127.0.0.1:8090.");
  verb.add_option("--seconds", live.seconds, "Stop after S seconds.")
      ->type_name("S")
      ->check(CLI::Range(0.0, kLongest_s));
}

}  // namespace

void add_referee_live_verb(CLI::App& referee, Chosen& chosen) {
  CLI::App* verb =
      referee.add_subcommand("live", "Referee the game on the league's network until Ctrl-C.");
  auto arguments = std::make_shared<RefereeLiveArguments>();
  add_referee_network_options(*verb, *arguments);
  add_referee_options(*verb, *arguments, "default", "default");
  add_decision_outputs(*verb, arguments->events, arguments->game_events);
  verb->footer(
      "AutoRef only reports what it would call. With --game-controller it reports to the league's\n"
      "game controller; with --control autoref it commands the game itself.\n\n"
      "Field, lengths of halves, first kick-off and robots are taken from the packets if they\n"
      "contain them; anything missing is reported once, with the option that sets it. Yellow is\n"
      "west.\n\n"
      "Example:\n  autoref referee live --interface 192.168.1.20 --game-controller auto");
  choose(*verb, chosen, arguments, referee_live_verb);
}

}  // namespace autoref::app
