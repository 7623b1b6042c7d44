#include "game/loop/log_recorder.hpp"

#include <optional>
#include <string>
#include <utility>

#include "game/loop/game_event_fields.hpp"

namespace autoref::game {
namespace {

PerSide<league::LoggedTeam> logged_teams(const GameConfiguration& game) {
  const PerSide<std::string> names = shown_names(game);
  return {{league::LoggedTeam{names[Side::kWest]}, league::LoggedTeam{names[Side::kEast]}}};
}

}  // namespace

LogRecorder::LogRecorder(const std::filesystem::path& path, const GameConfiguration& game)
    : log_(path, game.field, logged_cameras(game), logged_teams(game)) {}

void LogRecorder::on_other_detections(const OtherDetections& others) { log_.note(others); }

void LogRecorder::on_frame(const Frame& frame, const RefereeSignal& signal,
                           const sim::World& /*world*/) {
  log_.add(frame, signal);
}

void LogRecorder::on_decision(const referee::Decision& decision) {
  if (decision.command) log_.note(*decision.command);
  if (std::optional<GameEvent> event = game_event_of(decision)) log_.note(*std::move(event));
}

}  // namespace autoref::game
