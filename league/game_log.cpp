#include "league/game_log.hpp"

#include "league/units.hpp"

namespace autoref::league {

GameLog::GameLog(const std::filesystem::path& path, const Field& field,
                 std::vector<CameraPosition> cameras, PerSide<LoggedTeam> teams)
    : file_(path), packets_(field, std::move(cameras), std::move(teams), {}) {}

template <typename Message>
void GameLog::write(double time_s, MessageKind kind, const Message& message) {
  message.SerializeToString(&bytes_);
  file_.write(to_ns(time_s), kind, bytes_);
}

void GameLog::on_vision(double time_s, const VisionPacket& packet) {
  write(time_s, MessageKind::kVision2014, packet);
}

void GameLog::on_referee(double time_s, const RefereePacket& packet) {
  write(time_s, MessageKind::kReferee2013, packet);
}

}  // namespace autoref::league
