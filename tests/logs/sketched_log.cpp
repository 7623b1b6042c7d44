#include "tests/logs/sketched_log.hpp"

#include <cmath>

#include "league/field_message.hpp"
#include "league/log_file.hpp"
#include "league/referee_message.hpp"
#include "league/vision_message.hpp"
#include "sim/camera.hpp"

namespace autoref::logs {
namespace {

using league::MessageKind;

constexpr double kSketchRate_hz = 60;

class Sketcher {
 public:
  Sketcher(const SketchedLog& sketch, const std::filesystem::path& log)
      : sketch_(sketch), log_(log), packets_(static_cast<std::size_t>(sketch.cameras)) {
    const auto all = sim::camera_positions(sketch.field, 4, 4);
    cameras_.assign(all.begin(), all.begin() + sketch.cameras);
  }

  void write() {
    const auto frames = static_cast<int>(sketch_.length_s * kSketchRate_hz);
    for (int frame = 0; frame < frames; ++frame) {
      const double time_s = frame / kSketchRate_hz;
      if (frame % 60 == 0 && sketch_.has_geometry) put_geometry(time_s);
      if (sketch_.has_vision) put_vision(frame, time_s);
      if (frame % 6 == 0 && sketch_.has_referee) put_referee(time_s);
    }
    log_.close();
  }

 private:
  template <typename Message>
  void put(double time_s, MessageKind kind, const Message& message) {
    const double record_s = sketch_.record_s ? sketch_.record_s(time_s) : time_s;
    log_.write(std::llround(record_s * 1e9), kind, message.SerializeAsString());
  }

  void put_geometry(double time_s) {
    league::VisionPacket packet;
    fill_geometry(sketch_.field, cameras_, *packet.mutable_geometry());
    league::FieldSize& size = *packet.mutable_geometry()->mutable_field();
    if (sketch_.change_field) sketch_.change_field(size);
    if (sketch_.change_field_later && time_s > sketch_.length_s / 2)
      sketch_.change_field_later(size);
    put(time_s, MessageKind::kVision2014, packet);
  }

  void put_vision(int number, double time_s) {
    fill_detections(frame_at(number, time_s), cameras_, packets_);
    for (league::VisionPacket& packet : packets_) {
      league::DetectionFrame& detection = *packet.mutable_detection();
      if (sketch_.capture_s) detection.set_t_capture(sketch_.capture_s(time_s));
      if (sketch_.change_detection) sketch_.change_detection(detection);
      put(time_s, MessageKind::kVision2014, packet);
    }
  }

  Frame frame_at(int number, double time_s) const {
    Frame frame;
    frame.number = number;
    frame.time_s = time_s;
    for (const Side side : kSides) {
      for (int robot = 0; robot < sketch_.robots[side]; ++robot) {
        const double x_m = goal_sign(side) * (0.4 + 0.2 * robot);
        frame.robots[side].push_back({robot, {x_m, 0.3 * std::sin(time_s + robot)}, {1, 0}});
      }
    }
    frame.ball = BallObservation{{0.1, sketch_.field.half_width_m() * time_s / 4}, 0.0, {}};
    return frame;
  }

  void put_referee(double time_s) {
    RefereeSignal signal;
    signal.stage = time_s < 1 ? Stage::kFirstHalfPre : Stage::kFirstHalf;
    signal.command_counter = time_s < 0.5 ? 1U : time_s < 1 ? 2U : 3U;
    signal.command.kind = time_s < 0.5 ? CommandKind::kStop
                          : time_s < 1 ? CommandKind::kPrepareKickoff
                                       : CommandKind::kNormalStart;
    signal.stage_time_left_s = 100 - time_s;
    league::RefereePacket packet;
    fill_referee(signal, {}, time_s, packet);
    if (sketch_.change_referee) sketch_.change_referee(time_s, packet);
    put(time_s, MessageKind::kReferee2013, packet);
  }

  const SketchedLog& sketch_;
  league::LogWriter log_;
  std::vector<CameraPosition> cameras_;
  std::vector<league::VisionPacket> packets_;
};

}  // namespace

void write_sketch(const SketchedLog& sketch, const std::filesystem::path& log) {
  Sketcher(sketch, log).write();
}

void join_logs(const std::vector<std::string>& logs, const std::filesystem::path& log) {
  league::LogWriter joined(log);
  for (const std::string& path : logs) {
    league::LogReader reader(path);
    league::LogRecord record;
    while (reader.read(record))
      joined.write(record.time_ns, static_cast<MessageKind>(record.kind), record.message);
  }
  joined.close();
}

}  // namespace autoref::logs
