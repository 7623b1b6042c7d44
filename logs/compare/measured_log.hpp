// Measures recorded games for a comparison.
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "logs/compare/measured_games.hpp"
#include "logs/fit/ball_fit.hpp"
#include "logs/fit/recorded_motion.hpp"
#include "logs/log_referee.hpp"
#include "logs/recorded_play.hpp"

namespace autoref::logs {

// Measures one log after the other. For each of them, call start_log(), note() for each frame while
// AutoRef judges it, and finish_log(). If a log cannot be judged, go on with the next one.
class GamesMeasurer {
 public:
  void start_log() { games_.start_log(); }
  void note(const LogReferee& judged);
  // `path` must be readable several times (user_log.hpp). Throws league::LogError if the file is
  // not a log. A log in which running play never stops, such as one cut down to play, does not say
  // how often it does: its stops and its share of the ball in play do not count.
  void finish_log(const std::string& path, const PlayOfLog& play);

  // Everything that has been measured. Reads all logs again, to find kicks with what they show
  // together about the ball.
  const MeasuredGames& finish();

  // How many logs have been measured, and the duration of running play in them.
  std::size_t logs() const { return paths_.size(); }
  double running_s() const { return running_s_; }

 private:
  void add(const RecordedMotion& motion);
  void add_ball_speeds(const RecordedMotion& motion);
  void add_ball_paths(const RecordedMotion& motion);
  void add_robots(const RecordedMotion& motion);
  void add_play(const RecordedMotion& motion);
  void add_ball_sights(const RecordedMotion& motion);
  void add(Measure measure, double time_s, double value) {
    games_.add(games_.logs(), measure, time_s, value);
  }

  MeasuredGames games_;
  std::map<int, std::string> paths_;  // by the number of the log in games_
  BallFit ball_;
  double running_s_ = 0;
  bool has_stops_ = false;  // in the log that is being measured
};

}  // namespace autoref::logs
