#include "referee/referee.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

#include "referee/geometry/ball_out.hpp"
#include "referee/machine/ball_in_play.hpp"
#include "referee/machine/ball_placement.hpp"
#include "referee/machine/beside_person.hpp"
#include "referee/machine/confidence.hpp"
#include "referee/machine/decision_of.hpp"
#include "referee/machine/machine.hpp"
#include "referee/machine/readiness.hpp"
#include "referee/machine/referee_state.hpp"
#include "referee/machine/timekeeping.hpp"
#include "referee/referee_input.hpp"
#include "referee/rules/rule.hpp"
#include "referee/touch/ball_jump_filter.hpp"
#include "referee/touch/frame_history.hpp"
#include "referee/touch/online_touch_detector.hpp"
#include "referee/touch/retrospective_touch_detector.hpp"
#include "referee/touch/touch_candidates.hpp"
#include "soccer/parameters.hpp"

namespace autoref::referee {
namespace {

constexpr Range kFieldLengths = positive(1000);

void validate(const Configuration& configuration) {
  check_ranges<Match>(configuration);
  // A real field may be of any size, and end close to its lines.
  const Field& field = configuration.field;
  check_number("field.length_m", field.length_m, kFieldLengths);
  check_number("field.width_m", field.width_m, kFieldLengths);
  check_number("field.goal_width_m", field.goal_width_m, kFieldLengths);
}

// After a longer gap in vision, nothing is inferred across it.
constexpr double kLongestGap_s = 1;

// What a person decides: cards, timeouts and the end of the game.
Configuration without_administration(Configuration configuration) {
  if (configuration.control == Control::kAutoref) return configuration;
  for (const RuleId rule : {RuleId::kCards, RuleId::kTimeouts, RuleId::kGoalLead})
    configuration.rules.in_force[rule] = false;
  return configuration;
}

// An event without evidence: the first frame, or the end of a briefly sent command.
Finding passed_by_itself(Event event) {
  Finding finding;
  finding.event = event;
  finding.rule = "paper 4.3";
  return finding;
}

}  // namespace

class Referee::Impl {
 public:
  explicit Impl(const Configuration& configuration)
      : configuration_(without_administration(configuration)),
        tracker_(configuration.noise),
        online_touch_(frames_, configuration.field, configuration.touch, configuration.noise),
        retrospective_touch_(frames_, configuration.field, TouchHypothesisParameters{},
                             configuration.noise) {
    validate(configuration);
    state_.signal.next_command =
        Command{CommandKind::kPrepareKickoff, kickoff_side(configuration, 0)};
    decisions_.reserve(4);
  }

  void begin(const Beginning& beginning) {
    assert(tracks_ == nullptr && configuration_.control == Control::kAutoref);
    state_.beginning = beginning;
  }

  const RefereeSignal& update(const Frame& frame, const PerSide<TeamRequests>& requests) {
    take(frame, requests);
    return judge(tracker_.update(seen_));
  }

  const RefereeSignal& update(const Frame& frame, const Tracks& tracks,
                              const PerSide<TeamRequests>& requests) {
    take(frame, requests);
    other_tracks_ = tracks;
    return judge(other_tracks_);
  }

  void follow(const RefereeSignal& given) {
    state_.signal.blue_on_positive_half = given.blue_on_positive_half;
    if (configuration_.control != Control::kHuman) return;
    if (tracks_ == nullptr) {
      pending_ = given;
      return;
    }
    const RefereeInput input = input_with(online_touch_.last(), seen_);
    const bool is_new = is_new_command(state_, given);
    state_.person.given = given;
    if (is_new) {
      decide(input, finding_of_command(state_));
    } else {
      take_values(state_, input);
    }
  }

  const Tracks& tracks() const { return tracks_ == nullptr ? tracker_.tracks() : *tracks_; }

  std::span<const Decision> decisions() const { return decisions_; }
  const RefereeState& state() const { return state_; }

