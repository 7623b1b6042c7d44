#include "tests/logs/changed_vision.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "league/detection_merger.hpp"
#include "league/message_fields.hpp"
#include "league/tracker_message.hpp"
#include "soccer/robot_shape.hpp"
#include "tracking/tracker.hpp"

namespace autoref::logs {
namespace {

using league::DetectionBall;
using league::DetectionFrame;
using league::DetectionRobot;
using league::MessageKind;

constexpr double kOverlap_m = 0.5;
constexpr double kOwnNoise_m = 0.0005;
constexpr double kAwayFromBall_m = 0.3;

template <typename Body>
Vec2 position_of(const Body& body) {
  return {league::to_m(body.x()), league::to_m(body.y())};
}

template <typename Body>
void put(const Vec2& position_m, Body& body) {
  body.set_x(league::to_mm(position_m.x()));
  body.set_y(league::to_mm(position_m.y()));
}

template <typename Body>
void blend(const Body& next, double share, Body& body) {
  put((1 - share) * position_of(body) + share * position_of(next), body);
}

void blend_robots(const google::protobuf::RepeatedPtrField<DetectionRobot>& next, double share,
                  google::protobuf::RepeatedPtrField<DetectionRobot>& robots) {
  for (DetectionRobot& robot : robots) {
    for (const DetectionRobot& other : next) {
      if (other.robot_id() != robot.robot_id()) continue;
      blend(other, share, robot);
      const double turn_rad = std::remainder(
          static_cast<double>(other.orientation() - robot.orientation()), 2 * std::numbers::pi);
      robot.set_orientation(robot.orientation() + static_cast<float>(share * turn_rad));
      break;
    }
  }
}

// What the camera would have seen between two frames.
DetectionFrame between(const DetectionFrame& one, const DetectionFrame& next, double share) {
  DetectionFrame frame = one;
  blend_robots(next.robots_yellow(), share, *frame.mutable_robots_yellow());
  blend_robots(next.robots_blue(), share, *frame.mutable_robots_blue());
  if (one.balls_size() > 0 && next.balls_size() > 0)
    blend(next.balls(0), share, *frame.mutable_balls(0));
  const double time_s = (1 - share) * one.t_capture() + share * next.t_capture();
  frame.set_t_capture(time_s);
  frame.set_t_sent(time_s);
  return frame;
}

template <typename Change>
void for_each_robot(DetectionFrame& frame, const Change& change) {
  for (DetectionRobot& robot : *frame.mutable_robots_yellow()) change(robot);
  for (DetectionRobot& robot : *frame.mutable_robots_blue()) change(robot);
}

template <typename Body, typename Sees>
void keep_if(google::protobuf::RepeatedPtrField<Body>& bodies, const Sees& sees) {
  google::protobuf::RepeatedPtrField<Body> kept;
  for (const Body& body : bodies) {
    if (sees(body)) *kept.Add() = body;
  }
  bodies.Swap(&kept);
}

Vec2 any_direction(RandomStream& chance) {
  return heading_of(2 * std::numbers::pi * chance.uniform());
}

// A camera with its part of the field and its error.
struct OneCamera {
  std::uint32_t id = 0;
  CameraPosition at;
  Vec2 half_view_m{0, 0};
  Vec2 error_m{0, 0};
  double error_rad = 0;

  bool sees(const Vec2& position_m) const {
    const Vec2 away_m = (position_m - at.position_m).cwiseAbs();
    return away_m.x() <= half_view_m.x() && away_m.y() <= half_view_m.y();
  }

