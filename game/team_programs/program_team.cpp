#include "game/team_programs/program_team.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "league/team/team_fault.hpp"

namespace autoref::game {
namespace {

constexpr double kGrace_s = 1.0;

league::TeamStart start_of(const strategies::TeamContext& context) {
  league::TeamStart start;
  start.side = context.side;
  start.field = context.field;
  start.rules = context.rules;
  start.rules.in_force = context.enforced;
  start.obeyed = context.rules.in_force;
  start.frame_rate_hz = context.frame_rate_hz;
  start.latency_s = context.latency_s;
  start.random_seed = context.random_seed;
  start.params = context.params;
  start.robots.assign(context.robots.begin(), context.robots.begin() + context.robot_count);
  return start;
}

}  // namespace

ProgramTeam::ProgramTeam(const ProgramSpec& spec, const strategies::TeamContext& context)
    : start_(start_of(context)) {
  blame_program([&] { process_.emplace(spec); });
}

// Records the program's first fault and does nothing after that.
template <typename Action>
void ProgramTeam::blame_program(const Action& action) {
  if (!fault_.empty()) return;
  try {
    action();
  } catch (const league::TeamFault& fault) {
    fault_ = process_->fault(fmt::format("sent bad output: {}", fault.what())).what();
  } catch (const ProgramError& error) {
    fault_ = error.what();
    was_killed_ = error.was_killed_from_outside;
  }
}

template <typename Message>
void ProgramTeam::send(const Message& message) {
  bytes_.clear();
  codec_->append(message, bytes_);
  process_->write(bytes_);
}

// Reads the greeting, which must be the only output so far, and answers with START.
void ProgramTeam::begin() {
  const ProgramProcess::Clock::time_point deadline = process_->answer_deadline();
  std::string received;
  std::optional<league::GreetingAndSize> found;
  while (!found) {
    received += process_->read(deadline);
    found = league::find_greeting(received);
  }
  if (found->size != received.size()) throw league::TeamFault("output before the first frame");
  greeting_ = found->greeting;
  codec_ = league::make_team_codec(greeting_->encoding);
  decoder_.emplace(*codec_);
  send(start_);
}

void ProgramTeam::sense(const strategies::SensorReadings& readings) {
  frame_.ball_in_dribbler_zone = readings.ball_in_dribbler_zone;
  if (greeting_ && greeting_->motion == league::TeamMotion::kTracked) return;
  frame_.detections = readings.detections;
}

void ProgramTeam::prepare(const TeamView& view) {
  blame_program([&] {
    if (!greeting_) begin();
    if (process_->has_output()) throw league::TeamFault("output before the frame that it answers");
    frame_.view = view;
    if (greeting_->motion == league::TeamMotion::kTracked) frame_.detections.reset();
    send(frame_);
  });
}

void ProgramTeam::decide(const TeamView& view, TeamCommands& commands) {
  blame_program([&] { receive(view.frame); });
  if (was_killed_) throw ProgramKilled(fault_);
  if (!fault_.empty()) throw strategies::StrategyFault(fault_);
  std::transform(output_.commands.begin(), output_.commands.end(), commands.begin(), transmitted);
}

// Reads one output, which must be the only one.
void ProgramTeam::receive(std::int64_t frame) {
  using Result = league::OutputDecoder::Result;
  const ProgramProcess::Clock::time_point deadline = process_->answer_deadline();
  Result result = decoder_->next(output_);
  while (result == Result::kNeedsMore) {
    decoder_->add(process_->read(deadline));
    result = decoder_->next(output_);
  }
  if (result == Result::kFault) throw league::TeamFault(decoder_->fault());
  if (decoder_->bytes_left() > 0) throw league::TeamFault("more than one output for a frame");
  if (output_.frame != frame) {
    throw process_->fault(fmt::format("answered frame {} instead of {}", output_.frame, frame));
  }
}

void ProgramTeam::end(const strategies::GameEnd& end) {
  blame_program([&] {
    if (greeting_) send(league::TeamEnd{end.reason, end.goals_own, end.goals_opponent});
  });
  if (process_) ending_ = process_->end(fault_.empty() ? kGrace_s : 0);
}

}  // namespace autoref::game
