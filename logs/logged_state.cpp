#include "logs/logged_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <deque>
#include <limits>
#include <stdexcept>

#include "league/referee_message.hpp"
#include "logs/recorded_ends.hpp"
#include "logs/recorded_teams.hpp"
#include "referee/machine/guards.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/robot_command.hpp"
#include "soccer/robot_shape.hpp"
#include "tracking/tracker.hpp"

namespace autoref::logs {
namespace {

constexpr double kTrackedBefore_s = 5;  // long enough for the tracker's filters
constexpr double kSeenBefore_s = 0.6;   // longer than the longest delay of a team's view
constexpr double kWholeHalf_s = std::numeric_limits<double>::infinity();
constexpr double kRounding_s = 1e-6;
constexpr double kMoved_m = 50_mm;  // a ball that has moved farther is in play (Laws 2014, law 9)
constexpr double kSameField_m = 20_mm;

bool is_restart(const Command& command) {
  switch (command.kind) {
    case CommandKind::kPrepareKickoff:
    case CommandKind::kPreparePenalty:
    case CommandKind::kDirectFree:
    case CommandKind::kIndirectFree:
    case CommandKind::kForceStart:
      return true;
    default:
      return false;
  }
}

// What vision would have shown if it were as smooth as the tracks.
Frame frame_of(const Tracks& tracks) {
  Frame frame;
  frame.time_s = tracks.time_s;
  for (const Side side : kSides) {
    for (const TrackedRobot& robot : tracks.robots[side])
      frame.robots[side].push_back({robot.number, robot.position_m, robot.heading});
  }
  if (tracks.ball) frame.ball = BallObservation{tracks.ball->position_m, tracks.ball->height_m};
  return frame;
}

// Reads the log up to a time and, beyond it, only the next restart. Uses the log's coordinates.
class StateReader final : public league::LogVisitor {
 public:
  StateReader(double at_s, const RecordedTeams& teams)
      : at_s_(at_s), ends_(teams.yellow_end.value_or(Side::kWest), true, teams.turned) {}

  void on_frame(const Frame& frame) override {
    if (!first_s_) first_s_ = frame.time_s;
    last_s_ = frame.time_s;
    if (frame.time_s > at_s_ + kRounding_s) return;
    if (frame.time_s >= at_s_ - kTrackedBefore_s) track(frame);
    if (frame.ball) follow(frame.ball->position_m);
  }

  void on_referee(double time_s, const league::RefereePacket& packet) override {
    std::optional<RefereeSignal> signal = league::signal_of(packet);
    if (!signal) return;
    if (time_s > at_s_ + kRounding_s) return note_next(signal->command);
    ends_.add(packet, signal->stage);
    note_half(*signal);
    if (!packet.has_stage_time_left()) signal->stage_time_left_s = kWholeHalf_s;
    if (!signal_ || signal_->command_counter != signal->command_counter) obey(signal->command);
    signal_ = signal;
  }

  bool covers(double time_s) const {
    return first_s_ && time_s >= *first_s_ && time_s <= last_s_ + kRounding_s;
  }
  std::string extent() const {
    return fmt::format("{:.3f} to {:.3f} s", first_s_.value_or(0), last_s_);
  }
  const Tracks& tracks() const { return tracks_; }
  bool is_yellow_west() const { return ends_.yellow() == Side::kWest; }

  // What was seen before the state, in the program's coordinates, with the state's time as 0.
  std::vector<Frame> seen_before() const {
    std::vector<Frame> frames;
    frames.reserve(seen_.size());
    for (const Tracks& tracks : seen_) {
      frames.push_back(published(frame_of(tracks), is_yellow_west()));
      frames.back().time_s -= tracks_.time_s;
      frames.back().number = static_cast<std::int64_t>(frames.size() - 1 - seen_.size());
    }
    return frames;
  }

  // The referee's part of the state, in the program's coordinates; `ball_m` is the ball's position.
  referee::MidwayStart midway_start(const Vec2& ball_m, const Field& field) const {
    referee::MidwayStart start = restart(ball_m, field);
    start.signal = signal_;
    if (signal_) start.signal->blue_on_positive_half = is_yellow_west();
    start.goals_in_earlier_halves = goals_before_half_;
    return start;
  }

