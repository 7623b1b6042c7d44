// Maps of what teams did with the ball in many games, as figures for documents. Each team has a
// panel with the field as the team sees it: it attacks to the right. Panels share their scales, so
// that teams can be compared.
#pragma once

#include <string>
#include <vector>

#include "soccer/field.hpp"
#include "soccer/geometry.hpp"

namespace autoref::view {

// Positions are in the team's frame: its own goal is at -x, and y points to its left.
struct MappedShot {
  Vec2 from_m{0, 0};  // the ball at the kick
  double xg = 0;
  bool has_scored = false;
};

struct MappedChain {
  Vec2 first_m{0, 0};  // the ball at the team's first touch
  Vec2 last_m{0, 0};   // and at the end
  double xg = 0;       // sum over its shots
};

// A team in the games that the maps show.
struct MappedTeam {
  std::string name;
  int games = 0;  // at least 1
  std::vector<MappedShot> shots;
  std::vector<MappedChain> chains;
  std::vector<Vec2> losses_m;  // the ball where the team lost it
};

// All maps are SVG, and take at least one team.

// Each shot is a dot whose area is proportional to its expected goals; shots that scored
// are orange.
std::string shot_map(const Field& field, const std::vector<MappedTeam>& teams);

// For each square of the field, the possession chains that began in it: the area of the dot is
// proportional to their number per game, its colour shows their mean xG, and the arrow leads from
// their mean start to their mean end. Squares with fewer than three chains are left out.
std::string chain_map(const Field& field, const std::vector<MappedTeam>& teams);

// For each square of the field, the number of losses per game, as a heat map.
std::string loss_map(const Field& field, const std::vector<MappedTeam>& teams);

}  // namespace autoref::view
