#include "logs/logged_ghost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "game/settings/game_settings.hpp"
#include "league/log_contents.hpp"
#include "league/referee_message.hpp"
#include "logs/log_game.hpp"
#include "logs/log_referee.hpp"
#include "logs/recorded_facts.hpp"
#include "logs/recorded_teams.hpp"
#include "logs/track_touches.hpp"
#include "logs/tracked_frame.hpp"
#include "referee/person/transitions_beside_person.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::logs {
namespace {

constexpr double kSameGhostTime_s = 1e-6;  // times in logs are rounded
// Nobody knows what robots did in a longer gap between two frames.
constexpr double kLongestGhostGap_s = 1;
// Vision sends frames less often than this; the limit bounds the memory of a ghost.
constexpr double kShortestGhostStep_s = 3_ms;
constexpr std::size_t kMostFramesAhead = 256;
// A robot that touched the ball this recently still has it if the ball is within this distance of
// the robot's disc.
constexpr double kRecentTouch_s = 100_ms;
constexpr double kStillAtHull_m = 20_mm;
// The score of a goal is expected within this time of the stop.
constexpr double kScoreWithin_s = 60;

// The recorded referee's commands around a play: the command in force at a time, the stop that ends
// the play, and the score until play is resumed.
class RecordedStop {
 public:
  explicit RecordedStop(double at_s) : at_s_(at_s) {}

  void add(double time_s, const RefereeSignal& signal) {
    if (is_settled_) return;
    if (time_s <= at_s_ + kSameGhostTime_s) {
      command_ = signal.command;
      goals_at_start_ = goals_ = signal.goals;
      return;
    }
    if (stopped_s_ && time_s > *stopped_s_ + kScoreWithin_s) return settle();
    if (!goals_at_start_) goals_at_start_ = signal.goals;
    goals_ = signal.goals;
    const bool starts = referee::starts_play(signal.command.kind);
    if (starts && stopped_s_) settle();
    if (!starts && !stopped_s_) stopped_s_ = time_s;
  }

  // Ignores everything that follows.
  void settle() { is_settled_ = true; }

  // Whether frames at this time are after the stop. A packet takes effect as in LogReferee.
  bool is_stopped(double time_s) const {
    return stopped_s_ && *stopped_s_ <= time_s + kSameGhostTime_s;
  }

  // The command that keeps play stopped at the beginning; nullopt if play is on.
  std::optional<Command> stopped_by() const {
    return command_ && !referee::starts_play(command_->kind) ? command_ : std::nullopt;
  }

  std::optional<Side> scorer() const {
    for (const Side side : kSides)
      if (goals_at_start_ && goals_[side] > (*goals_at_start_)[side]) return side;
    return std::nullopt;
  }

 private:
  double at_s_;
  std::optional<Command> command_;              // nullopt: no packet yet
  std::optional<PerSide<int>> goals_at_start_;  // or in the first packet
  PerSide<int> goals_;
  std::optional<double> stopped_s_;
  bool is_settled_ = false;
};

// Finds the touches of the ball by a side after a time.
class SideTouches {
 public:
  SideTouches(Side side, double at_s, const tracking::VisionNoise& noise)
      : side_(side), at_s_(at_s), touches_(noise) {}

  // Takes the frame that the referee has just judged.
  void update(const referee::AutoRef& referee) {
    std::optional<TrackedFrame> tracked = tracked_frame(referee);
    if (!tracked) return;
    touches_.update(referee, *tracked);
    waiting_.push_back(*std::move(tracked));
    const double newest_s = waiting_.back().time_s;
    while (newest_s - waiting_.front().time_s > kLookAhead_s || waiting_.size() > kMostFramesAhead)
      take_oldest();
  }

  // Their times since `at_s`, at most one per frame; the first one is 0 if the side has the ball
  // then. Call it after the last frame.
  std::vector<double> finish() {
    while (!waiting_.empty()) take_oldest();
    if (has_ball_) touches_s_.insert(touches_s_.begin(), 0.0);
    return touches_s_;
  }