 private:
  // The pending restart.
  referee::MidwayStart restart(const Vec2& ball_m, const Field& field) const {
    if (!signal_) return {};
    const Command& command = signal_->command;
    if (command.kind == CommandKind::kNormalStart) {
      return has_moved_ || !prepared_ ? referee::MidwayStart{}
                                      : referee::MidwayStart{prepared_, ball_m};
    }
    if (command.kind == CommandKind::kForceStart) return {};
    if (is_restart(command)) {
      const bool is_free =
          command.kind == CommandKind::kDirectFree || command.kind == CommandKind::kIndirectFree;
      return is_free && has_moved_
                 ? referee::MidwayStart{}
                 : referee::MidwayStart{command, restart_position(command, ball_m, field)};
    }
    const Command next = restart_after_stop();
    return {next, restart_position(next, ball_m, field), true};
  }

  void track(const Frame& frame) {
    if (tracks_.ball && frame.time_s > tracks_.time_s) seen_.push_back(tracks_);
    tracks_ = tracker_.update(frame);
    while (!seen_.empty() && tracks_.time_s - seen_.front().time_s > kSeenBefore_s)
      seen_.pop_front();
  }

  // Goals scored before the log's first packet count for the halves before, if there are any.
  void note_half(const RefereeSignal& signal) {
    const std::optional<int> half = referee::half_in(signal.stage);
    if (!half || half == half_) return;
    half_ = half;
    goals_before_half_ = half == 0 ? PerSide<int>{} : signal.goals;
  }

  void follow(const Vec2& ball_m) {
    ball_m_ = ball_m;
    if (!ball_from_m_) ball_from_m_ = ball_m;
    has_moved_ |= (ball_m - *ball_from_m_).norm() > kMoved_m;
  }

  void obey(const Command& command) {
    if (command.kind != CommandKind::kNormalStart) prepared_.reset();
    if (command.kind == CommandKind::kPrepareKickoff ||
        command.kind == CommandKind::kPreparePenalty)
      prepared_ = command;
    ball_from_m_ = ball_m_;
    has_moved_ = false;
  }

  void note_next(const Command& command) {
    if (!next_ && is_restart(command)) next_ = command;
  }

  Command restart_after_stop() const {
    if (signal_->next_command && is_restart(*signal_->next_command)) return *signal_->next_command;
    return next_.value_or(Command{CommandKind::kForceStart, Side::kWest});
  }

  Vec2 restart_position(const Command& restart, const Vec2& ball_m, const Field& field) const {
    if (restart.kind == CommandKind::kPrepareKickoff) return {0, 0};
    if (restart.kind == CommandKind::kPreparePenalty)
      return field.penalty_mark_at(opponent_of(restart.side));
    if (!signal_->placement) return ball_m;
    return published(signal_->placement->target_m, is_yellow_west());
  }

