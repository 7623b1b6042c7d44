// Collects the facts about a game (recorded_facts.hpp) from its frames and packets, including its
// game events and the noise of its vision.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "game/loop/event_log.hpp"
#include "league/log_contents.hpp"
#include "league/messages/referee.pb.h"
#include "logs/recorded_facts.hpp"
#include "soccer/frame.hpp"
#include "tracking/tracker.hpp"

namespace autoref::logs {

// Collects the game events in a log's referee packets, each once. Packets repeat an event for as
// long as the game controller keeps it. The time of the event is that of the first of these
// packets. Two events are the same if their ids are equal or, without ids, if everything except
// their origins is equal. An event without id and creation time that reappears later is a new one.
// Events in the log's first packet happened earlier and are left out, as are proposals, which the
// game controller has not accepted.
class RecordedGameEvents {
 public:
  static constexpr std::size_t kMostEvents = 10'000;

  void add(double time_s, const league::RefereePacket& packet);

  // The events in order of time, at most kMostEvents.
  const std::vector<game::TimedGameEvent>& events() const { return events_; }

 private:
  void add_new(double time_s, const league::RefereePacket& packet);

  bool is_first_ = true;
  std::vector<std::string> current_;  // the serialised events of the last packet
  std::set<std::string> shown_;       // keys of the last packet's events
  std::set<std::string> known_;       // keys of all events that have an id or a time of creation
  std::vector<game::TimedGameEvent> events_;
};

// Measures the noise of the vision that recorded a log from third-order differences of four
// successive positions. These differences hardly depend on motion, since accelerations change
// slowly compared with the frame rate. The differences are sqrt(20) times as noisy as a position.
// Kicks and false detections do not affect their median absolute value.
class LoggedNoise {
 public:
  // Frames must be in order of time.
  void add(const Frame& frame);

  // The standard deviations of the noise. Zero if there is hardly any, as in logs of a simulator
  // without noise. nullopt if the log is too short or its frames are too irregular for an estimate.
  std::optional<tracking::VisionNoise> noise() const;

 private:
  // The latest positions of one body.
  class Track {
   public:
    // Returns the third difference if the last four positions are evenly spaced.
    std::optional<Vec2> add(double time_s, const Vec2& position);

   private:
    struct Position {
      double time_s = 0;
      Vec2 at{0, 0};
    };
    std::vector<Position> latest_;
  };

  void add(const RobotObservation& robot, Side side, double time_s);

  PerSide<std::array<Track, kMaxRobots>> robots_;
  PerSide<std::array<Track, kMaxRobots>> headings_;
  Track ball_;
  std::vector<double> robot_m_;
  std::vector<double> robot_rad_;
  std::vector<double> ball_m_;
};

class FactsCollector final : public league::LogVisitor {
 public:
  void on_frame(const Frame& frame) override;
  void on_vision(double time_s, const league::VisionPacket& packet) override;
  void on_referee(double time_s, const league::RefereePacket& packet) override;

  // The facts so far, together with the summary of the messages themselves.
  RecordedFacts facts(const league::LogSummary& log) const;

 private:
  void note_command(const RecordedCommand& recorded);
  void note_stage(Stage stage);
  void note_clock(Stage stage, double left_s);

  RecordedFacts facts_;
  LoggedNoise noise_;
  RecordedGameEvents game_events_;
  NextGame next_game_;
};

}  // namespace autoref::logs