  // `central` saw it before; `height_m` is the ball's true height.
  DetectionFrame seen(DetectionFrame frame, const CameraPosition& central, double height_m,
                      RandomStream& chance) const {
    const auto noise_m = [&chance] {
      const double x_m = kOwnNoise_m * chance.normal();
      return Vec2(x_m, kOwnNoise_m * chance.normal());
    };
    frame.set_camera_id(id);
    const auto is_seen = [this](const auto& body) { return sees(position_of(body)); };
    keep_if(*frame.mutable_balls(), is_seen);
    keep_if(*frame.mutable_robots_yellow(), is_seen);
    keep_if(*frame.mutable_robots_blue(), is_seen);
    for_each_robot(frame, [&](DetectionRobot& robot) {
      put(position_of(robot) + error_m + noise_m(), robot);
      robot.set_orientation(robot.orientation() + static_cast<float>(error_rad));
      robot.set_confidence(static_cast<float>(0.8 + 0.2 * chance.uniform()));
    });
    for (DetectionBall& ball : *frame.mutable_balls()) {
      const double below_m = central.height_m - kBallRadius_m;
      const Vec2 true_m = central.position_m + (position_of(ball) - central.position_m) *
                                                   ((below_m - height_m) / below_m);
      const Vec2 seen_m =
          at.position_m + (true_m - at.position_m) * (below_m / (below_m - height_m));
      put(seen_m + error_m + noise_m(), ball);
      ball.set_confidence(static_cast<float>(0.8 + 0.2 * chance.uniform()));
    }
    return frame;
  }
};

std::vector<OneCamera> cameras_above(const Field& field, int count, double height_m, double error_m,
                                     RandomStream& chance) {
  const int rows = count > 2 ? 2 : 1;
  const int columns = count / rows;
  const Vec2 part_m(field.length_m / columns, field.width_m / rows);
  constexpr double kBeyond_m = 1;  // around the field
  std::vector<OneCamera> cameras;
  cameras.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    OneCamera camera;
    const int column = i / rows;
    const int row = i % rows;
    camera.id = static_cast<std::uint32_t>(i);
    camera.at = {
        {(column - (columns - 1) / 2.0) * part_m.x(), (row - (rows - 1) / 2.0) * part_m.y()},
        height_m};
    camera.half_view_m =
        part_m / 2 + Vec2(columns > 1 ? kOverlap_m : kBeyond_m, rows > 1 ? kOverlap_m : kBeyond_m);
    const double size_m = error_m * chance.uniform();
    camera.error_m = size_m * any_direction(chance);
    camera.error_rad = error_m > 0 ? 0.0145 * chance.normal() : 0;
    cameras.push_back(camera);
  }
  return cameras;
}

template <typename Keep>
RecordedVision filtered(RecordedVision vision, const Keep& keep) {
  std::vector<DetectionFrame> frames;
  for (DetectionFrame& frame : vision.frames) {
    if (keep(frame.t_capture())) frames.push_back(std::move(frame));
  }
  vision.frames = std::move(frames);
  return vision;
}

std::int64_t index_at(const RecordedVision& vision, double time_s) {
  return std::llround(time_s * vision.rate_hz);
}

}  // namespace

RecordedVision at_rate(RecordedVision vision, double rate_hz) {
  const std::vector<DetectionFrame> all = std::move(vision.frames);
  vision.frames.clear();
  const double begin_s = all.front().t_capture();
  std::size_t i = 0;
  for (int number = 0; i + 1 < all.size(); ++number) {
    const double time_s = begin_s + number / rate_hz;
    while (i + 1 < all.size() && all[i + 1].t_capture() <= time_s) ++i;
    if (i + 1 == all.size()) break;
    const double share =
        (time_s - all[i].t_capture()) / (all[i + 1].t_capture() - all[i].t_capture());
    vision.frames.push_back(rate_hz > vision.rate_hz ? between(all[i], all[i + 1], share) : all[i]);
  }
  return vision;
}

RecordedVision irregular(RecordedVision vision, double share, double jitter_s,
                         RandomStream chance) {
  vision = filtered(std::move(vision), [&](double) { return chance.uniform() >= share; });
  for (DetectionFrame& frame : vision.frames) {
    const double time_s = frame.t_capture() + jitter_s * (2 * chance.uniform() - 1);
    frame.set_t_capture(std::max(0.0, time_s));
    frame.set_t_sent(frame.t_capture());
  }
  return vision;
}

RecordedVision with_silences(RecordedVision vision, double length_s, double every_s) {
  return filtered(std::move(vision),
                  [=](double time_s) { return std::fmod(time_s, every_s) < every_s - length_s; });
}

