// Tries out an experiment before it is run: whether its teams play, and how long it will take.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "experiments/run/played_part.hpp"
#include "experiments/schedule/schedule.hpp"

namespace autoref::experiments {

// The wall time that a team takes in a game.
struct TrialTeam {
  std::string name;         // the team's name, as in result rows
  bool is_program = false;  // a separate program, not compiled in
  double wall_s_a_game = 0;
};

// Trial games of one combination of values or one matchup.
struct Trial {
  std::string played;        // prefix of the games' ids, such as "b.handicap=0.8"
  int games = 0;             // number of games in the experiment
  std::string void_reason;   // empty unless the trial game is void
  double wall_s_a_game = 0;  // estimate; 0 if void
  // False if there was no time for the trial; the estimate is then the mean of the other trials.
  bool was_tried = true;
  double share = 1;  // share of a game in the longest part played; 1 if void or not tried
  std::array<TrialTeam, 2> teams = {};  // a and b
  std::size_t variant = 0;              // as in ScheduledGame
};

struct TrialOptions {
  // Plays a game for at most this wall time; called in workers (played_part.hpp).
  std::function<PlayedPart(const game::GameConfiguration&, double most_wall_s)> play;
  int workers = 1;       // use as many as the experiment, since workers share caches and processors
  double longest_s = 8;  // approximate wall-clock limit for all trials together
};

// Simulated length of each half in the first trial, unless the game's halves are shorter.
inline constexpr double kTrialHalf_s = 5;

// The wall time that it took to play a part of a game.
struct PartTime {
  double share = 0;  // share of the game's length
  double wall_s = 0;
  double start_s = 0;              // part of `wall_s` before the first frame
  std::array<double, 2> team_s{};  // part of `wall_s` taken by teams a and b
};

// Estimates the wall time of a whole game. `parts` begins with the shortest part.
double estimated_game_s(const std::vector<PartTime>& parts);

// Returns one trial per combination of values or matchup, in the schedule's order. Each trial first
// plays a few seconds, to see whether its teams play at all; if that takes long, each trial stops
// after an equal share of the available time. Then it plays one or more whole games if there is
// time, otherwise the longest part of a game that can be played in the time left. The start of a
// game costs less than its middle, and under the 2026 rules the clock stops when play does, so only
// longer parts show how long a game takes. If a team is a program, the estimate includes the time
// for a second start of the program, with which a run checks whether it repeats its commands.
// Throws Interrupted if the user interrupts.
std::vector<Trial> play_trials(const std::vector<ScheduledGame>& games,
                               const TrialOptions& options);

// Estimated wall time for all games with this number of workers, in s.
double duration_s(const std::vector<Trial>& trials, int workers);

// The part of duration_s() taken by teams that are programs, the largest first: "of that, the
// teams' programs take: mine 35 s (83 %); everything else takes about 7 s". Empty if no team is a
// program.
std::string cost_of_programs(const std::vector<Trial>& trials, int workers);

}  // namespace autoref::experiments
