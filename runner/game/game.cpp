#include "runner/game/game.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "runner/game/play_counts/play_statistics.hpp"
#include "runner/game/state_hash.hpp"
#include "runner/game/substitution.hpp"
#include "runner/game/team_controller.hpp"
#include "runner/game/vision_delay.hpp"
#include "runner/settings/match_rules.hpp"
#include "runner/settings/robot_changes.hpp"
#include "sim/camera.hpp"
#include "soccer/situation.hpp"
#include "soccer/tracks.hpp"
#include "strategies/registry.hpp"

namespace autoref::runner {
namespace {

PerSide<sim::TeamSpec> specs_of(const GameConfiguration& c) {
  return {{spec_of(c, team_on(c, Side::kWest)), spec_of(c, team_on(c, Side::kEast))}};
}

// Why the game ends with the event; none where it goes on.
std::optional<EndReason> reason_of(referee::Event event) {
  switch (event) {
    case referee::Event::kGameOver:
      return EndReason::kTime;
    case referee::Event::kGoalLead:
      return EndReason::kGoals;
    case referee::Event::kShootoutOver:
      return EndReason::kShootout;
    default:
      return std::nullopt;
  }
}

class Game {
 public:
  Game(const GameConfiguration& c, Observer* observer, const TeamMaker& make_team)
      : configuration_(c),
        observer_(observer),
        world_(c.field, c.sim, specs_of(c), c.seed),
        camera_(c.sim.vision, c.field, c.sim.frame_rate_hz, c.seed),
        referee_(referee_configuration(c)),
        situation_(rules_of(c.match)),
        substitution_controller_(
            c.field, {{team_on(c, Side::kWest).robots, team_on(c, Side::kEast).robots}}),
        tracks_(sim::split_latency(c.sim).frames),
        statistics_(c.field, c.sim.ball, c.sim.frame_rate_hz),
        players_{{TeamController(c, Side::kWest, make_team),
                  TeamController(c, Side::kEast, make_team)}} {}

  GameRecord play() {
    const auto most_frames = static_cast<std::int64_t>(longest_s(configuration_.match) *
                                                       configuration_.sim.frame_rate_hz);
    while (!is_over() && record_.status == Status::kOk) {
      if (record_.frames >= most_frames) {
        void_game("the game did not come to its end");
      } else {
        play_frame();
      }
    }
    finish();
    return record_;
  }

 private:
  void play_frame() {
    const RefereeSignal& signal = referee_frame();
    if (is_over()) return;
    const Tracks& tracks = tracks_.oldest();
    const Situation situation = situation_.update(
        signal, tracks.ball ? std::optional(tracks.ball->position_m) : std::nullopt);
    for (Side side : kSides) {
      const std::string fault = players_[side].decide(tracks, signal, situation, commands_[side]);
      if (!fault.empty()) void_game(fmt::format("team {} {}", letter_of(side), fault));
      ended(side == Side::kWest ? Phase::kTeamWest : Phase::kTeamEast);
    }
    substitution_controller_.act(signal, requests(), frame_.time_s, world_);
    world_.step(commands_, signal.placement);
    if (!world_.is_finite()) void_game("a position in the world is not finite");
    ++record_.frames;
    ended(Phase::kPhysics);
    hash_.add(world_.state());
    ended(Phase::kRecord);
  }

  // Camera and referee; decisions go into the record.
  const RefereeSignal& referee_frame() {
    camera_.look(world_.state(), frame_);
    ended(Phase::kCamera);
    const PerSide<TeamRequests> asked = requests();
    if (observer_ != nullptr) observer_->on_requests(asked);
    const RefereeSignal& signal = referee_.update(frame_, asked);
    tracks_.push(referee_.tracks());
    for (const referee::Decision& decision : referee_.decisions()) note(decision);
    frames_in_play_ += referee_.is_ball_in_play() ? 1 : 0;
    ended(Phase::kReferee);
    if (signal.stage != Stage::kShootout) count_play();
    ended(Phase::kRecord);
    if (observer_ != nullptr) observer_->on_frame(frame_, signal, world_);
    return signal;
  }

