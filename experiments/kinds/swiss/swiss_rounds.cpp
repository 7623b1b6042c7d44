#include "experiments/kinds/swiss/swiss_rounds.hpp"

#include <algorithm>
#include <functional>
#include <tuple>
#include <utility>

#include "experiments/analysis/standings.hpp"
#include "experiments/kinds/swiss/pairing.hpp"
#include "experiments/results/scores.hpp"
#include "experiments/schedule/matchup_schedule.hpp"
#include "soccer/random.hpp"

namespace autoref::experiments {
namespace {

constexpr int kLegsOfPair = 2;

// How a game ended, as far as the next rounds depend on it.
struct GameOutcome {
  bool is_void = false;
  double lead = 0;     // of team a; 0 for a draw
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
  std::vector<SwissScore> scores_;  // by number in the draw
  SwissRounds played_;
};

}  // namespace

int games_per_meeting(const Swiss& swiss) { return kLegsOfPair * swiss.pairs; }

std::vector<std::string> draw_of(const Swiss& swiss) {
  std::vector<std::string> names;
  for (const auto& [name, team] : swiss.teams) names.push_back(name);
  RandomStream random(swiss.seed);
  // Fisher and Yates.
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
