#include "logs/logged_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "league/referee_message.hpp"
#include "logs/recorded_ends.hpp"
#include "logs/recorded_teams.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/robot_shape.hpp"
#include "tracking/tracker.hpp"

namespace autoref::logs {
namespace {

constexpr double kTrackedBefore_s = 5;  // long enough for the tracker's filters
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

// Reads the log up to a time and, beyond it, only the next restart. Uses the log's coordinates.
class StateReader final : public league::LogVisitor {
 public:
  StateReader(double at_s, const RecordedTeams& teams)
      : at_s_(at_s), ends_(teams.yellow_end.value_or(Side::kWest), true, teams.turned) {}

  void on_frame(const Frame& frame) override {
    if (!first_s_) first_s_ = frame.time_s;
    last_s_ = frame.time_s;
    if (frame.time_s > at_s_ + kRounding_s) return;
    if (frame.time_s >= at_s_ - kTrackedBefore_s) tracks_ = tracker_.update(frame);
    if (frame.ball) follow(frame.ball->position_m);
  }

  void on_referee(double time_s, const league::RefereePacket& packet) override {
    const std::optional<RefereeSignal> signal = league::signal_of(packet);
    if (!signal) return;
    if (time_s > at_s_ + kRounding_s) return note_next(signal->command);
    ends_.add(packet, signal->stage);
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

  // The referee's part of the state, in the program's coordinates; `ball_m` is the ball's position.
  referee::MidwayStart midway_start(const Vec2& ball_m, const Field& field) const {
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

 private:
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
  return start;
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
  return {start_of(reader, field), summary};
} catch (const league::LogError& error) {
  throw std::invalid_argument(error.what());
}

void renumber(game::StartingRobots& robots, int count) {
  if (static_cast<int>(robots.size()) > count)
    throw std::invalid_argument(fmt::format(
        "the log has {} robots of this team at this time, but the team has {}; set its robots",
        robots.size(), count));
  const bool fit = std::all_of(robots.begin(), robots.end(), [count](const sim::RobotState& robot) {
    return robot.number < count;
  });
  if (fit) return;
  int next = 0;
  for (sim::RobotState& robot : robots) robot.number = next++;
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
