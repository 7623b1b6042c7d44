#include "tests/logs/recorded_vision.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "game/loop/game.hpp"
#include "game/loop/game_configuration.hpp"
#include "game/loop/log_recorder.hpp"
#include "game/settings/fields.hpp"
#include "game/settings/game_settings.hpp"
#include "league/field_message.hpp"
#include "league/message_fields.hpp"
#include "logs/log_game.hpp"
#include "logs/log_referee.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::logs {
namespace {

using league::MessageKind;

class VisionRecorder final : public game::LogRecorder {
 public:
  using LogRecorder::LogRecorder;
  void on_frame(const Frame& frame, const RefereeSignal& signal, const sim::World& world) override {
    LogRecorder::on_frame(frame, signal, world);
    ball_height_m.push_back(world.state().ball.height_m);
  }

  std::vector<double> ball_height_m;
};

// Reads the packets of a log with one camera.
void read_packets(const std::filesystem::path& path, RecordedVision& vision) {
  league::LogReader log(path);
  league::LogRecord record;
  while (log.read(record)) {
    if (record.kind == static_cast<int>(MessageKind::kReferee2013)) {
      vision.referee.push_back(record);
      continue;
    }
    league::VisionPacket packet;
    packet.ParseFromString(record.message);
    if (packet.has_detection()) vision.frames.push_back(packet.detection());
  }
}

}  // namespace

RecordedVision played_vision(const std::string& book, double half_s, std::uint64_t seed) {
  game::GameSettings game;
  game::choose_rules(book, game);
  game::set_by_path(game, "sim.camera", "rc2026-b");
  game.match.half_s = half_s;
  game.a.strategy = "cobalt";
  game.b.strategy = "counter";
  game.seed = seed;
  const game::GameConfiguration configuration = game::resolved(game);
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "game.log";
  VisionRecorder recorder(path, configuration);
  game::play(configuration, &recorder);
  recorder.close();
  RecordedVision vision{book,
                        configuration.field,
                        configuration.sim.frame_rate_hz,
                        game::logged_cameras(configuration),
                        {},
                        recorder.ball_height_m,
                        {}};
  read_packets(path, vision);
  return vision;
}

void write_log(const RecordedVision& vision, const std::filesystem::path& log) {
  std::vector<league::LogRecord> records;
  records.reserve(vision.frames.size() + 1);
  league::VisionPacket geometry;
  fill_geometry(vision.field, vision.cameras, *geometry.mutable_geometry());
  const double begin_s = vision.frames.front().t_capture();
  records.push_back({league::to_ns(begin_s), static_cast<int>(MessageKind::kVision2014),
                     geometry.SerializeAsString()});
  for (const league::DetectionFrame& frame : vision.frames) {
    league::VisionPacket packet;
    *packet.mutable_detection() = frame;
    records.push_back({league::to_ns(frame.t_capture()), static_cast<int>(MessageKind::kVision2014),
                       packet.SerializeAsString()});
  }
  records.insert(records.end(), vision.tracker.begin(), vision.tracker.end());
  records.insert(records.end(), vision.referee.begin(), vision.referee.end());
  std::stable_sort(records.begin(), records.end(),
                   [](const auto& a, const auto& b) { return a.time_ns < b.time_ns; });
  league::LogWriter writer(log);
  for (const league::LogRecord& record : records)
    writer.write(record.time_ns, static_cast<MessageKind>(record.kind), record.message);
  writer.close();
}

std::vector<Call> judged_calls(const RecordedVision& vision, const std::filesystem::path& log,
                               league::FrameSource source) {
  write_log(vision, log);
  RecordedFacts facts = facts_of(log, source);
  const game::GameConfiguration game =
      game::resolved(logged_game(vision.book, facts, facts.games.front()));
  facts.teams = teams_in(log, game.field, game.match.rules.change_ends, source);
  const auto check = [](const referee::Decision& decision) {
    EXPECT_TRUE(std::isfinite(decision.time_s) && std::isfinite(decision.finding.value));
  };
  const LogRefereeResult judged =
      referee_log(log, facts, {game::referee_configuration(game)}, check);
  EXPECT_EQ(judged.events.find("nan"), std::string::npos);
  return judged.calls;
}

}  // namespace autoref::logs
