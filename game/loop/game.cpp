#include "game/loop/game.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "game/loop/delay_line.hpp"
#include "game/loop/state_hash.hpp"
#include "game/loop/substitution.hpp"
#include "game/loop/team_controller.hpp"
#include "game/play_counts/chance.hpp"
#include "game/play_counts/play_statistics.hpp"
#include "sim/camera.hpp"
#include "soccer/team_view.hpp"
#include "soccer/tracks.hpp"
#include "tracking/tracker.hpp"

namespace autoref::game {
namespace {

PerSide<sim::TeamSpec> specs_of(const GameConfiguration& c) {
  return {{sim::TeamSpec{team_on(c, Side::kWest).robots},
           sim::TeamSpec{team_on(c, Side::kEast).robots}}};
}

PerSide<int> robots_of(const GameConfiguration& c) {
  const auto count = [&c](Side side) { return static_cast<int>(team_on(c, side).robots.size()); };
  return {{count(Side::kWest), count(Side::kEast)}};
}

// The reason for the end of the game if this event ends it, otherwise nullopt.
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

// Whether the decision stops play before the time is up.
bool is_stop(const referee::Decision& decision) {
  using referee::Event;
  const Event event = decision.finding.event;
  const bool is_time_up = event == Event::kHalfOver || event == Event::kGameOver ||
                          event == Event::kExtraTime || event == Event::kShootout;
  return decision.from == referee::State::kRun && decision.to != referee::State::kRun &&
         !is_time_up;
}

bool is_doubtful(const referee::Finding& finding) {
  return is_call(finding.event) && finding.confidence < kDoubtfulBelow;
}

}  // namespace

class Game::Impl {
 public:
  Impl(GameConfiguration configuration, const Observers& observers, const TeamMaker& make_team)
      : configuration_(std::move(configuration)),
        observers_(observers),
        most_frames_(static_cast<std::int64_t>(
            configuration_.longest_s.value_or(longest_s(configuration_.match)) * rate_hz())),
        world_(configuration_.field, configuration_.sim, specs_of(configuration_),
               configuration_.seed),
        camera_(configuration_.sim.vision, configuration_.field, rate_hz(), configuration_.seed),
        tracker_(referee_configuration(configuration_).noise),
        referee_(referee_configuration(configuration_)),
        situation_(configuration_.match.rules),
        substitution_controller_(configuration_.field, robots_of(configuration_),
                                 configuration_.match.rules.opponents_to_ball_m),
        tracks_(sim::split_latency(configuration_.sim).frames),
        statistics_(configuration_.field, configuration_.sim.ball, rate_hz(),
                    chance_model(configuration_.match.rules.name),
                    value_model(configuration_.match.rules.name)),
        players_{{TeamController(configuration_, Side::kWest, make_team),
                  TeamController(configuration_, Side::kEast, make_team)}} {
    if (configuration_.scene) scene_.emplace(*configuration_.scene, a());
    if (configuration_.start) begin_at(*configuration_.start);
  }

  bool begin_step() {
    if (is_over()) return false;
    if (is_controlled() && !given_) {
      void_game("match.control is game-controller, but no game controller is connected");
    } else if (record_.frames >= most_frames_) {
      void_game("the game exceeded its time limit");
    } else if (scene_ && scene_->is_late(time_s())) {
      void_game("play has not begun");
    } else {
      referee_frame();
      if (!is_over()) show_teams();
    }
    return is_still_played();
  }

  bool end_step() {
    move();
    return is_still_played();
  }

  void follow(const RefereeSignal& given) {
    const std::size_t noted = referee_.decisions().size();
    if (given.command_counter != signal_.command_counter) statistics_.note_command(given.command);
    signal_ = given;
    given_ = given;
    referee_.follow(given);
    for (const referee::Decision& decision : referee_.decisions().subspan(noted)) note(decision);
  }

  void put_ball(const sim::BallState& ball) { world_.put_ball(ball); }
  void put_robot(RobotId id, const sim::RobotState& state) { world_.put_robot(id, state); }
  void take_off(RobotId id) {
    substitution_controller_.keep_off(id, true);
    world_.take_off(id);
  }
  void put_on(RobotId id, const Vec2& position_m, const Vec2& heading) {
    substitution_controller_.keep_off(id, false);
    world_.put_on(id, position_m, heading);
  }

