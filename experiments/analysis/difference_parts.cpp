#include "experiments/analysis/difference_parts.hpp"

#include <fmt/format.h>

#include <functional>
#include <stdexcept>
#include <string_view>

#include "experiments/schedule/schedule.hpp"
#include "experiments/statistics/anytime_interval.hpp"
#include "experiments/statistics/paired_difference.hpp"
#include "game/play_counts/play_counts.hpp"

namespace autoref::experiments {
namespace {

// A game as one of its teams sees it.
struct TeamGame {
  int goals = 0;
  int goals_against = 0;
  const game::PlayCounts* own = nullptr;
  const game::PlayCounts* opponents = nullptr;

  static TeamGame of_a(const game::GameRecord& record) {
    return {record.goals_a, record.goals_b, record.counts.data(), &record.counts[1]};
  }
  static TeamGame of_b(const game::GameRecord& record) {
    return {record.goals_b, record.goals_a, &record.counts[1], record.counts.data()};
  }
};

// What a team contributes to its goal difference in a game.
struct PartDefinition {
  std::string name;
  std::function<double(const TeamGame&)> goals;
  bool is_defence = false;  // whether the team contributes it at its own goal
};

// Summed over the ways to gain the ball, whose numbers are rounded in rows, so that the parts add
// up.
double chances_in(const TeamGame& game) {
  double xg = 0;
  for (const game::ChainCounts& chains : game.own->by_start) xg += chains.xg;
  return xg;
}

// What chances come from, in the plural.
std::string_view plural_of(game::ChainStart start) {
  using enum game::ChainStart;
  switch (start) {
    case kKickOff:
      return "kick-offs";
    case kPenalty:
      return "penalties";
    case kFreeKick:
      return "free kicks";
    case kCornerKick:
      return "corner kicks";
    case kGoalKick:
      return "goal kicks";
    case kThrowIn:
      return "throw-ins";
    case kKeeper:
      return "its own defence area";
    case kInterception:
      return "interceptions";
    case kDuel:
      return "duels";
    case kLooseBall:
      return "loose balls";
  }
  throw std::logic_error("unknown start of a chain");
}

std::vector<PartDefinition> definitions_by_start() {
  std::vector<PartDefinition> definitions;
  for (const game::ChainGroup& group : game::chain_groups()) {
    if (!group.start) continue;
    definitions.push_back({fmt::format("chances from {}", plural_of(*group.start)),
                           [&group](const TeamGame& game) { return group.of(*game.own).xg; }});
  }
  return definitions;
}

std::vector<PartDefinition> definitions_by_passes() {
  return {{"chances with a pass", [](const TeamGame& game) { return game.own->with_pass.xg; }},
          {"chances without a pass",
           [](const TeamGame& game) { return chances_in(game) - game.own->with_pass.xg; }}};
}

// Goals of the opponents that did not come from the team's own chains.
int goals_conceded(const TeamGame& game) { return game.goals_against - game.own->own_goals; }

std::vector<PartDefinition> other_definitions() {
  constexpr bool kIsDefence = true;
  return {
      {"finishing", [](const TeamGame& game) { return game.own->xgot - chances_in(game); }},
      {"saves", [](const TeamGame& game) { return game.opponents->xgot - goals_conceded(game); },
       kIsDefence},
      {"own goals", [](const TeamGame& game) { return -static_cast<double>(game.own->own_goals); },
       kIsDefence}};
}

// The contributions of both teams, on average over the legs of a pair.
struct Contributions {
  double own = 0;
  double opponents = 0;
};

Contributions contributions_in(const PartDefinition& part, const std::string& matchup, int pair,
                               const RowsById& rows) {
  constexpr int kLegs = 2;
  Contributions mean;
  for (int leg = 1; leg <= kLegs; ++leg) {
    const game::GameRecord& record = rows.at(game_id(matchup, pair, leg)).record;
    mean.own += part.goals(TeamGame::of_a(record)) / kLegs;
    mean.opponents += part.goals(TeamGame::of_b(record)) / kLegs;
  }
  return mean;
}

DifferencePart part_of(const PartDefinition& definition, const std::vector<PartOpponent>& opponents,
                       const std::vector<int>& pairs, const RowsById& rows) {
  DifferencePart part;
  part.name = definition.name;
  const double share = 1.0 / static_cast<double>(opponents.size());
  const double share_of_pair = share / static_cast<double>(pairs.size());
  std::vector<double> differences;
  for (const int pair : pairs) {
    double difference = 0;
    for (const PartOpponent& opponent : opponents) {
      const Contributions of_new = contributions_in(definition, opponent.of_new, pair, rows);
      part.of_new += share_of_pair * of_new.own;
      if (!opponent.of_old) {
        part.of_old += share_of_pair * of_new.opponents;
        part.each_other += share_of_pair * (of_new.own - of_new.opponents);
        difference += share * (of_new.own - of_new.opponents);
        continue;
      }
      const Contributions of_old = contributions_in(definition, *opponent.of_old, pair, rows);
      part.of_old += share_of_pair * of_old.own;
      const double own = of_new.own - of_old.own;
      const double opponents_less = of_old.opponents - of_new.opponents;
      part.attack += share_of_pair * (definition.is_defence ? opponents_less : own);
      part.defence += share_of_pair * (definition.is_defence ? own : opponents_less);
      difference += share * (own + opponents_less);
    }
    differences.push_back(difference);
  }
  part.mean = part.each_other + part.attack + part.defence;
  part.interval = anytime_interval(differences);
  part.p = part.p_holm = anytime_p(differences);
  return part;
}

}  // namespace

const DifferencePart* DifferenceParts::most_certain() const {
  const DifferencePart* best = nullptr;
  for (const auto* parts : {&by_start, &by_passes, &others}) {
    for (const DifferencePart& part : *parts) {
      if (part.p_holm <= kSignificant && (best == nullptr || part.p < best->p)) best = &part;
    }
  }
  return best;
}

DifferenceParts difference_parts(const std::vector<PartOpponent>& opponents,
                                 const std::vector<int>& pairs, const RowsById& rows) {
  const auto parts_of = [&](const std::vector<PartDefinition>& definitions) {
    std::vector<DifferencePart> parts;
    parts.reserve(definitions.size());
    for (const PartDefinition& definition : definitions)
      parts.push_back(part_of(definition, opponents, pairs, rows));
    return parts;
  };
  DifferenceParts parts;
  parts.by_start = parts_of(definitions_by_start());
  parts.by_passes = parts_of(definitions_by_passes());
  parts.others = parts_of(other_definitions());
  parts.chances = part_of({"chances in all", chances_in}, opponents, pairs, rows);
  const auto goals = [](const TeamGame& game) { return static_cast<double>(game.goals); };
  parts.goals = part_of({"goals", goals}, opponents, pairs, rows);
  std::vector<DifferencePart*> named;
  for (auto* some : {&parts.by_start, &parts.by_passes, &parts.others})
    for (DifferencePart& part : *some) named.push_back(&part);
  std::vector<double> p;
  p.reserve(named.size());
  for (const DifferencePart* part : named) p.push_back(part->p);
  const std::vector<double> corrected = holm(p);
  for (std::size_t i = 0; i < named.size(); ++i) named[i]->p_holm = corrected[i];
  return parts;
}

}  // namespace autoref::experiments
