// The referee's configuration. It consists of the rules of one match as given in its file, which
// settings, game and referee share, and the thresholds for touch detection.
#pragma once

#include <cstdint>

#include "soccer/field.hpp"
#include "soccer/named.hpp"
#include "soccer/parameters.hpp"
#include "soccer/rules/rule_book.hpp"
#include "soccer/side.hpp"
#include "soccer/units.hpp"
#include "tracking/tracker.hpp"

namespace autoref::referee {

// "At the end of the second half, AutoRef can either signal for a new game to begin or simply
// leave the robots halted" (paper, section 4.2).
enum class AfterGame : std::uint8_t { kHalt, kNewGame };

constexpr auto names_of(AfterGame /*any*/) {
  return std::to_array<Named<AfterGame>>(
      {{AfterGame::kHalt, "halt"}, {AfterGame::kNewGame, "new_game"}});
}

// How a game ends if a team fails (strategies::StrategyFault and the like): the game has no result,
// or the other team wins it.
enum class OnTeamFault : std::uint8_t { kVoid, kForfeit };

constexpr auto names_of(OnTeamFault /*any*/) {
  return std::to_array<Named<OnTeamFault>>(
      {{OnTeamFault::kVoid, "void"}, {OnTeamFault::kForfeit, "forfeit"}});
}

// Who commands the game. Alongside a person, AutoRef follows the person's commands; when it makes a
// call itself, it sends STOP, and the person decides how play resumes (paper, sections 4.1 and 5).
// If nobody commands the game, play is always on, and calls are only reported. The league's game
// controller may command simulated games; AutoRef follows it like a person.
enum class Control : std::uint8_t { kAutoref, kHuman, kNone, kGameController };

constexpr auto names_of(Control /*any*/) {
  return std::to_array<Named<Control>>({{Control::kAutoref, "autoref"},
                                        {Control::kHuman, "human"},
                                        {Control::kNone, "none"},
                                        {Control::kGameController, "game-controller"}});
}

// Who moves the ball to the position of the next free kick or force start: the simulator, or the
// teams' robots (2026, Ball Placement). For kick-offs and penalty kicks it is always the simulator.
enum class PlacedBy : std::uint8_t { kSimulator, kTeams };

constexpr auto names_of(PlacedBy /*any*/) {
  return std::to_array<Named<PlacedBy>>(
      {{PlacedBy::kSimulator, "simulator"}, {PlacedBy::kTeams, "teams"}});
}

using autoref::name_of;

struct Match {
  RuleBook rules;
  double half_s = 600;  // length of a half; ten minutes in the paper, section 4.2
  int halves = 2;
  double break_s = 0;  // length of a break; 300 s at half-time in the Laws
  bool knockout = false;
  AfterGame after_game = AfterGame::kHalt;
  OnTeamFault on_team_fault = OnTeamFault::kVoid;
  Control control = Control::kAutoref;
  double least_confidence = 0;  // machine/confidence.hpp
  PlacedBy placement = PlacedBy::kSimulator;
  Side a_plays = Side::kWest;  // the referee itself only knows sides
  Side first_kickoff = Side::kWest;

  template <typename Self, typename Visitor>
  static void visit(Self& self, const Visitor& visitor) {
    visitor(self.half_s, {"half_s", positive(36000), "length of a half"});
    visitor(self.halves, {"halves", {1, 2}, "number of halves"});
    visitor(self.break_s, {"break_s", {0, 3600}, "break between halves"});
    visitor(self.knockout, {"knockout", "extra time and a shoot-out after a draw"});
    visitor(self.after_game,
            {"after_game",
             "what the referee does after the game; the result row covers one game only"});
    visitor(self.on_team_fault,
            {"on_team_fault",
             "whether a game in which a team fails has no result or is won by the other team"});
    visitor(self.control,
            {"control",
             "who commands the game; human and none only in recorded games, game-controller only "
             "in play and live"});
    visitor(self.least_confidence, {"least_confidence", kFraction,
                                    "minimum confidence at which the referee calls a foul"});
    visitor(self.placement, {"placement", "who places the ball for free kicks and force starts"});
    visitor(self.rules, {"rules", "the rule book"});
    visitor(self.a_plays, {"a_plays", "side of team a; team b plays on the other side"});
    visitor(self.first_kickoff, {"first_kickoff", "side that kicks off first"});
  }
};

// Thresholds that separate touches from the effects of the carpet. The defaults suit a camera
// whose only error is rounding to float millimetres.
struct TouchParameters {
  // Largest deceleration that the carpet causes. Sliding balls decelerate by 3.0 to 3.9 m/s2 on the
  // league's carpets; smaller values mistake friction for touches, larger values miss soft touches.
  double carpet_mps2 = 5.0;
  // If the ball's velocity changes between frames by no more than this beyond what the carpet
  // causes, the change is ignored. Camera rounding causes 0.001 m/s at 60 Hz.
  double jump_mps = 0.02;
  // Standard deviation of the camera's ball positions. The detector sets it to the configured noise
  // and widens the distances below by three standard deviations.
  double position_noise_m = 0.0;
  // Largest distance, per frame, between the ball and the intersection of its free paths before and
  // after a touch. It is not zero because of carpet friction and the physics' sub-steps.
  double intersection_tolerance_m = 3_mm;
  // A robot farther from the ball's path than this did not touch it. Kickers reach 15 mm beyond the
  // plate.
  double reach_m = 20_mm;
  // Largest gap between ball and hull that may be measured at a bounce. The true gap is zero, but
  // the time and position of the bounce are only known with this accuracy.
  double contact_m = 5_mm;
  // If a robot is nearer to the ball than any robot of the other side by more than this, it touched
  // the ball; otherwise the toucher is unknown.
  double lead_m = 5_mm;
  // Cosine of the largest angle between a push and the hull's normal: 45 degrees. Friction deflects
  // the ball by 13 degrees.
  double bounce_cos = 0.7;
  // Cosine of the largest angle between a kick and the robot's heading: 25 degrees.
  double kick_cos = 0.9;
  // Largest gap between bodies in contact. The physics engine leaves gaps of half a millimetre.
  double touching_m = 1_mm;
  // If two hulls are at most this far from the ball, they pin it between them: if one can move the
  // ball, so can the other.
  double pinned_m = 2_mm;
  // If a hull is within touching_m of a ball that is faster than this, the robot pushes or carries
  // the ball.
  double carried_mps = 0.03_mps;
  // A hull within touching_m has pushed the ball if the ball's velocity along the direction of the
  // push increases by at least this much more than the previous velocity change explains. Soft
  // touches change the velocity less than the carpet does.
  double soft_push_mps = 0.02_mps;
  // A ball that is unseen for longer than this may have been touched in the meantime.
  double longest_gap_s = 100_ms;
};

// The match, and the field, robots and vision used for it. The referee itself does not use
// `on_team_fault` and `a_plays`.
struct Configuration : Match {
  Field field;
  PerSide<int> robots{{kMaxRobots, kMaxRobots}};  // per team, at the start
  tracking::VisionNoise noise;                    // noise in the vision frames
  double camera_error_m = 0;  // systematic error of a camera's positions, root mean square
  TouchParameters touch;      // thresholds of the touch detector
};

}  // namespace autoref::referee
