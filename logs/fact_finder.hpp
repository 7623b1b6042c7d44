// Collects the facts about a game (recorded_facts.hpp) from its frames and packets.
#pragma once

#include "league/log_contents.hpp"
#include "logs/logged_noise.hpp"
#include "logs/recorded_facts.hpp"
#include "logs/recorded_game_events.hpp"

namespace autoref::logs {

class FactFinder final : public league::LogVisitor {
 public:
  void on_frame(const Frame& frame) override;
  void on_vision(double time_s, const league::VisionPacket& packet) override;
  void on_referee(double time_s, const league::RefereePacket& packet) override;

  // The facts so far, with what is known of the messages themselves.
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