 private:
  struct RecentTouch {
    double time_s = 0;
    int robot = 0;
  };

  void take_oldest() {
    const double time_s = waiting_.front().time_s;
    for (const sim::Touch& touch : touches_.take(before_, waiting_))
      if (touch.robot.side == side_) note(time_s, touch.robot.number);
    if (time_s <= at_s_ + kSameGhostTime_s) has_ball_ = has_ball_in(waiting_.front());
    before_ = std::move(waiting_.front());
    waiting_.pop_front();
  }

  void note(double time_s, int robot) {
    if (time_s <= at_s_ + kSameGhostTime_s) {
      recent_.push_back({time_s, robot});
    } else if (touches_s_.empty() || touches_s_.back() < time_s - at_s_) {
      touches_s_.push_back(time_s - at_s_);
    }
  }

  // Whether a robot of the side that has just touched the ball is still at it.
  bool has_ball_in(const TrackedFrame& frame) {
    while (!recent_.empty() && recent_.front().time_s < frame.time_s - kRecentTouch_s)
      recent_.pop_front();
    return std::any_of(recent_.begin(), recent_.end(),
                       [&](const RecentTouch& touch) { return is_at_ball(frame, touch.robot); });
  }

  bool is_at_ball(const TrackedFrame& frame, int number) const {
    for (const sim::RobotState& robot : frame.world.robots[side_]) {
      const double distance_m = (robot.position_m - frame.world.ball.position_m).norm();
      if (robot.number == number)
        return distance_m < kRobotRadius_m + kBallRadius_m + kStillAtHull_m;
    }
    return false;
  }

  Side side_;
  double at_s_;
  TrackTouches touches_;
  std::deque<TrackedFrame> waiting_;
  std::optional<TrackedFrame> before_;  // the frame before the oldest one that waits
  std::deque<RecentTouch> recent_;      // the side's touches just before the time
  bool has_ball_ = false;
  std::vector<double> touches_s_;
};

game::GhostFrame ghost_frame(const Tracks& tracks, Side side, double time_s) {
  game::GhostFrame frame;
  frame.time_s = time_s;
  for (const TrackedRobot& robot : tracks.robots[side])
    frame.robots.push_back({robot.number, robot.position_m, robot.heading, robot.velocity_mps,
                            robot.angular_velocity_radps});
  if (const std::optional<TrackedBall>& ball = tracks.ball)
    frame.ball = {ball->position_m, ball->velocity_mps, ball->height_m, 0, ball->height_m <= 0};
  return frame;
}

// Lets AutoRef judge the log up to the end of the ghost, and a little further, since touches are
// detected late.
class GhostReader final : public league::LogVisitor {
 public:
  GhostReader(const std::vector<referee::Configuration>& configurations, const RecordedTeams& teams,
              double at_s, Side side)
      : at_s_(at_s),
        side_(side),
        referee_(configurations, teams, SignalOrder::kByTime, [](const referee::Decision&) {}),
        stop_(at_s),
        touches_(opponent_of(side), at_s, configurations.front().noise) {
    referee_.watch_frames([this](const LogReferee& judged) { add(judged.referee()); });
  }

  void on_frame(const Frame& frame) override {
    if (!first_s_) first_s_ = frame.time_s;
    last_s_ = frame.time_s;
    if (needs_frames()) referee_.on_frame(frame);
  }

  void on_referee(double time_s, const league::RefereePacket& packet) override {
    if (const auto signal = league::signal_of(packet)) stop_.add(time_s, *signal);
    if (needs_frames()) referee_.on_referee(time_s, packet);
  }

