#include "logs/recorded_facts.hpp"

#include <algorithm>
#include <cmath>

#include "io/words.hpp"
#include "league/referee_message.hpp"
#include "logs/facts_collector.hpp"

namespace autoref::logs {
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

void FactsCollector::on_frame(const Frame& frame) {
  noise_.add(frame);
  facts_.has_ball = facts_.has_ball || frame.ball.has_value();
  for (const Side side : kSides) {
    facts_.robots[side] =
        std::max(facts_.robots[side], static_cast<int>(frame.robots[side].size()));
  }
}

void FactsCollector::on_vision(double time_s, const league::VisionPacket& packet) {
  if (!packet.has_detection()) return;
  RecordedCamera& camera = facts_.cameras[packet.detection().camera_id()];
  if (camera.packets++ == 0) camera.first_s = camera.last_s = time_s;
  const double gap_s = time_s - camera.last_s;
  camera.longest_gap_s = std::max(camera.longest_gap_s, gap_s);
  camera.gaps += gap_s >= kGap_s ? 1 : 0;
  camera.last_s = time_s;
}

void FactsCollector::on_referee(double time_s, const league::RefereePacket& packet) {
  game_events_.add(time_s, packet);
  const std::optional<RefereeSignal> signal = league::signal_of(packet);
  if (!signal) {
    ++facts_.unknown_signals;
    return;
  }
  if (next_game_.begins_with(signal->stage) && facts_.games.size() < RecordedFacts::kMostGames)
    facts_.games.push_back({.begins_s = time_s});
  const bool is_new = !facts_.last_signal ||
                      facts_.last_signal->command_counter != signal->command_counter ||
                      facts_.last_signal->command != signal->command;
  if (is_new) note_command({time_s, signal->command, signal->stage});
  note_stage(signal->stage);
  // In overtime or without a clock, the packet does not reveal the length of the half.
  if (packet.stage_time_left() > 0) note_clock(signal->stage, signal->stage_time_left_s);
  facts_.names = {{io::printable(packet.yellow().name()), io::printable(packet.blue().name())}};
  facts_.last_signal = signal;
}

void FactsCollector::note_command(const RecordedCommand& recorded) {
  RecordedGame& game = facts_.games.back();
  if (recorded.command.kind == CommandKind::kPrepareKickoff && !game.first_kickoff)
    game.first_kickoff = recorded.command.side;
  if (facts_.commands.size() < RecordedFacts::kMostCommands) {
    facts_.commands.push_back(recorded);
  } else {
    ++facts_.commands_left_out;
  }
}

void FactsCollector::note_stage(Stage stage) {
  RecordedGame& game = facts_.games.back();
  game.halves = std::max(game.halves, half_of(stage));
  game.is_knockout = game.is_knockout || is_after_a_draw(stage);
}

void FactsCollector::note_clock(Stage stage, double left_s) {
  RecordedGame& game = facts_.games.back();
  // Rounds up to the clock's resolution, since the first packet of a half may come a little late.
  const double rounded_s = std::ceil(left_s / kClock_s - 0.01) * kClock_s;
  const auto note = [rounded_s](std::optional<double>& length_s) {
    length_s = std::max(length_s.value_or(kClock_s), rounded_s);
  };
  if (stage == Stage::kFirstHalf) note(game.half_s);
  if (stage == Stage::kExtraFirstHalf) note(game.extra_half_s);
}

RecordedFacts FactsCollector::facts(const league::LogSummary& log) const {
  RecordedFacts facts = facts_;
  facts.log = log;
  facts.noise = noise_.noise();
  facts.game_events = game_events_.events();
  return facts;
}

RecordedFacts facts_of(const std::filesystem::path& log, league::FrameSource source) {
  FactsCollector collector;
  const league::LogSummary summary = league::read_log(log, collector, source);
  return collector.facts(summary);
}

}  // namespace autoref::logs
