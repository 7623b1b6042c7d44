#include "experiments/kinds/swiss/swiss_rounds.hpp"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/max_cardinality_matching.hpp>
#include <functional>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "experiments/analysis/standings.hpp"
#include "experiments/results/game_row.hpp"
#include "experiments/schedule/matchup_schedule.hpp"
#include "soccer/random.hpp"

namespace autoref::experiments {
namespace {

using NotMet = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>;

// The least number of rematches if all of these teams are paired. The teams left over by a maximum
// matching have all met each other, so every two of them give one rematch.
std::size_t fewest_rematches(const std::vector<DrawnTeam>& teams, const Encounters& past) {
  NotMet graph(teams.size());
  for (std::size_t i = 0; i < teams.size(); ++i) {
    for (std::size_t j = i + 1; j < teams.size(); ++j)
      if (!past.have_met(teams[i], teams[j])) boost::add_edge(i, j, graph);
  }
  std::vector<NotMet::vertex_descriptor> mates(teams.size());
  boost::edmonds_maximum_cardinality_matching(graph, mates.data());
  return teams.size() / 2 - boost::matching_size(graph, mates.data());
}

std::vector<DrawnTeam> without(std::vector<DrawnTeam> teams, std::size_t position) {
  teams.erase(teams.begin() + static_cast<std::ptrdiff_t>(position));
  return teams;
}

// Moves two teams from `left` to the meetings: the first one and the next one that it can play.
// `rematches` is the least number of rematches among the teams in `left`; it is updated.
void pair_first(std::vector<DrawnTeam>& left, std::size_t& rematches, RoundPairing& pairing,
                const Encounters& past) {
  for (std::size_t i = 1; i < left.size(); ++i) {
    const std::size_t its = past.have_met(left[0], left[i]) ? 1 : 0;
    if (its > rematches) continue;
    std::vector<DrawnTeam> rest = without(without(left, i), 0);
    const std::size_t of_rest = fewest_rematches(rest, past);
    if (its + of_rest > rematches) continue;
    pairing.meetings.emplace_back(left[0], left[i]);
    left = std::move(rest);
    rematches = of_rest;
    return;
  }
  throw std::logic_error("the teams of a round cannot be paired");
}

// The position in the ranking of the team that gets the bye.
std::size_t position_of_bye(const std::vector<DrawnTeam>& ranking, const Encounters& past) {
  std::optional<std::size_t> best;
  std::size_t fewest = 0;
  for (std::size_t i = ranking.size(); i-- > 0;) {
    if (past.had_bye(ranking[i])) continue;
    const std::size_t rematches = fewest_rematches(without(ranking, i), past);
    if (best && rematches >= fewest) continue;
    best = i;
    fewest = rematches;
    if (fewest == 0) break;
  }
  if (!best) throw std::logic_error("all teams have had a bye");
  return *best;
}

constexpr int kLegsOfPair = 2;

// The part of a game's outcome on which the next rounds depend.
struct GameOutcome {
  bool is_void = false;
  double lead = 0;     // lead of team a; 0 for a draw
  int difference = 0;  // goals of a minus goals of b
};

// Nullopt if the game has not been played.
using OutcomeOf = std::function<std::optional<GameOutcome>(const std::string& id)>;

struct SwissScore {
  int points = 0;
  int difference = 0;
  int games = 0;

  void add(int its_points, int its_difference) {
    points += its_points;
    difference += its_difference;
    ++games;
  }
  double mean_difference() const {
    return games == 0 ? 0 : static_cast<double>(difference) / games;
  }
};

std::pair<int, int> points_for(double lead) {
  if (lead > 0) return {kPointsOfWin, 0};
  if (lead < 0) return {0, kPointsOfWin};
  return {1, 1};
}

int pair_number(const Swiss& swiss, std::size_t round, int pair) {
  return static_cast<int>(round) * swiss.pairs + pair;
}

class SwissTournament {
 public:
  SwissTournament(const Swiss& swiss, const OutcomeOf& outcome_of)
      : swiss_(swiss),
        outcome_of_(outcome_of),
        draw_(draw_of(swiss)),
        past_(draw_.size()),
        scores_(draw_.size()) {
    played_.points_of_bye = kPointsOfWin * games_per_meeting(swiss);
  }

  SwissRounds played() {
    bool is_complete = true;
    while (is_complete && played_.rounds.size() < static_cast<std::size_t>(swiss_.rounds))
      is_complete = play(played_.rounds.empty() ? first_pairing(draw_.size())
                                                : next_pairing(ranking(), past_));
    for (const DrawnTeam team : ranking()) played_.ranking.push_back(draw_[team]);
    return std::move(played_);
  }

 private:
  std::vector<DrawnTeam> ranking() const {
    std::vector<DrawnTeam> teams;
    for (DrawnTeam team = 0; team < draw_.size(); ++team) teams.push_back(team);
    const auto key = [this](DrawnTeam team) {
      return std::tuple(-scores_[team].points, -scores_[team].mean_difference(), team);
    };
    std::sort(teams.begin(), teams.end(),
              [&key](DrawnTeam one, DrawnTeam other) { return key(one) < key(other); });
    return teams;
  }

