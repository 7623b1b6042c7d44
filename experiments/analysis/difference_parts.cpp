#include "experiments/analysis/difference_parts.hpp"

#include <fmt/format.h>

#include "experiments/statistics/anytime_interval.hpp"
#include "experiments/statistics/paired_difference.hpp"
#include "game/play_counts/play_counts.hpp"

namespace autoref::experiments {
namespace {

// What a team contributes to its goal difference in a game.
struct PartDefinition {
  std::string name;
  TeamNumber goals;
  bool is_defence = false;  // whether the team contributes it at its own goal
};

// Summed over the ways to gain the ball, whose numbers are rounded in rows, so that the parts add
// up.
double chances_in(const TeamGame& game) {
  double xg = 0;
  for (const game::ChainCounts& chains : game.own->by_start) xg += chains.xg;
  return xg;
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

DifferencePart part_of(const PartDefinition& definition,
                       const std::vector<PairedOpponent>& opponents, const std::vector<int>& pairs,
                       const RowsById& rows) {
  DifferencePart part;
  part.name = definition.name;
  const double share = 1.0 / static_cast<double>(opponents.size());
  const double share_of_pair = share / static_cast<double>(pairs.size());
  std::vector<double> differences;
  for (const int pair : pairs) {
    double difference = 0;
    for (const PairedOpponent& opponent : opponents) {
      const TeamNumbers of_new = mean_over_legs(definition.goals, opponent.of_new, pair, rows);
      part.of_new += share_of_pair * of_new.of_a;
      if (!opponent.of_old) {
        part.of_old += share_of_pair * of_new.of_b;
        part.each_other += share_of_pair * (of_new.of_a - of_new.of_b);
        difference += share * (of_new.of_a - of_new.of_b);
        continue;
      }
      const TeamNumbers of_old = mean_over_legs(definition.goals, *opponent.of_old, pair, rows);
      part.of_old += share_of_pair * of_old.of_a;
      const double own = of_new.of_a - of_old.of_a;
      const double opponents_less = of_old.of_b - of_new.of_b;
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

const DifferencePart* DifferenceParts::strongest_candidate() const {
  const DifferencePart* best = nullptr;
  for (const auto* parts : {&by_start, &by_passes, &others}) {
    for (const DifferencePart& part : *parts) {
      if (best == nullptr || part.p < best->p) best = &part;
    }
  }
  return best;
}

const DifferencePart* DifferenceParts::most_certain() const {
  const DifferencePart* part = strongest_candidate();
  return part != nullptr && part->p_holm <= kSignificant ? part : nullptr;
}

DifferenceParts difference_parts(const std::vector<PairedOpponent>& opponents,
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