  bool is_over() const {
    const bool is_new_game =
        referee_.games_finished() > 0 && referee_.state() == referee::State::kWaitStop;
    const bool is_post_game = given_ && given_->stage == Stage::kPostGame;
    return referee_.is_over() || is_new_game || is_post_game || record_.status != Status::kOk ||
           (scene_ && scene_->is_over());
  }

  const GameConfiguration& configuration() const { return configuration_; }
  const Frame& frame() const { return frame_; }
  const RefereeSignal& signal() const { return signal_; }
  std::span<const referee::Decision> decisions() const { return referee_.decisions(); }
  const Tracks& tracks() const { return tracker_.tracks(); }
  const sim::World& world() const { return world_; }

  GameRecord record() const {
    GameRecord record = record_;
    // A void game may not have a final result.
    if (referee_.games_finished() == 0) take_result(record);
    const PerSide<PlayCounts> counts = statistics_.counts();
    record.counts = {counts[a()], counts[opponent_of(a())]};
    if (scene_) record.scene = scene_->record(record.goals_a, record.goals_b, counts[a()].xg);
    record.sim_s = time_s();
    record.ball_in_play_s = static_cast<double>(frames_in_play_) / rate_hz();
    record.state_hash = hash_.value();
    return record;
  }

 private:
  void begin_at(const StartState& start) {
    for (const Side side : kSides) put_robots(side, start.robots[side], cards_in(start, side));
    put_ball(start.ball);
    referee_.begin(start.referee);
    see_again(start.seen_before);
    if (start.ghost) ghost_.emplace(*start.ghost);
  }

  int cards_in(const StartState& start, Side side) const {
    const std::optional<RefereeSignal>& signal = start.referee.signal;
    const bool has_cards = signal && configuration_.match.rules.has(RuleId::kCards);
    return has_cards ? static_cast<int>(signal->yellow_left_s[side].size()) : 0;
  }

  // Only the robots that serve a yellow card, `cards` in number, may return later.
  void put_robots(Side side, const sim::RobotStates& robots, int cards) {
    const int count = robots_of(configuration_)[side];
    std::array<bool, kMaxRobots> is_on{};
    for (const sim::RobotState& robot : robots) {
      if (robot.number >= count)
        throw std::invalid_argument(
            fmt::format("the {} team has {} robots, but the start positions include robot {}",
                        name_of(side), count, robot.number));
      is_on.at(static_cast<std::size_t>(robot.number)) = true;
      put_robot({side, robot.number}, robot);
    }
    for (int number = 0; number < count; ++number) {
      if (is_on[static_cast<std::size_t>(number)]) continue;
      take_off({side, number});
      if (cards-- > 0) substitution_controller_.keep_off({side, number}, false);
    }
  }

  // Tracks the frames before the start and delays them as in a running game. For teams, they have
  // the number and the time of the first frame, as their first views in any game.
  void see_again(const std::vector<Frame>& frames) {
    auto next = frames.begin();
    const auto track_until = [&](double time_s) {
      for (; next != frames.end() && next->time_s <= time_s; ++next) tracker_.update(*next);
    };
    for (int number = -sim::split_latency(configuration_.sim).frames; number < 0; ++number) {
      track_until(number / rate_hz());
      if (next == frames.begin()) continue;
      Tracks tracks = tracker_.tracks();
      tracks.frame = 0;
      tracks.time_s = 0;
      tracks_.push(tracks);
    }
    track_until(0);
  }

  bool is_still_played() {
    if (is_over()) end_teams();
    return !is_over();
  }

  // Teams decide on estimates that are some frames old. This models the whole frames of the
  // latency.
  void show_teams() {
    const Tracks& tracks = tracks_.oldest();
    const Situation situation = situation_.update(
        signal_, tracks.ball ? std::optional(tracks.ball->position_m) : std::nullopt);
    for (Side side : kSides) players_[side].sense(frame_, world_.state());
    for (Side side : kSides) players_[side].prepare(tracks, signal_, situation);
  }