  // Returns whether all games of the round have been played.
  bool play(const RoundPairing& pairing) {
    SwissRound round;
    if (pairing.bye) {
      round.bye = draw_[*pairing.bye];
      ++played_.byes[*round.bye];
      scores_[*pairing.bye].points += played_.points_of_bye;
      past_.add_bye(*pairing.bye);
    }
    bool is_complete = true;
    for (const auto& [one, other] : pairing.meetings) {
      const bool is_ordered = draw_[one] < draw_[other];
      round.meetings.push_back(is_ordered ? meeting(one, other) : meeting(other, one));
      past_.add_meeting(one, other);
      const Meeting& last = round.meetings.back();
      is_complete = is_complete && last.games + last.void_games == games_per_meeting(swiss_);
    }
    played_.rounds.push_back(std::move(round));
    return is_complete;
  }

  Meeting meeting(DrawnTeam a, DrawnTeam b) {
    Meeting meeting{{draw_[a], draw_[b]}};
    const std::string name = matchup_name(meeting.teams);
    for (int pair = 1; pair <= swiss_.pairs; ++pair) {
      for (int leg = 1; leg <= kLegsOfPair; ++leg) {
        const int number = pair_number(swiss_, played_.rounds.size(), pair);
        const std::optional<GameOutcome> outcome = outcome_of_(game_id(name, number, leg));
        if (outcome) count(*outcome, meeting, scores_[a], scores_[b]);
      }
    }
    return meeting;
  }

  static void count(const GameOutcome& outcome, Meeting& meeting, SwissScore& a, SwissScore& b) {
    if (outcome.is_void) {
      ++meeting.void_games;
      return;
    }
    ++meeting.games;
    const auto [of_a, of_b] = points_for(outcome.lead);
    meeting.points_a += of_a;
    meeting.points_b += of_b;
    a.add(of_a, outcome.difference);
    b.add(of_b, -outcome.difference);
  }

  const Swiss& swiss_;
  const OutcomeOf& outcome_of_;
  const std::vector<std::string> draw_;
  Encounters past_;
  std::vector<SwissScore> scores_;  // scores by the team's number in the draw
  SwissRounds played_;
};

}  // namespace

RoundPairing first_pairing(std::size_t teams) {
  RoundPairing pairing;
  const std::size_t half = teams / 2;
  for (DrawnTeam team = 0; team < half; ++team) pairing.meetings.emplace_back(team, half + team);
  if (teams % 2 == 1) pairing.bye = teams - 1;
  return pairing;
}

RoundPairing next_pairing(const std::vector<DrawnTeam>& ranking, const Encounters& past) {
  RoundPairing pairing;
  std::vector<DrawnTeam> left = ranking;
  if (left.size() % 2 == 1) {
    const std::size_t position = position_of_bye(ranking, past);
    pairing.bye = ranking[position];
    left = without(std::move(left), position);
  }
  std::size_t rematches = fewest_rematches(left, past);
  while (!left.empty()) pair_first(left, rematches, pairing, past);
  return pairing;
}

int games_per_meeting(const Swiss& swiss) { return kLegsOfPair * swiss.pairs; }

std::vector<std::string> draw_of(const Swiss& swiss) {
  std::vector<std::string> names;
  for (const auto& [name, team] : swiss.teams) names.push_back(name);
  RandomStream random(swiss.seed);
  // Fisher-Yates shuffle.
  for (std::size_t left = names.size(); left > 1; --left) {
    const auto drawn = static_cast<std::size_t>(random.uniform() * static_cast<double>(left));
    std::swap(names[left - 1], names[drawn]);
  }
  return names;
}

SwissRounds rounds_of(const Swiss& swiss, const RowsById& rows) {
  const OutcomeOf outcome_of = [&rows](const std::string& id) -> std::optional<GameOutcome> {
    const auto row = rows.find(id);
    if (row == rows.end()) return std::nullopt;
    const game::GameRecord& record = row->second.record;
    if (is_void(record)) return GameOutcome{.is_void = true};
    return GameOutcome{false, lead_of_a(record), record.goals_a - record.goals_b};
  };
  return SwissTournament(swiss, outcome_of).played();
}

SwissRounds rounds_if_drawn(const Swiss& swiss) {
  const OutcomeOf drawn = [](const std::string&) { return GameOutcome{}; };
  return SwissTournament(swiss, drawn).played();
}

std::vector<ScheduledGame> games_of(const Swiss& swiss, const SwissRounds& played) {
  const MatchupScheduler scheduler(swiss);
  std::vector<ScheduledGame> games;
  for (std::size_t round = 0; round < played.rounds.size(); ++round) {
    const std::vector<Meeting>& meetings = played.rounds[round].meetings;
    for (int pair = 1; pair <= swiss.pairs; ++pair) {
      for (std::size_t i = 0; i < meetings.size(); ++i) {
        for (int leg = 1; leg <= kLegsOfPair; ++leg) {
          games.push_back(scheduler.game(meetings[i].teams, pair_number(swiss, round, pair), leg));
          games.back().unit = (games.size() - 1) / kLegsOfPair;
          games.back().variant = round * meetings.size() + i;
          games.back().variants = meetings.size();
        }
      }
    }
  }
  return games;
}

}  // namespace autoref::experiments
