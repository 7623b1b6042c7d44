// Other vision of a played game: another frame rate, several cameras, false balls, or robots that
// appear twice.
#pragma once

#include "soccer/random.hpp"
#include "tests/logs/recorded_vision.hpp"

namespace autoref::logs {

// Drops frames, or interpolates between them, to get this rate.
RecordedVision at_rate(RecordedVision vision, double rate_hz);

// Drops a share of the frames and changes the times of the others by up to `jitter_s`.
RecordedVision irregular(RecordedVision vision, double share, double jitter_s, RandomStream chance);

// Vision is silent `length_s` long, `every_s`.
RecordedVision with_silences(RecordedVision vision, double length_s, double every_s);

// What cameras that hang in rows see: each has its own offset of up to `error_m`, sees 0.5 m beyond
// its part of the field, and detects everything with its own confidence. With `is_staggered` they
// take turns within a frame.
RecordedVision through_cameras(RecordedVision vision, int cameras, double error_m,
                               bool is_staggered, RandomStream chance);

// False balls away from the true one: `per_s` appear per second, and each stays for up to 1 s.
RecordedVision with_false_balls(RecordedVision vision, double per_s, RandomStream chance);

// Another ball lies still on the field.
RecordedVision with_second_ball(RecordedVision vision, const Vec2& at_m);

// A share of the robots appears a second time, from `least_m` to 1 m away.
RecordedVision with_double_robots(RecordedVision vision, double share, double least_m,
                                  RandomStream chance);

// Only what happens from that time on.
RecordedVision from(RecordedVision vision, double begin_s);

// With the packets of a tracker.
RecordedVision with_tracker(RecordedVision vision);

RecordedVision without_referee(RecordedVision vision);

}  // namespace autoref::logs
