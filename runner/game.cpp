#include "runner/game.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "referee/shootout.hpp"
#include "runner/robot_changes.hpp"
#include "runner/state_hash.hpp"
#include "runner/substitution.hpp"
#include "sim/camera.hpp"
#include "soccer/random.hpp"
#include "soccer/situation.hpp"
#include "soccer/team_view.hpp"
#include "soccer/tracks.hpp"
#include "strategies/registry.hpp"

namespace autoref::runner {
namespace {

// Beyond its halves and breaks a game may take this long: waiting for clients and restarts.
constexpr double kSlack_s = 300;

// Where the clock stands while play is stopped, a game may take this many times its halves. A stop
// has two waits of 15 s at most, so that games whose plays last 3.3 s on average come to their end.
constexpr double kStandstill = 10;

const TeamConfiguration& team_on(const GameConfiguration& c, Side side) {
  return side == c.match.a_plays ? c.a : c.b;
}

PerSide<sim::TeamSheet> sheets_of(const GameConfiguration& c) {
  return {{sheet_of(c, team_on(c, Side::kWest)), sheet_of(c, team_on(c, Side::kEast))}};
}

referee::Configuration referee_configuration(const GameConfiguration& c) {
  referee::Configuration configuration;
  configuration.field = c.field;
  configuration.rules = rules_of(c.match);
  for (const Side side : kSides) configuration.robots[side] = team_on(c, side).robots;
  configuration.half_s = c.match.half_s;
  configuration.halves = c.match.halves;
  configuration.break_s = c.match.break_s;
  configuration.knockout = c.match.knockout;
  configuration.first_kickoff = c.match.first_kickoff;
  configuration.noise = {c.sim.vision.ball_noise_m, c.sim.vision.robot_noise_m,
                         c.sim.vision.robot_noise_rad};
  return configuration;
}

double longest_shootout_s(const RuleBook& rules) {
  const double kick_s = 2 * rules.ready_timeout_s + rules.penalty_time_s;
  return 2 * referee::kMostShootoutKicks * kick_s;
}

// A game that takes longer will not come to its end.
double longest_s(const MatchConfiguration& match) {
  const RuleBook rules = rules_of(match);
  const double stretch = rules.clock_stops ? kStandstill : 1;
  double longest_s = match.halves * (match.half_s * stretch + match.break_s) + kSlack_s;
  if (rules.has(RuleId::kTimeouts)) longest_s += 2 * (rules.timeouts_s + rules.extra_timeouts_s);
  if (!match.knockout) return longest_s;
  return longest_s + 2 * match.extra_half_s * stretch + 3 * match.break_s +
         longest_shootout_s(rules);
}

EndReason reason_of(referee::Event end) {
  if (end == referee::Event::kGoalLead) return EndReason::kGoals;
  return end == referee::Event::kShootoutOver ? EndReason::kShootout : EndReason::kTime;
}

std::unique_ptr<strategies::Strategy> make_team_on(const GameConfiguration& c, Side side,
                                                   const TeamMaker& make_team) {
  const TeamConfiguration& team = team_on(c, side);
  return make_team(team.strategy,
                   {c.field, rules_of(c.match), c.sim.frame_rate_hz,
                    RandomStream::of(c.seed, RandomPurpose::kStrategy, side), team.params});
}

// From a picture until the orders decided on it move a robot.
double latency_s(const sim::Configuration& c) {
  const sim::LatencySplit split = sim::split_latency(c);
  return (split.frames + static_cast<double>(split.substeps) / c.substeps) / c.frame_rate_hz;
}

// A team on the field: it sees delayed pictures, and its mistakes end the game as void.
class Player {
 public:
  Player(const GameConfiguration& c, Side side, const TeamMaker& make_team)
      : side_(side), robots_(team_on(c, side).robots), strategy_(make_team_on(c, side, make_team)) {
    view_.latency_s = latency_s(c.sim);
  }

  // Fills `orders`; returns what went wrong, empty where nothing did. Then all orders are zero.
  std::string decide(const Tracks& tracks, const RefereeSignal& signal, const Situation& situation,
                     TeamOrders& orders) {
    orders.fill(RobotCommand{});
    fill_view(tracks, signal, situation, side_, view_);
    std::string fault;
    try {
      strategy_->decide(view_, orders);
      requests_ = strategy_->requests();
      fault = fault_in(orders);
    } catch (const std::exception& error) {
      fault = fmt::format("threw: {}", error.what());
    } catch (...) {
      fault = "threw something that is no std::exception";
    }
    if (!fault.empty()) orders.fill(RobotCommand{});
    return fault;
  }

  // What the team asked for with its last decision.
  const TeamRequests& requests() const { return requests_; }

 private:
  std::string fault_in(const TeamOrders& orders) const {
    for (int number = 0; number < robots_; ++number) {
      if (!is_finite(orders[static_cast<std::size_t>(number)])) {
        return fmt::format("ordered a number that is not finite for robot {}", number);
      }
    }
    return {};
  }

  Side side_;
  int robots_;
  std::unique_ptr<strategies::Strategy> strategy_;
  TeamRequests requests_;
  TeamView view_;
};

// The tracks of the last few pictures, so that teams see the field as it was.
class DelayLine {
 public:
  explicit DelayLine(int frames) : tracks_(static_cast<std::size_t>(frames) + 1) {}