  // Throws std::invalid_argument unless play is on at the beginning.
  void check(const std::filesystem::path& log) const {
    if (!first_s_ || !(at_s_ >= *first_s_ && at_s_ <= last_s_ + kSameGhostTime_s)) {
      throw std::invalid_argument(fmt::format("{} s is outside the log {}, which covers {}", at_s_,
                                              log.string(), extent()));
    }
    if (const std::optional<Command> command = stop_.stopped_by()) {
      throw std::invalid_argument(
          fmt::format("play is stopped at {} s in the log {} ({}); a ghost needs a time at which "
                      "play is on",
                      at_s_, log.string(), name_of(*command)));
    }
    if (frames_.empty() || at_s_ - start_s_ > kLongestGhostGap_s) {
      throw std::invalid_argument(
          fmt::format("the log {} shows no play at {} s: it has a gap there, or the game is over",
                      log.string(), at_s_));
    }
  }

  // Call it after check().
  LoggedGhost finish() {
    LoggedGhost result;
    result.ghost.side = side_;
    const double lasts_s = frames_.back().time_s;
    result.ghost.frames = std::move(frames_);
    result.ghost.touches_s = touches_.finish();
    std::erase_if(result.ghost.touches_s, [lasts_s](double time_s) { return time_s > lasts_s; });
    result.scorer = stop_.scorer();
    return result;
  }

 private:
  bool needs_frames() const { return !end_s_ || last_s_ <= *end_s_ + kLookAhead_s; }

  std::string extent() const {
    return fmt::format("{:.3f} to {:.3f} s", first_s_.value_or(0), last_s_);
  }

  void add(const referee::AutoRef& referee) {
    const double time_s = referee.frame().time_s;
    touches_.update(referee);
    if (time_s <= at_s_ + kSameGhostTime_s) {
      start_s_ = newest_s_ = time_s;
      frames_.assign(1, ghost_frame(referee.tracks(), side_, 0));
      return;
    }
    if (!end_s_ && ends_before(time_s)) end_s_ = time_s;
    newest_s_ = time_s;
    if (end_s_ || time_s - at_s_ < frames_.back().time_s + kShortestGhostStep_s) return;
    frames_.push_back(ghost_frame(referee.tracks(), side_, time_s - at_s_));
  }

  bool ends_before(double time_s) {
    if (stop_.is_stopped(time_s)) return true;
    const bool is_cut = frames_.empty() || time_s - at_s_ > kLongestGhost_s ||
                        time_s - newest_s_ > kLongestGhostGap_s;
    if (is_cut) stop_.settle();
    return is_cut;
  }

  double at_s_;
  Side side_;
  LogReferee referee_;
  RecordedStop stop_;
  SideTouches touches_;
  std::vector<game::GhostFrame> frames_;
  std::optional<double> first_s_;  // the log's first frame
  double last_s_ = 0;              // the last frame read
  double start_s_ = 0;             // the ghost's first frame
  double newest_s_ = 0;            // the last frame judged
  std::optional<double> end_s_;    // the first frame that is not the ghost's any more
};

// Frames are turned as in logged_state(), whose start states the ghosts join: if the packets do not
// give the ends, the teams change ends.
std::vector<referee::Configuration> judging_configurations(const RecordedFacts& facts) {
  const std::string book = guessed_rules(facts.log).book;
  std::vector<referee::Configuration> configurations;
  for (const RecordedGame& recorded : facts.games) {
    configurations.push_back(
        game::referee_configuration(game::resolved(logged_game(book, facts, recorded))));
    configurations.back().rules.change_ends = true;
  }
  return configurations;
}

}  // namespace

LoggedGhost logged_ghost(const std::filesystem::path& log, double at_s, Side side) try {
  const RecordedFacts facts = facts_of(log);
  const std::vector<referee::Configuration> configurations = judging_configurations(facts);
  const RecordedTeams teams = teams_in(log, configurations.front().field, true);
  GhostReader reader(configurations, teams, at_s, side);
  league::read_log(log, reader);
  reader.check(log);
  return reader.finish();
} catch (const league::LogError& error) {
  throw std::invalid_argument(error.what());
}

}  // namespace autoref::logs