  void count_play() {
    statistics_.update({world_.state(), world_.touches(), referee_.decisions(),
                        referee_.state() == referee::State::kRun, referee_.is_ball_in_play()});
  }

  PerSide<TeamRequests> requests() const {
    return {{players_[Side::kWest].requests(), players_[Side::kEast].requests()}};
  }

  void note(const referee::Decision& decision) {
    hash_.add(decision);
    if (const auto reason = reason_of(decision.finding.event)) {
      record_.end_reason = *reason;
      take_result();
    }
    ++record_.events[static_cast<std::size_t>(decision.finding.event)];
    if (std::find(record_.transitions.begin(), record_.transitions.end(), decision.transition) ==
        record_.transitions.end()) {
      record_.transitions.emplace_back(decision.transition);
    }
    if (observer_ != nullptr) observer_->on_decision(decision);
  }

  void void_game(const std::string& reason) {
    if (record_.status == Status::kVoid) return;
    record_.status = Status::kVoid;
    record_.end_reason = EndReason::kVoid;
    record_.void_reason = fmt::format("{} (at {:.3f} s)", reason, time_s());
  }

  // Where a new game follows, the record ends once the referee has begun it.
  bool is_over() const {
    const bool is_new_game =
        referee_.games_finished() > 0 && referee_.state() == referee::State::kWaitStop;
    return referee_.is_over() || is_new_game;
  }

  void finish() {
    // A void game has come to no end.
    if (referee_.games_finished() == 0) take_result();
    const Side a = configuration_.match.a_plays;
    const PerSide<PlayCounts> counts = statistics_.counts();
    record_.counts = {counts[a], counts[opponent_of(a)]};
    record_.sim_s = time_s();
    record_.ball_in_play_s =
        static_cast<double>(frames_in_play_) / configuration_.sim.frame_rate_hz;
    record_.state_hash = hash_.value();
  }

  // Before the referee forgets it in a new game.
  void take_result() {
    const Side a = configuration_.match.a_plays;
    for (const PerSide<int>& goals : referee_.goals_by_half()) {
      record_.goals_by_half.push_back({goals[a], goals[opponent_of(a)]});
      record_.goals_a += goals[a];
      record_.goals_b += goals[opponent_of(a)];
    }
    if (const std::optional<PerSide<int>> goals = referee_.shootout_goals()) {
      record_.shootout = {(*goals)[a], (*goals)[opponent_of(a)]};
    }
  }

  double time_s() const {
    return static_cast<double>(record_.frames) / configuration_.sim.frame_rate_hz;
  }

  char letter_of(Side side) const { return side == configuration_.match.a_plays ? 'a' : 'b'; }

  void ended(Phase phase) {
    if (observer_ != nullptr) observer_->on_phase(phase);
  }

  const GameConfiguration& configuration_;
  Observer* observer_;
  sim::World world_;
  sim::Camera camera_;
  referee::Referee referee_;
  SituationTracker situation_;
  SubstitutionController substitution_controller_;
  Frame frame_;
  DelayLine tracks_;
  PlayStatistics statistics_;
  PerSide<TeamController> players_;
  PerSide<TeamCommands> commands_;
  StateHash hash_;
  std::int64_t frames_in_play_ = 0;
  GameRecord record_;
};

}  // namespace

std::string_view name_of(EndReason reason) {
  static constexpr std::array<std::string_view, 6> kNames = {"time",      "goals",     "shootout",
                                                             "forfeit_a", "forfeit_b", "void"};
  return kNames[static_cast<std::size_t>(reason)];
}

std::string_view name_of(Status status) {
  static constexpr std::array<std::string_view, 3> kNames = {"ok", "forfeit", "void"};
  return kNames[static_cast<std::size_t>(status)];
}

std::unique_ptr<strategies::Strategy> make_registered_team(const std::string& name,
                                                           const strategies::TeamContext& context) {
  const strategies::Entry* entry = strategies::find_strategy(name);
  if (entry == nullptr) throw std::invalid_argument(fmt::format("unknown strategy '{}'", name));
  return entry->make(context);
}

GameRecord play(const GameConfiguration& configuration, Observer* observer,
                const TeamMaker& make_team) {
  return Game(configuration, observer, make_team).play();
}

}  // namespace autoref::runner