RecordedVision through_cameras(RecordedVision vision, int cameras, double error_m,
                               bool is_staggered, RandomStream chance) {
  const std::vector<DetectionFrame> all = std::move(vision.frames);
  const CameraPosition central = vision.cameras.front();
  const std::vector<OneCamera> each =
      cameras_above(vision.field, cameras, central.height_m, error_m, chance);
  vision.frames.clear();
  vision.cameras.clear();
  vision.cameras.reserve(each.size());
  for (const OneCamera& camera : each) vision.cameras.push_back(camera.at);
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    const auto index = static_cast<std::size_t>(index_at(vision, all[i].t_capture()));
    const double height_m = vision.ball_height_m[std::min(index, vision.ball_height_m.size() - 1)];
    for (const OneCamera& camera : each) {
      const double share = is_staggered ? static_cast<double>(camera.id) / cameras : 0;
      vision.frames.push_back(
          camera.seen(between(all[i], all[i + 1], share), central, height_m, chance));
    }
  }
  return vision;
}

RecordedVision with_false_balls(RecordedVision vision, double per_s, RandomStream chance) {
  struct FalseBall {
    Vec2 at_m;
    double until_s;
  };
  std::vector<FalseBall> balls;
  for (DetectionFrame& frame : vision.frames) {
    const double time_s = frame.t_capture();
    if (chance.uniform() < per_s / vision.rate_hz) {
      const double x_m = vision.field.length_m * (chance.uniform() - 0.5);
      const double y_m = vision.field.width_m * (chance.uniform() - 0.5);
      balls.push_back({{x_m, y_m}, time_s + chance.uniform()});
    }
    std::erase_if(balls, [time_s](const FalseBall& ball) { return ball.until_s < time_s; });
    const bool has_true = frame.balls_size() > 0;
    const Vec2 true_m = has_true ? position_of(frame.balls(0)) : Vec2(0, 0);
    for (const FalseBall& ball : balls) {
      if (has_true && (ball.at_m - true_m).norm() < kAwayFromBall_m) continue;
      DetectionBall& seen = *frame.add_balls();
      seen.set_confidence(1);
      seen.set_pixel_x(0);
      seen.set_pixel_y(0);
      put(ball.at_m, seen);
    }
  }
  return vision;
}

RecordedVision with_second_ball(RecordedVision vision, const Vec2& at_m) {
  for (DetectionFrame& frame : vision.frames) {
    DetectionBall& ball = *frame.add_balls();
    ball.set_confidence(0.9F);
    ball.set_pixel_x(0);
    ball.set_pixel_y(0);
    put(at_m, ball);
  }
  return vision;
}

RecordedVision with_double_robots(RecordedVision vision, double share, double least_m,
                                  RandomStream chance) {
  const auto double_some = [&](google::protobuf::RepeatedPtrField<DetectionRobot>& robots) {
    const int count = robots.size();
    for (int i = 0; i < count; ++i) {
      robots[i].set_confidence(static_cast<float>(0.8 + 0.2 * chance.uniform()));
      if (chance.uniform() >= share) continue;
      const double away_m = least_m + (1 - least_m) * chance.uniform();
      DetectionRobot other = robots[i];
      put(position_of(other) + away_m * any_direction(chance), other);
      other.set_confidence(static_cast<float>(0.8 + 0.2 * chance.uniform()));
      *robots.Add() = other;
    }
  };
  for (DetectionFrame& frame : vision.frames) {
    double_some(*frame.mutable_robots_yellow());
    double_some(*frame.mutable_robots_blue());
  }
  return vision;
}

RecordedVision from(RecordedVision vision, double begin_s) {
  std::erase_if(vision.referee, [begin_s](const league::LogRecord& record) {
    return record.time_ns < league::to_ns(begin_s);
  });
  return filtered(std::move(vision), [begin_s](double time_s) { return time_s >= begin_s; });
}

RecordedVision with_tracker(RecordedVision vision) {
  league::DetectionMerger merger;
  tracking::Tracker tracker;
  const auto track = [&](const Frame* frame) {
    if (frame == nullptr) return;
    league::TrackerPacket packet;
    fill_tracker(tracker.update(*frame), {"1", "tracker"}, frame->time_s, packet);
    vision.tracker.push_back({league::to_ns(frame->time_s),
                              static_cast<int>(MessageKind::kTracker2020),
                              packet.SerializeAsString()});
  };
  for (const DetectionFrame& frame : vision.frames) {
    league::VisionPacket packet;
    *packet.mutable_detection() = frame;
    track(merger.add(packet, frame.t_capture()));
  }
  track(merger.finish());
  return vision;
}

RecordedVision without_referee(RecordedVision vision) {
  vision.referee.clear();
  return vision;
}

}  // namespace autoref::logs
