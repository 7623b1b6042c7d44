#include "tests/referee/rules/staged_game.hpp"

#include <algorithm>
#include <stdexcept>

namespace autoref::referee {
namespace {

constexpr double kRate_hz = 60;

Side seen_side(Side side, bool turned) { return turned ? opponent_of(side) : side; }

RuleBook book_of(const Case& it) {
  RuleBook book = *find_rule_book(it.book);
  for (const auto& [name, on] : it.switches) book.in_force[*find_rule(name)] = on;
  return book;
}

Configuration configuration_of(const Case& it, bool turned) {
  Configuration configuration;
  const GameSetup setup = *find_game_setup(it.book);
  configuration.rules = book_of(it);
  configuration.field = setup.field;
  configuration.half_s = setup.half_s;
  configuration.robots = {{setup.robots, setup.robots}};
  const bool is_kickoff = it.opening == Opening::kKickoff;
  const Side first = is_kickoff ? it.taken_by : Side::kWest;
  configuration.first_kickoff = seen_side(first, turned);
  configuration.noise = {it.noise_m, it.noise_m, it.noise_m / 0.1};
  return configuration;
}

// Whether the event belongs to the machine's own procedure, not to a rule.
bool is_procedure(Event event) {
  switch (event) {
    case Event::kBegin:
    case Event::kRobotsMoved:
    case Event::kStartTimeout:
    case Event::kReady:
    case Event::kReadyTimeout:
    case Event::kSignalled:
      return true;
    default:
      return false;
  }
}

}  // namespace

StagedGame::StagedGame(const Case& it, bool turned)
    : case_(it),
      turned_(turned),
      field_(configuration_of(it, turned).field),
      referee_(configuration_of(it, turned)),
      bodies_(it.ball_deceleration_mps2),
      random_(it.seed) {
  for (const Side side : kSides) requests_[seen_side(side, turned)].keeper = it.keepers[side];
}

void StagedGame::play() {
  open();
  all_.clear();
  began_s_ = static_cast<double>(frame_number_) / kRate_hz;
  goals_before_ = goals();
  std::size_t next_cue = 0;
  const int frames = static_cast<int>(case_.until_s * kRate_hz + 0.5);
  for (int i = 0; i <= frames; ++i) {
    while (next_cue < case_.script.size() && case_.script[next_cue].at_s <= i / kRate_hz) {
      obey(case_.script[next_cue++]);
    }
    step();
  }
  calls_ = all_;
}

void StagedGame::obey(const Cue& cue) {
  if (cue.kind == Cue::Kind::kRequest) {
    requests_[seen_side(cue.robot.side, turned_)].timeout = cue.on;
  } else {
    bodies_.obey(cue);
  }
}

void StagedGame::step() {
  Frame frame = bodies_.look();
  frame.number = frame_number_;
  frame.time_s = static_cast<double>(frame_number_) / kRate_hz;
  ++frame_number_;
  look(frame);
  signal_ = referee_.update(turned_ ? mirrored(frame) : frame, requests_);
  hear();
  bodies_.advance(1 / kRate_hz);
  place_ball();
}

// The noise is drawn before a frame is turned, so turned frames have the turned noise.
void StagedGame::look(Frame& frame) {
  if (case_.noise_m == 0) return;
  const auto off_m = [&] {
    const double x_m = random_.normal() * case_.noise_m;
    const double y_m = random_.normal() * case_.noise_m;
    return Vec2(x_m, y_m);
  };
  for (const Side side : kSides) {
    for (RobotObservation& robot : frame.robots[side]) robot.position_m += off_m();
  }
  if (frame.ball) frame.ball->position_m += off_m();
}

void StagedGame::place_ball() {
  if (!signal_.placement) return;
  const bool at_once = case_.placement_mps == 0 || signal_.placement->at_once;
  const Vec2 target_m = turned_ ? Vec2(-signal_.placement->target_m) : signal_.placement->target_m;
  bodies_.place_ball(target_m, at_once ? 1e3 : case_.placement_mps / kRate_hz);
}

void StagedGame::hear() {
  for (const Decision& decision : referee_.decisions()) {
    if (is_procedure(decision.finding.event)) continue;
    Call call{decision, decision.time_s - began_s_, signal_.next_command, std::nullopt};
    if (call.next) call.next = turned(*call.next);
    if (signal_.placement) call.ball_m = signal_.placement->target_m * (turned_ ? -1 : 1);
    for (RobotId& robot : call.decision.finding.robots) robot.side = seen_side(robot.side, turned_);
    Decision& said = call.decision;
    if (said.finding.offender) said.finding.offender = seen_side(*said.finding.offender, turned_);
    all_.push_back(call);
  }
}

PerSide<int> StagedGame::goals() const {
  PerSide<int> goals;
  for (const Side side : kSides) {
    goals[side] = signal_.goals[seen_side(side, turned_)] - goals_before_[side];
  }
  return goals;
}

void StagedGame::run(double seconds) {
  const int frames = static_cast<int>(seconds * kRate_hz + 0.5);
  for (int i = 0; i < frames; ++i) step();
}

}  // namespace autoref::referee