  void move() {
    PerSide<std::string> faults;
    for (Side side : kSides) {
      if (!ghost_ || ghost_->side() != side) faults[side] = players_[side].decide(commands_[side]);
      ended(side == Side::kWest ? Phase::kTeamWest : Phase::kTeamEast);
    }
    end_for(faults);
    substitution_controller_.act(signal_, requests(), frame_.time_s, world_);
    const bool is_held = signal_.placement && signal_.placement->by_hand;
    const auto placement = is_held ? signal_.placement : std::nullopt;
    observers_.call(&Observer::on_commands, commands_, placement, world_);
    world_.step(commands_, placement);
    if (ghost_) ghost_->move(time_after_step_s(), world_);
    if (!world_.is_finite()) void_game("a position in the world is not finite");
    ++record_.frames;
    ended(Phase::kPhysics);
    hash_.add(world_.state());
    ended(Phase::kRecord);
  }

  // Runs the camera, the tracker and the referee, and records the decisions.
  void referee_frame() {
    camera_.look(world_.state(), frame_);
    ended(Phase::kCamera);
    const PerSide<TeamRequests> asked = requests();
    observers_.call(&Observer::on_requests, asked);
    const referee::Referee::View view = referee_.see(frame_);
    if (view.tracks_begin_afresh) tracker_.begin_afresh();
    const Tracks& tracks = tracker_.update(view.frame);
    const RefereeSignal& own = referee_.judge(tracks, asked);
    signal_ = given_ ? *given_ : own;
    tracks_.push(tracks);
    for (const referee::Decision& decision : referee_.decisions()) note(decision);
    frames_in_play_ += referee_.is_ball_in_play() ? 1 : 0;
    ended(Phase::kReferee);
    if (signal_.stage != Stage::kShootout) count_play();
    if (scene_) {
      scene_->update({frame_.time_s, world_.state(), world_.touches(), referee_.decisions(),
                      referee_.state(), signal_});
    }
    ended(Phase::kRecord);
    if (!camera_.others().is_empty())
      observers_.call(&Observer::on_other_detections, camera_.others());
    observers_.call(&Observer::on_frame, frame_, signal_, world_);
  }

  void count_play() {
    statistics_.update({world_.state(), world_.touches(), referee_.decisions(),
                        referee_.state() == referee::State::kRun, referee_.is_ball_in_play()});
    for (const BallAction& action : statistics_.ended_actions())
      observers_.call(&Observer::on_action, action);
    for (const PossessionChain& chain : statistics_.ended_chains())
      observers_.call(&Observer::on_chain, chain);
    for (const Shot& shot : statistics_.ended_shots()) observers_.call(&Observer::on_shot, shot);
    observers_.call(&Observer::on_play, StateOfPlay{statistics_, signal_, world_.state()});
  }

  PerSide<TeamRequests> requests() const {
    return {{players_[Side::kWest].requests(), players_[Side::kEast].requests()}};
  }

  void note(const referee::Decision& decision) {
    hash_.add(decision);
    if (const auto reason = reason_of(decision.finding.event)) {
      record_.end_reason = *reason;
      take_result(record_);
    }
    ++record_.events[static_cast<std::size_t>(decision.finding.event)];
    record_.stops += is_stop(decision) ? 1 : 0;
    record_.doubtful_calls += is_doubtful(decision.finding) ? 1 : 0;
    if (std::find(record_.transitions.begin(), record_.transitions.end(), decision.transition) ==
        record_.transitions.end()) {
      record_.transitions.emplace_back(decision.transition);
    }
    observers_.call(&Observer::on_decision, decision);
  }

  void end_teams() {
    const GameRecord ended = record();
    for (const Side side : kSides) {
      const bool is_a = side == a();
      players_[side].end({std::string(name_of(ended.end_reason)),
                          is_a ? ended.goals_a : ended.goals_b,
                          is_a ? ended.goals_b : ended.goals_a});
    }
  }

  // Ends the game if a team has a fault. If both teams have a fault, neither wins.
  void end_for(const PerSide<std::string>& faults) {
    for (const Side side : kSides) {
      if (faults[side].empty()) continue;
      const bool is_a = side == a();
      const std::string reason = fmt::format("team {} {}", is_a ? 'a' : 'b', faults[side]);
      const bool is_forfeit =
          configuration_.match.on_team_fault == referee::OnTeamFault::kForfeit &&
          faults[opponent_of(side)].empty();
      if (!is_forfeit) return void_game(reason);
      end_game(Status::kForfeit, is_a ? EndReason::kForfeitA : EndReason::kForfeitB, reason);
    }
  }