  void push(const Tracks& tracks) {
    tracks_[taken_ % tracks_.size()] = tracks;
    ++taken_;
  }
  // As many pictures back as the line is long; the first one until there are that many.
  const Tracks& oldest() const {
    return taken_ < tracks_.size() ? tracks_.front() : tracks_[taken_ % tracks_.size()];
  }

 private:
  std::vector<Tracks> tracks_;
  std::size_t taken_ = 0;
};

class Game {
 public:
  Game(const GameConfiguration& c, Observer* observer, const TeamMaker& make_team)
      : configuration_(c),
        observer_(observer),
        world_(c.field, c.sim, sheets_of(c), c.seed),
        camera_(c.sim.vision, c.field, c.sim.frame_rate_hz, c.seed),
        referee_(referee_configuration(c)),
        situation_(rules_of(c.match)),
        assistant_(c.field, {{team_on(c, Side::kWest).robots, team_on(c, Side::kEast).robots}}),
        tracks_(sim::split_latency(c.sim).frames),
        players_{{Player(c, Side::kWest, make_team), Player(c, Side::kEast, make_team)}} {}

  GameRecord play() {
    const auto most_frames = static_cast<std::int64_t>(longest_s(configuration_.match) *
                                                       configuration_.sim.frame_rate_hz);
    while (!referee_.is_over() && record_.status == Status::kOk) {
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
    const RefereeSignal& signal = judge();
    if (referee_.is_over()) return;
    const Tracks& tracks = tracks_.oldest();
    const Situation situation = situation_.update(
        signal, tracks.ball ? std::optional(tracks.ball->position_m) : std::nullopt);
    for (Side side : kSides) {
      const std::string fault = players_[side].decide(tracks, signal, situation, orders_[side]);
      if (!fault.empty()) void_game(fmt::format("team {} {}", letter_of(side), fault));
      ended(side == Side::kWest ? Phase::kTeamWest : Phase::kTeamEast);
    }
    assistant_.act(signal, requests(), frame_.time_s, world_);
    world_.step(orders_, signal.placement);
    if (!world_.is_finite()) void_game("a position in the world is not finite");
    ++record_.frames;
    ended(Phase::kPhysics);
    hash_.add(world_.state());
    ended(Phase::kRecord);
  }

  // Camera and referee; decisions go into the record.
  const RefereeSignal& judge() {
    camera_.look(world_.state(), frame_);
    ended(Phase::kCamera);
    const RefereeSignal& signal = referee_.update(frame_, requests());
    tracks_.push(referee_.tracks());
    for (const referee::Decision& decision : referee_.decisions()) note(decision);
    frames_in_play_ += referee_.is_ball_in_play() ? 1 : 0;
    ended(Phase::kReferee);
    if (observer_ == nullptr) return signal;
    observer_->on_requests(requests());
    observer_->on_frame(frame_, signal, world_);
    return signal;
  }

  PerSide<TeamRequests> requests() const {
    return {{players_[Side::kWest].requests(), players_[Side::kEast].requests()}};
  }

  void note(const referee::Decision& decision) {
    hash_.add(decision);
    if (decision.to == referee::State::kOver) record_.end_reason = reason_of(decision.event);
    ++record_.events[static_cast<std::size_t>(decision.event)];
    if (std::find(record_.arrows.begin(), record_.arrows.end(), decision.arrow) ==
        record_.arrows.end()) {
      record_.arrows.push_back(decision.arrow);
    }
    if (observer_ != nullptr) observer_->on_decision(decision);
  }

  void void_game(const std::string& reason) {
    if (record_.status == Status::kVoid) return;
    record_.status = Status::kVoid;
    record_.end_reason = EndReason::kVoid;
    record_.void_reason = fmt::format("{} (at {:.3f} s)", reason, time_s());
  }

  void finish() {
    const Side a = configuration_.match.a_plays;
    for (const PerSide<int>& goals : referee_.goals_by_half()) {
      record_.goals_by_half.push_back({goals[a], goals[opponent_of(a)]});
      record_.goals_a += goals[a];
      record_.goals_b += goals[opponent_of(a)];
    }
    if (const std::optional<PerSide<int>> goals = referee_.shootout_goals()) {
      record_.shootout = {(*goals)[a], (*goals)[opponent_of(a)]};
    }
    record_.sim_s = time_s();
    record_.ball_in_play_s =
        static_cast<double>(frames_in_play_) / configuration_.sim.frame_rate_hz;
    record_.state_hash = hash_.value();
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
  Assistant assistant_;
  Frame frame_;
  DelayLine tracks_;
  PerSide<Player> players_;
  PerSide<TeamOrders> orders_;
  StateHash hash_;
  std::int64_t frames_in_play_ = 0;
  GameRecord record_;
};

}  // namespace

RuleBook rules_of(const MatchConfiguration& match) {
  std::optional<RuleBook> rules = find_rule_book(match.rules);
  if (!rules) throw std::invalid_argument(fmt::format("unknown rule book '{}'", match.rules));
  rules->in_force = match.in_force;
  rules->extra_half_s = match.extra_half_s;
  return *rules;
}

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
                                                           const strategies::Briefing& briefing) {
  const strategies::Entry* entry = strategies::find_strategy(name);
  if (entry == nullptr) throw std::invalid_argument(fmt::format("unknown strategy '{}'", name));
  return entry->make(briefing);
}

GameRecord play(const GameConfiguration& configuration, Observer* observer,
                const TeamMaker& make_team) {
  return Game(configuration, observer, make_team).play();
}

}  // namespace autoref::runner
