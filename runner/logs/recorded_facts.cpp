#include "runner/logs/recorded_facts.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "league/referee_message.hpp"
#include "runner/logs/logged_noise.hpp"
#include "runner/logs/recorded_game_events.hpp"

namespace autoref::runner {
namespace {

constexpr double kGap_s = 0.1;
constexpr double kClock_s = 0.1;  // resolution of a half's length

int half_of(Stage stage) {
  switch (stage) {
    case Stage::kFirstHalf:
      return 1;
    case Stage::kSecondHalf:
      return 2;
    default:
      return 0;
  }
}

bool is_after_a_draw(Stage stage) {
  return stage >= Stage::kExtraTimeBreak && stage <= Stage::kShootout;
}

// A name safe for display: at most 64 bytes, with question marks for anything but printable ASCII.
std::string name_text(std::string_view bytes) {
  constexpr std::size_t kLongest = 64;
  std::string text(bytes.substr(0, kLongest));
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return text;
}

class FactFinder final : public league::LogVisitor {
 public:
  void on_frame(const Frame& frame) override {
    noise.take(frame);
    for (const Side side : kSides) {
      facts.robots[side] =
          std::max(facts.robots[side], static_cast<int>(frame.robots[side].size()));
    }
  }

  void on_camera(double time_s, std::uint32_t number) override {
    RecordedCamera& camera = facts.cameras[number];
    if (camera.packets++ == 0) camera.first_s = camera.last_s = time_s;
    const double gap_s = time_s - camera.last_s;
    camera.longest_gap_s = std::max(camera.longest_gap_s, gap_s);
    camera.gaps += gap_s >= kGap_s ? 1 : 0;
    camera.last_s = time_s;
  }

  void on_referee(double time_s, const league::RefereePacket& packet) override {
    game_events.take(time_s, packet);
    const std::optional<RefereeSignal> signal = league::signal_of(packet);
    if (!signal) {
      ++facts.unknown_signals;
      return;
    }
    if (next_game_.begins_with(signal->stage) && facts.games.size() < RecordedFacts::kMostGames)
      facts.games.push_back({.begins_s = time_s});
    const bool is_new = !facts.last_signal ||
                        facts.last_signal->command_counter != signal->command_counter ||
                        facts.last_signal->command != signal->command;
    if (is_new) note_command({time_s, signal->command, signal->stage});
    note_stage(signal->stage);
    // In overtime or without a clock, the packet does not reveal the length of the half.
    if (packet.stage_time_left() > 0) note_clock(signal->stage, signal->stage_time_left_s);
    facts.names = {{name_text(packet.yellow().name()), name_text(packet.blue().name())}};
    facts.last_signal = signal;
  }

  RecordedFacts facts;
  LoggedNoise noise;
  RecordedGameEvents game_events;

 private:
  void note_command(const RecordedCommand& recorded) {
    RecordedGame& game = facts.games.back();
    if (recorded.command.kind == CommandKind::kPrepareKickoff && !game.first_kickoff)
      game.first_kickoff = recorded.command.side;
    if (facts.commands.size() < RecordedFacts::kMostCommands) {
      facts.commands.push_back(recorded);
    } else {
      ++facts.commands_left_out;
    }
  }

  void note_stage(Stage stage) {
    RecordedGame& game = facts.games.back();
    game.halves = std::max(game.halves, half_of(stage));
    game.is_knockout = game.is_knockout || is_after_a_draw(stage);
  }

  void note_clock(Stage stage, double left_s) {
    RecordedGame& game = facts.games.back();
    // Rounds up to the clock's resolution, since the first packet of a half may come a little late.
    const double rounded_s = std::ceil(left_s / kClock_s - 0.01) * kClock_s;
    const auto note = [rounded_s](std::optional<double>& length_s) {
      length_s = std::max(length_s.value_or(kClock_s), rounded_s);
    };
    if (stage == Stage::kFirstHalf) note(game.half_s);
    if (stage == Stage::kExtraFirstHalf) note(game.extra_half_s);
  }

  NextGame next_game_;
};

}  // namespace

bool NextGame::begins_with(Stage stage) {
  // Hysteresis: only a stage from half-time on arms the detector, so a correction from the first
  // half back to its preparation does not begin a new game.
  const bool begins = stage <= Stage::kFirstHalf && latest_ >= Stage::kHalfTime;
  latest_ = begins ? stage : std::max(latest_, stage);
  return begins;
}

double RecordedCamera::rate_hz() const {
  return last_s > first_s ? static_cast<double>(packets - 1) / (last_s - first_s) : 0;
}

RecordedFacts facts_of(const std::filesystem::path& log, league::FrameSource source) {
  FactFinder finder;
  finder.facts.log = league::read_log(log, finder, source);
  finder.facts.noise = finder.noise.noise();
  finder.facts.game_events = finder.game_events.events();
  return finder.facts;
}

}  // namespace autoref::runner