  void void_game(const std::string& reason) { end_game(Status::kVoid, EndReason::kVoid, reason); }

  void end_game(Status status, EndReason end_reason, const std::string& reason) {
    if (record_.status == Status::kVoid) return;
    record_.status = status;
    record_.end_reason = end_reason;
    record_.void_reason = fmt::format("{} (at {:.3f} s)", reason, time_s());
  }

  // Copies the score from the referee, which resets it when a new game begins.
  void take_result(GameRecord& record) const {
    for (const PerSide<int>& goals : referee_.goals_by_half()) {
      record.goals_by_half.push_back({goals[a()], goals[opponent_of(a())]});
      record.goals_a += goals[a()];
      record.goals_b += goals[opponent_of(a())];
    }
    if (const std::optional<PerSide<int>> goals = referee_.shootout_goals()) {
      record.shootout = {(*goals)[a()], (*goals)[opponent_of(a())]};
    }
  }

  bool is_controlled() const {
    return configuration_.match.control == referee::Control::kGameController;
  }
  Side a() const { return configuration_.match.a_plays; }
  double rate_hz() const { return configuration_.sim.frame_rate_hz; }
  double time_s() const { return static_cast<double>(record_.frames) / rate_hz(); }
  double time_after_step_s() const { return static_cast<double>(record_.frames + 1) / rate_hz(); }

  void ended(Phase phase) { observers_.call(&Observer::on_phase, phase); }

  GameConfiguration configuration_;
  Observers observers_;
  std::int64_t most_frames_;
  sim::World world_;
  sim::Camera camera_;
  tracking::Tracker tracker_;
  referee::Referee referee_;
  SituationTracker situation_;
  SubstitutionController substitution_controller_;
  Frame frame_;
  RefereeSignal signal_;
  std::optional<RefereeSignal> given_;  // signal given by the game controller
  DelayLine<Tracks> tracks_;
  PlayStatistics statistics_;
  std::optional<SceneFollower> scene_;
  std::optional<GhostMover> ghost_;
  PerSide<TeamController> players_;
  PerSide<TeamCommands> commands_;
  StateHash hash_;
  std::int64_t frames_in_play_ = 0;
  GameRecord record_;
};

Game::Game(GameConfiguration configuration, const Observers& observers, const TeamMaker& make_team)
    : impl_(std::make_unique<Impl>(std::move(configuration), observers, make_team)) {}
Game::~Game() = default;
Game::Game(Game&&) noexcept = default;
Game& Game::operator=(Game&&) noexcept = default;

bool Game::step() { return begin_step() && end_step(); }
bool Game::begin_step() { return impl_->begin_step(); }
bool Game::end_step() { return impl_->end_step(); }
void Game::follow(const RefereeSignal& given) { impl_->follow(given); }
void Game::put_ball(const sim::BallState& ball) { impl_->put_ball(ball); }
void Game::put_robot(RobotId id, const sim::RobotState& state) { impl_->put_robot(id, state); }
void Game::take_off(RobotId id) { impl_->take_off(id); }
void Game::put_on(RobotId id, const Vec2& position_m, const Vec2& heading) {
  impl_->put_on(id, position_m, heading);
}
bool Game::is_over() const { return impl_->is_over(); }
const GameConfiguration& Game::configuration() const { return impl_->configuration(); }
const Frame& Game::frame() const { return impl_->frame(); }
const RefereeSignal& Game::signal() const { return impl_->signal(); }
std::span<const referee::Decision> Game::decisions() const { return impl_->decisions(); }
const Tracks& Game::tracks() const { return impl_->tracks(); }
const sim::World& Game::world() const { return impl_->world(); }
GameRecord Game::record() const { return impl_->record(); }

GameRecord play(const GameConfiguration& configuration, const Observers& observers,
                const TeamMaker& make_team) {
  Game game(configuration, observers, make_team);
  while (game.step()) {
  }
  return game.record();
}

}  // namespace autoref::game
