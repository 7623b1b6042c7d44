// Changes the vision of a played game: another frame rate, several cameras, false balls, or robots
// that appear twice.
#pragma once

#include "soccer/random.hpp"
#include "tests/logs/recorded_vision.hpp"

namespace autoref::logs {

// Drops frames, or interpolates between them, to get this rate.
RecordedVision at_rate(RecordedVision vision, double rate_hz);

// Drops a fraction of the frames and changes the times of the others by up to `jitter_s`.
RecordedVision irregular(RecordedVision vision, double share, double jitter_s, RandomStream chance);

// Once in every `every_s`, vision is silent for `length_s`.
RecordedVision with_silences(RecordedVision vision, double length_s, double every_s);

// The view of cameras that hang in rows. Each has its own offset of up to `error_m` and its own
// confidence, and sees 0.5 m beyond its part of the field. With `is_staggered` they take turns
// within a frame.
RecordedVision through_cameras(RecordedVision vision, int cameras, double error_m,
                               bool is_staggered, RandomStream chance);

// Adds false balls away from the true one: `per_s` appear per second, and each stays for up to 1 s.
RecordedVision with_false_balls(RecordedVision vision, double per_s, RandomStream chance);

// Adds a ball that lies still on the field.
RecordedVision with_second_ball(RecordedVision vision, const Vec2& at_m);

// A fraction of the robots appears a second time, from `least_m` to 1 m away.
RecordedVision with_double_robots(RecordedVision vision, double share, double least_m,
                                  RandomStream chance);

// Keeps only the part from that time on.
RecordedVision from(RecordedVision vision, double begin_s);

// Adds the packets of a tracker.
RecordedVision with_tracker(RecordedVision vision);

RecordedVision without_referee(RecordedVision vision);

}  // namespace autoref::logs