  double at_s_;
  RecordedEnds ends_;
  tracking::Tracker tracker_;
  Tracks tracks_;
  std::deque<Tracks> seen_;  // the tracks before these
  std::optional<int> half_;  // the half of the last signal
  PerSide<int> goals_before_half_;
  std::optional<double> first_s_;
  double last_s_ = 0;
  std::optional<RefereeSignal> signal_;  // the last signal up to that time
  std::optional<Command> prepared_;      // the restart that NORMAL_START started
  std::optional<Command> next_;          // the first restart after that time
  std::optional<Vec2> ball_m_;
  std::optional<Vec2> ball_from_m_;  // the ball's position when the command was given
  bool has_moved_ = false;           // whether the ball has moved since then
};

sim::RobotState state_of(const TrackedRobot& robot) {
  return {robot.number, robot.position_m, robot.heading, robot.velocity_mps,
          robot.angular_velocity_radps};
}

game::StartState start_of(const StateReader& read, const Field& field) {
  const Tracks& tracks = read.tracks();
  if (!tracks.ball) throw std::invalid_argument("the ball is missing in the log at this time");
  const bool turns = !read.is_yellow_west();
  game::StartState start;
  for (const Side side : kSides) {
    for (const TrackedRobot& robot : tracks.robots[side])
      start.robots[side].push_back(state_of(turns ? mirrored(robot) : robot));
  }
  const TrackedBall ball = turns ? mirrored(*tracks.ball) : *tracks.ball;
  start.ball = {ball.position_m, ball.velocity_mps, ball.height_m, 0, ball.height_m <= 0};
  start.referee = read.midway_start(ball.position_m, field);
  start.seen_before = read.seen_before();
  return start;
}

// New numbers by number in the log, from 0; -1 for robots without one.
using NewNumbers = std::array<int, kMaxRobots>;

std::optional<int> keeper_in(const game::StartState& start, Side side) {
  const std::optional<RefereeSignal>& signal = start.referee.signal;
  return signal ? signal->keepers[side] : std::nullopt;
}

NewNumbers new_numbers(const game::StartState& start, Side side, int count) {
  const sim::RobotStates& robots = start.robots[side];
  if (static_cast<int>(robots.size()) > count) {
    throw std::invalid_argument(fmt::format(
        "the log has {} robots of this team at this time, but the team has {}; set its robots",
        robots.size(), count));
  }
  NewNumbers numbers;
  numbers.fill(-1);
  const bool fit = std::all_of(robots.begin(), robots.end(), [count](const sim::RobotState& robot) {
    return robot.number < count;
  });
  int next = 0;
  for (const sim::RobotState& robot : robots)
    numbers.at(static_cast<std::size_t>(robot.number)) = fit ? robot.number : next++;
  const std::optional<int> keeper = keeper_in(start, side);
  if (!keeper || *keeper < 0 || *keeper >= kMaxRobots) return numbers;
  if (numbers.at(static_cast<std::size_t>(*keeper)) < 0) return numbers;
  int& of_keeper = numbers.at(static_cast<std::size_t>(*keeper));
  const auto holder = std::find(numbers.begin(), numbers.end(), TeamRequests{}.keeper);
  if (holder != numbers.end()) *holder = of_keeper;
  of_keeper = TeamRequests{}.keeper;
  return numbers;
}

template <typename Robots>
void renumber(const NewNumbers& numbers, Robots& robots) {
  Robots renumbered;
  for (auto robot : robots) {
    robot.number = numbers.at(static_cast<std::size_t>(robot.number));
    if (robot.number >= 0) renumbered.push_back(robot);
  }
  std::sort(renumbered.begin(), renumbered.end(),
            [](const auto& one, const auto& other) { return one.number < other.number; });
  robots = renumbered;
}

}  // namespace

LoggedState logged_state(const std::filesystem::path& log, double at_s) try {
  league::LogVisitor nobody;
  const Field field = league::read_log(log, nobody).field.value_or(Field{});
  const RecordedTeams teams = teams_in(log, field, true);
  StateReader reader(at_s, teams);
  const league::LogSummary summary = league::read_log(log, reader);
  if (!reader.covers(at_s)) {
    throw std::invalid_argument(fmt::format("{} s is outside the log {}, which covers {}", at_s,
                                            log.string(), reader.extent()));
  }
  LoggedState logged{start_of(reader, field), summary};
  if (logged.start.referee.signal) {
    for (const Side side : kSides) {
      const std::optional<int>& actual = teams.actual_keepers[side];
      std::optional<int>& keeper = logged.start.referee.signal->keepers[side];
      if (actual) keeper = *actual >= 0 ? actual : std::nullopt;
    }
  }
  return logged;
} catch (const league::LogError& error) {
  throw std::invalid_argument(error.what());
}

void renumber(game::StartState& start, Side side, int count) {
  const NewNumbers numbers = new_numbers(start, side, count);
  renumber(numbers, start.robots[side]);
  if (start.referee.signal && keeper_in(start, side))
    start.referee.signal->keepers[side] = TeamRequests{}.keeper;
  for (Frame& frame : start.seen_before) renumber(numbers, frame.robots[side]);
  if (!start.ghost || start.ghost->side != side) return;
  for (game::GhostFrame& frame : start.ghost->frames) renumber(numbers, frame.robots);
}

void check_same_field(const LoggedState& logged, const Field& field) {
  if (!logged.log.field) return;
  const Field& its = *logged.log.field;
  const bool is_same = std::abs(its.length_m - field.length_m) <= kSameField_m &&
                       std::abs(its.width_m - field.width_m) <= kSameField_m;
  if (is_same) return;
  throw std::invalid_argument(
      fmt::format("the log's field is {} x {} m, but the game's is {} x {} m; choose match.rules, "
                  "or set field.length_m and field.width_m",
                  its.length_m, its.width_m, field.length_m, field.width_m));
}

}  // namespace autoref::logs