 private:
  void take(const Frame& frame, const PerSide<TeamRequests>& requests) {
    requests_ = requests;
    const bool is_gap = tracks_ != nullptr && frame.time_s - seen_.time_s > kLongestGap_s;
    seen_ = is_finite(frame) ? frame : finite_part(frame);
    if (is_gap) forget();
    if (configuration_.control == Control::kAutoref) return;
    // While play is stopped, people place the ball.
    if (!is_play(state_.machine_state)) ball_jump_.forget();
    ball_jump_.filter(seen_);
  }

  const RefereeSignal& judge(const Tracks& tracks) {
    tracks_ = &tracks;
    add_unseen_robots(tracks);
    lift_ball(tracks);
    detect(seen_);
    if (pending_) follow(*std::exchange(pending_, std::nullopt));
    return state_.signal;
  }

  // Tracks, touches and the rules' records begin afresh, except for what the ball shows later of
  // the last touch.
  void forget() {
    if (is_play(state_.machine_state)) before_gap_ = online_touch_.before_gap();
    tracker_ = Tracker(configuration_.noise);
    ball_.reset();
    ball_jump_.forget();
    was_lifted_ = false;
    joins_ = is_play(state_.machine_state);
    state_.watch = RuleWatch{};
    state_.ball_in_position_since_s.reset();
    state_.saved = positions_in(seen_);
    state_.person.goes_on = {};
  }

  // Joins play in the middle.
  void join(const Frame& frame) {
    joins_ = false;
    state_.play = play_joined(input_with(online_touch_.last(), frame));
    frames_.restart(frame, std::nullopt);
    online_touch_.restart();
    if (before_gap_) online_touch_.resume(*std::exchange(before_gap_, std::nullopt));
  }

  // Joins play where the ball has appeared: it counts as at rest there, so that a robot that kicks
  // it away at once is seen to touch it.
  void join_at_jump() {
    const BallJumpFilter::Frames& jumped = ball_jump_.jumped();
    join(jumped.front());
    frames_.restart(jumped.front(), jumped.front().ball->position_m);
    online_touch_.restart();
    for (const Frame& frame : jumped) {
      frames_.push(frame);
      online_touch_.update();
    }
  }

  // Whether a ball that was called out is back on the field. Somebody has put it there.
  bool has_returned() {
    if (!state_.person.ball_is_out || !ball_ || is_out(*ball_)) return false;
    state_.person.ball_is_out = false;
    return true;
  }

  bool is_out(const BallSight& ball) const {
    return is_out_of_field(configuration_.field, ball.position_m);
  }

  static bool is_play(State state) { return state == State::kRun || state == State::kCalled; }

  // Follows the ball and its touches while play is on.
  void follow_ball(const Frame& frame) {
    if (has_returned()) joins_ = true;
    if (joins_) return join(frame);
    if (!ball_jump_.jumped().empty()) return join_at_jump();
    frames_.push(frame, tracks().ball);
    online_touch_.update();
    // The order of touches is the one that the online detector reports; the retrospective detector
    // does not change it.
    watch_play(state_.play, input_with(online_touch_.last(), frame));
  }

  const RefereeSignal& detect(const Frame& frame) {
    decisions_.clear();
    see(frame);
    if (is_play(state_.machine_state)) follow_ball(frame);
    if (state_.machine_state == State::kCalled) {
      const RefereeInput input = input_with(online_touch_.last(), frame);
      if (const std::optional<Finding> found = find_overruled(state_, input)) decide(input, *found);
    }
    const LastTouch last_touch = evaluate_last_touch();
    const RefereeInput input = input_with(last_touch, frame);
    const State state = state_.machine_state;
    const std::uint32_t sent = state_.signal.command_counter;
    apply_rules(input);
    // The machine's own events wait for the next frame if a rule has just changed its state or sent
    // a command.
    if (state_.machine_state == state && state_.signal.command_counter == sent) {
      if (const std::optional<Finding> found = find(input)) decide(input, *found);
    }
    keep_time(input);
    return state_.signal;
  }

  // The person beside AutoRef keeps the time.
  void keep_time(const RefereeInput& input) {
    if (configuration_.control != Control::kAutoref) {
      if (state_.person.given)
        state_.signal.stage_time_left_s = state_.person.given->stage_time_left_s;
      return;
    }
    if (const std::optional<Finding> over = find_time_over(state_, input)) decide(input, *over);
    state_.signal.stage_time_left_s = time_left_s(state_, configuration_, input.time_s());
  }

