// Every third foul of a team is a yellow card, and the third active yellow card a red card (2026
// rules, "Offenses").
#include <algorithm>
#include <array>

#include "judge/truth/ground_truth_rules.hpp"
#include "soccer/units.hpp"

namespace autoref::judge::ground_truth {
namespace {

// The fouls that count towards a card: all except the double touch, the defender in its own area,
// and too many robots ("No penalty will be given", 2026 rules, Yellow Card).
constexpr std::array<std::string_view, 11> kCounted = {"attacker_stays_near_area",
                                                       "bot_pushed_bot",
                                                       "keeper_held_ball",
                                                       "bot_dribbled_ball_too_far",
                                                       "attacker_touched_ball_in_defense_area",
                                                       "bot_kicked_ball_too_fast",
                                                       "bot_crash_unique",
                                                       "bot_crash_drawn",
                                                       "defender_too_close_to_kick_point",
                                                       "bot_too_fast_in_stop",
                                                       "bot_interfered_placement"};
// A card shown this soon after a third foul belongs to that foul.
constexpr double kShownWithin_s = 1_s;

// A missed or wrong call would shift all of the referee's later cards. Therefore each card shown,
// whether due or not, restarts the count: a card is judged only by the fouls since the previous
// one.
class MultipleFouls final : public GroundTruthRule {
 public:
  void watch(const TrueFrame& frame, TrueEvents& all) override {
    for (const Side side : kSides) {
      note_card(frame, side);
      const bool has_cards = frame.signal.yellow_cards[side] + frame.signal.red_cards[side] > 0;
      if (!has_cards) allowed_without_cards_[side] = frame.signal.robots_allowed[side];
    }
    const std::size_t end = all.size();
    for (; next_ < end; ++next_) {
      const TrueEvent event = all[next_];
      if (event.standing != Standing::kTrue || !event.is_counted || !is_counted(event.name))
        continue;
      for (const Side side : kSides) {
        if (event.offender.value_or(side) == side) count(frame, side, all);
      }
    }
    next_ = all.size();
  }

 private:
  static bool is_counted(std::string_view name) {
    return std::find(kCounted.begin(), kCounted.end(), name) != kCounted.end();
  }

  void note_card(const TrueFrame& frame, Side side) {
    const int shown = frame.signal.yellow_cards[side] + frame.signal.red_cards[side];
    const bool is_due = due_s_[side] && !has_passed(frame, *due_s_[side], kShownWithin_s);
    if (!is_due) due_s_[side].reset();
    if (shown > shown_[side]) {
      if (!is_due) fouls_[side] = 0;
      due_s_[side].reset();
    }
    shown_[side] = shown;
  }

  void count(const TrueFrame& frame, Side side, TrueEvents& all) {
    const int due = frame.rules.fouls_per_card;
    if (due == 0 || ++fouls_[side] < due) return;
    fouls_[side] = 0;
    due_s_[side] = frame.time_s;
    const std::string_view card = is_last_straw(frame, side) ? "multiple_cards" : "multiple_fouls";
    all.push_back({card, frame.time_s, side});
  }

  // Whether one more yellow card would be the third active one. Each active card costs the side one
  // robot, as does each red card, so the number of active cards follows from the number of robots
  // allowed.
  bool is_last_straw(const TrueFrame& frame, Side side) const {
    const int lacking = allowed_without_cards_[side] - frame.signal.robots_allowed[side];
    const int active = lacking - frame.signal.red_cards[side];
    return frame.rules.yellows_per_red > 0 && active + 1 >= frame.rules.yellows_per_red;
  }

  std::size_t next_ = 0;  // index of the next event to examine
  PerSide<int> fouls_;    // number of fouls since the previous card
  PerSide<int> shown_;
  PerSide<int> allowed_without_cards_;
  PerSide<std::optional<double>> due_s_;
};

}  // namespace

std::unique_ptr<GroundTruthRule> multiple_fouls() { return std::make_unique<MultipleFouls>(); }

}  // namespace autoref::judge::ground_truth
