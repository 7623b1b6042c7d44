// What `autoref compare --ci` writes for a team's continuous integration: the comparison as
// Markdown and as JUnit XML.
#pragma once

#include <string>
#include <vector>

#include "app/experiment/requirement.hpp"
#include "experiments/kinds/results.hpp"
#include "experiments/results/game_row.hpp"

namespace autoref::app {

// Void games with the same reason, such as those in which one team's program crashed.
struct VoidProblem {
  std::string text;  // "team new ended with status 1"
  std::vector<std::string> games = {};
};

// The problems in the order of their first games. Reasons that name team a or b name the team of
// the scenario instead; the time of the fault is left out.
std::vector<VoidProblem> void_problems(const experiments::RowsById& rows);

struct CiReport {
  std::string name;   // "autoref compare basic my_team.py"; the same for every version of the teams
  std::string about;  // which teams these are
  experiments::ComparisonAnswer answer;
  Requirement requirement;
  bool has_too_many_void = false;  // so many that the answer does not count
  int games = 0;
  std::vector<VoidProblem> problems;
  std::string rules;
  std::string seed;
  std::string build;
  std::string command;  // repeats the comparison
  std::string folder;   // the results folder
};

// A page for a comment or a summary: title, answer, opponents, problems, and, folded, the parts of
// the difference, what the new team does differently, and how to repeat the comparison.
std::string comparison_markdown(const CiReport& report);

// One suite. The first case is the requirement: it passes if it is met, also if the comparison is
// undecided and the requirement allows for that; it fails if it is not met; and it has an error if
// too many games are void. Each problem is a further case, with an error.
std::string comparison_junit(const CiReport& report);

}  // namespace autoref::app