  RefereeInput input_with(const LastTouch& last_touch, const Frame& frame) const {
    return {configuration_, frame, ball_, last_touch, tracks(), requests_, frames_};
  }

  // Once the ball is out, the whole path since the touch is known.
  LastTouch evaluate_last_touch() const {
    const bool has_left = state_.machine_state == State::kRun && !state_.person.ball_is_out &&
                          ball_ && is_out(*ball_);
    return has_left ? retrospective_touch_.detect(online_touch_.last()) : online_touch_.last();
  }

  // Robots missing from the frame are added at the tracker's estimate. Both lists are sorted by
  // number.
  void add_unseen_robots(const Tracks& tracks) {
    for (const Side side : kSides) {
      SeenRobots& robots = seen_.robots[side];
      if (robots.size() == tracks.robots[side].size()) continue;
      for (const TrackedRobot& known : tracks.robots[side]) {
        if (find_robot(robots, known.number) != nullptr) continue;
        const auto next = std::find_if(
            robots.begin(), robots.end(),
            [&known](const RobotObservation& robot) { return robot.number > known.number; });
        robots.insert(next, {known.number, known.position_m, known.heading});
      }
    }
  }

  // Without a reported height, a flying ball is not where the camera projects it: use the tracker's
  // position.
  void lift_ball(const Tracks& tracks) {
    // If the frame is not newer than the last one, the tracker has no ball.
    if (!seen_.ball || seen_.ball->height_m || !tracks.ball) return;
    const bool flies = tracks.ball->height_m > 0;
    if (flies) {
      seen_.ball->position_m = tracks.ball->position_m;
      seen_.ball->height_m = tracks.ball->height_m;
    }
    // The source of the positions changes here, so a velocity computed across the change would be
    // wrong.
    if (flies != was_lifted_) frames_.lose_sight();
    was_lifted_ = flies;
  }

  // A frame without a ball keeps the last known ball.
  void see(const Frame& frame) {
    if (!frame.ball) return;
    const Vec2& now_m = frame.ball->position_m;
    const double height_m = frame.ball->height_m.value_or(0.0);
    ball_ = BallSight{now_m, ball_ ? ball_->position_m : now_m, height_m,
                      frame.ball->height_m || !tracks().ball || tracks().ball->is_height_known};
  }

  std::optional<Finding> find(const RefereeInput& input) {
    if (configuration_.control != Control::kAutoref) return find_beside_person(input);
    switch (state_.machine_state) {
      case State::kInit:
        return passed_by_itself(Event::kBegin);
      case State::kWaitStart:
        return find_start(state_, input);
      case State::kWaitStop:
        return is_placement_due(state_) ? find_placement_step(state_, input)
                                        : find_ready(state_, input);
      case State::kPlacement:
        return find_placement_outcome(state_, input);
      case State::kDelayWait:
        if (!has_passed(state_.delay_ends_s, 0, input.time_s())) return std::nullopt;
        return passed_by_itself(Event::kSignalled);
      case State::kRun:
      case State::kTimeout:
      case State::kOver:
      case State::kCalled:
        break;
    }
    return std::nullopt;
  }

  std::optional<Finding> find_beside_person(const RefereeInput& input) {
    switch (state_.machine_state) {
      case State::kInit:
        if (configuration_.control == Control::kHuman) return std::nullopt;
        return passed_by_itself(Event::kBegin);
      case State::kWaitStop:
        watch_ball(state_, input);
        return std::nullopt;
      default:
        return std::nullopt;
    }
  }

  // Counted fouls do not change the machine's state, so later rules still run.
  void apply_rules(const RefereeInput& input) {
    const bool is_shootout = state_.signal.stage == Stage::kShootout;
    for (const AskedRule& asked : rules()) {
      if (is_shootout && !rules_in_shootout().has(asked.id)) continue;
      if (configuration_.rules.has(asked.id) && !ask(*asked.rule, input)) return;
    }
    if (is_shootout) ask(kShootoutRule, input);
  }

