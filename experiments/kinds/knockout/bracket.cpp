#include "experiments/kinds/knockout/bracket.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "experiments/results/game_row.hpp"
#include "experiments/schedule/matchup_schedule.hpp"
#include "experiments/schedule/schedule.hpp"

namespace autoref::experiments {
namespace {

using Seed = std::size_t;  // 0 is the best seed

// A position in the bracket, filled by a first-round team or by the winner of an earlier tie.
struct Slot {
  bool is_empty = false;     // the opponent gets a bye
  std::optional<Seed> seed;  // nullopt until it is known
};

struct Pairing {
  Slot a;
  Slot b;
};

// Standard seeding: the seeds in the order of the first round's slots, such as 0, 3, 1, 2 for four.
std::vector<Seed> order_of_slots(std::size_t size) {
  std::vector<Seed> order = {0};
  while (order.size() < size) {
    // Each doubling adds the preceding round: it puts next to every seed the opponent whose number
    // and that of the seed add up to `last`. These two seeds play each other if the better seeds
    // win all earlier ties.
    const std::size_t last = 2 * order.size() - 1;
    std::vector<Seed> longer;
    for (const Seed seed : order) {
      longer.push_back(seed);
      longer.push_back(last - seed);
    }
    order = std::move(longer);
  }
  return order;
}

std::vector<Slot> first_slots(std::size_t teams) {
  std::size_t size = 1;
  while (size < teams) size *= 2;
  std::vector<Slot> slots;
  for (const Seed seed : order_of_slots(size)) {
    slots.push_back(seed < teams ? Slot{false, seed} : Slot{true, std::nullopt});
  }
  return slots;
}

std::string name_of_tie(std::size_t slots, std::size_t number) {
  if (slots == 2) return "final";
  if (slots == 4) return fmt::format("semi-final {}", number);
  if (slots == 8) return fmt::format("quarter-final {}", number);
  return fmt::format("round of {}, tie {}", slots, number);
}

class Bracket {
 public:
  Bracket(const Knockout& knockout, const std::function<void(Tie&)>& decide)
      : knockout_(knockout), decide_(decide) {}

  std::vector<Tie> ties() {
    std::vector<Slot> slots = first_slots(knockout_.order.size());
    while (slots.size() > 1) slots = next_round(slots);
    if (knockout_.third_place) play({losers_.at(0), losers_.at(1)}, "third place", {});
    return std::move(ties_);
  }

 private:
  std::vector<Slot> next_round(const std::vector<Slot>& slots) {
    std::vector<Slot> winners;
    std::vector<Slot> losers;
    for (std::size_t i = 0; i < slots.size(); i += 2) {
      if (slots[i + 1].is_empty) {
        winners.push_back(slots[i]);
        continue;
      }
      const auto [winner, loser] =
          play({slots[i], slots[i + 1]}, name_of_tie(slots.size(), losers.size() + 1),
               BracketPlace{slots.size() / 2, i / 2});
      winners.push_back(winner);
      losers.push_back(loser);
    }
    if (slots.size() == 4) losers_ = losers;
    return winners;
  }

  // Returns the winner's and the loser's slot.
  std::pair<Slot, Slot> play(Pairing pairing, std::string name, std::optional<BracketPlace> place) {
    Tie& tie = ties_.emplace_back();
    tie.number = static_cast<int>(ties_.size());
    tie.name = std::move(name);
    tie.place = place;
    auto [a, b] = pairing;
    if (a.seed && b.seed && *b.seed < *a.seed) std::swap(a, b);
    if (a.seed) tie.a = knockout_.order[*a.seed];
    if (b.seed) tie.b = knockout_.order[*b.seed];
    if (tie.is_known()) decide_(tie);
    if (!tie.is_decided()) return {};
    return tie.a_won ? std::pair(a, b) : std::pair(b, a);
  }

  const Knockout& knockout_;
  const std::function<void(Tie&)>& decide_;
  std::vector<Tie> ties_;
  std::vector<Slot> losers_;  // losers of the semi-finals
};

// The transition into extra time (referee/machine/).
constexpr std::string_view kExtraTime = "extra_time";

DecidedBy reason_of(const game::GameRecord& record) {
  if (record.status == game::Status::kForfeit) return DecidedBy::kForfeit;
  if (record.shootout) return DecidedBy::kShootout;
  const auto& taken = record.transitions;
  const bool had_extra_time = std::find(taken.begin(), taken.end(), kExtraTime) != taken.end();
  return had_extra_time ? DecidedBy::kExtraTime : DecidedBy::kGoals;
}

// Goes through the tie's games until one decides it or has not been played.
void decide(Tie& tie, const RowsById& rows) {
  for (int attempt = 1; attempt <= kMostAttempts; ++attempt) {
    const std::string id = game_id(matchup_name({*tie.a, *tie.b}), tie.number, attempt);
    const auto row = rows.find(id);
    if (row == rows.end()) return;
    tie.games.push_back(id);
    if (is_void(row->second.record)) {
      ++tie.void_games;
      continue;
    }
    const double lead = lead_of_a(row->second.record);
    if (lead == 0) continue;
    tie.decided_by = reason_of(row->second.record);
    tie.a_won = lead > 0;
    return;
  }
  tie.decided_by = DecidedBy::kSeed;
  tie.a_won = true;
}

}  // namespace

std::string name_of(DecidedBy decided_by) {
  switch (decided_by) {
    case DecidedBy::kGoals:
      return "goals";
    case DecidedBy::kExtraTime:
      return "extra time";
    case DecidedBy::kShootout:
      return "shoot-out";
    case DecidedBy::kForfeit:
      return "forfeit";
    case DecidedBy::kSeed:
      return "better seed";
    case DecidedBy::kNothing:
      break;
  }
  return "";
}

std::vector<Tie> bracket_of(const Knockout& knockout, const std::function<void(Tie&)>& decide) {
  return Bracket(knockout, decide).ties();
}

std::vector<Tie> bracket_of(const Knockout& knockout, const RowsById& rows) {
  return bracket_of(knockout, [&rows](Tie& tie) { decide(tie, rows); });
}

std::vector<ScheduledGame> games_of(const Knockout& knockout, const std::vector<Tie>& ties) {
  const MatchupScheduler scheduler(knockout);
  std::vector<ScheduledGame> games;
  for (const Tie& tie : ties) {
    if (!tie.is_known()) continue;
    const auto played = static_cast<int>(tie.games.size());
    const int attempts = tie.is_decided() ? played : played + 1;
    for (int attempt = 1; attempt <= attempts; ++attempt) {
      games.push_back(scheduler.game({*tie.a, *tie.b}, tie.number, attempt));
      games.back().unit = static_cast<std::size_t>(tie.number - 1);
    }
  }
  return games;
}

}  // namespace autoref::experiments