  // Returns whether the machine's state is unchanged.
  bool ask(const Rule& rule, const RefereeInput& input) {
    const State state = state_.machine_state;
    for (const Watch& watch : rule.watches()) {
      if (!watch.active_in.has(state)) continue;
      if (const std::optional<Finding> found = watch.find(state_, input)) decide(input, *found);
      if (state_.machine_state != state) return false;
    }
    return true;
  }

  void decide(const RefereeInput& input, const Finding& found) {
    Finding finding = found;
    add_confidence(finding, state_, input);
    if (found.is_foul && finding.confidence < configuration_.least_confidence) return;
    if (configuration_.control != Control::kAutoref && state_.machine_state == State::kRun &&
        is_called_already(state_, input, finding)) {
      return;
    }
    Step taken = step(state_, input, finding);
    if (taken.transition == nullptr) return;
    // The step is a pure function, so `state_` is still the state before the step.
    decisions_.push_back(decision_of(state_, input, finding, taken));
    const bool play_starts =
        taken.state.machine_state == State::kRun &&
        (!is_play(state_.machine_state) || taken.state.play.began_s != state_.play.began_s);
    // A game may also begin with a restart.
    const bool is_joining =
        state_.machine_state == State::kInit && (!state_.beginning || taken.state.play.in_play);
    state_ = std::move(taken.state);
    if (!play_starts) return;
    // A play that is joined in the middle did not begin with the ball at rest.
    frames_.restart(input.frame, is_joining ? std::nullopt : state_.play.ball_from_m);
    online_touch_.restart();
  }

  Configuration configuration_;
  PerSide<TeamRequests> requests_;
  RefereeState state_;
  Frame seen_;
  Tracker tracker_;
  Tracks other_tracks_;                   // if another tracker made them
  const Tracks* tracks_ = nullptr;        // of the last frame; null before the first
  std::optional<RefereeSignal> pending_;  // given before the first frame
  bool joins_ = false;                    // play is joined afresh in the next frame
  std::optional<BeforeGap> before_gap_;   // then, after a gap in vision
  bool was_lifted_ = false;  // whether lift_ball() moved the ball in the previous frame
  FrameHistory frames_;      // of the current play
  OnlineTouchDetector online_touch_;
  RetrospectiveTouchDetector retrospective_touch_;
  BallJumpFilter ball_jump_;
  std::optional<BallSight> ball_;
  std::vector<Decision> decisions_;
};

Referee::Referee(const Configuration& configuration)
    : impl_(std::make_unique<Impl>(configuration)) {}
Referee::~Referee() = default;
Referee::Referee(Referee&&) noexcept = default;
Referee& Referee::operator=(Referee&&) noexcept = default;

const RefereeSignal& Referee::update(const Frame& frame, const PerSide<TeamRequests>& requests) {
  return impl_->update(frame, requests);
}

const RefereeSignal& Referee::update(const Frame& frame, const Tracks& tracks,
                                     const PerSide<TeamRequests>& requests) {
  return impl_->update(frame, tracks, requests);
}

void Referee::begin(const Beginning& beginning) { impl_->begin(beginning); }
void Referee::follow(const RefereeSignal& given) { impl_->follow(given); }

const Tracks& Referee::tracks() const { return impl_->tracks(); }
std::span<const Decision> Referee::decisions() const { return impl_->decisions(); }
State Referee::state() const { return impl_->state().machine_state; }
bool Referee::is_ball_in_play() const {
  return impl_->state().machine_state == State::kRun && impl_->state().play.in_play;
}
bool Referee::is_over() const { return impl_->state().machine_state == State::kOver; }
std::span<const PerSide<int>> Referee::goals_by_half() const {
  const auto& goals = impl_->state().goals_by_half;
  return {goals.data(), goals.size()};
}
std::optional<PerSide<int>> Referee::shootout_goals() const {
  const ShootoutBook& book = impl_->state().shootout;
  return book.kicks == PerSide<int>{} ? std::nullopt : std::optional(book.goals);
}
int Referee::games_finished() const { return impl_->state().games_finished; }

}  // namespace autoref::referee
