#include "referee/referee.hpp"

#include <fmt/format.h>
#include <cassert>
#include <stdexcept>
#include <utility>
#include <vector>

#include "referee/machine/ball_in_play.hpp"
#include "referee/machine/confidence.hpp"
#include "referee/machine/guards.hpp"
#include "referee/person/beside_person.hpp"
#include "referee/person/official.hpp"
#include "referee/referee_input.hpp"
#include "referee/rules/rule.hpp"
#include "referee/touch/sight.hpp"
#include "soccer/parameters.hpp"

namespace autoref::referee {
namespace {

constexpr Range kFieldLengths = positive(1000);

void validate(const Configuration& configuration) {
  check_ranges<Match>(configuration);
  // A real field can have any size, and its walls can be close to its lines.
  const Field& field = configuration.field;
  check_number("field.length_m", field.length_m, kFieldLengths);
  check_number("field.width_m", field.width_m, kFieldLengths);
  check_number("field.goal_width_m", field.goal_width_m, kFieldLengths);
}

void check_stage(Stage stage, const Configuration& configuration) {
  const std::optional<int> half = half_in(stage);
  if (!half) {
    throw std::invalid_argument(fmt::format(
        "a game cannot begin in the stage {}, after its last half", autoref::name_of(stage)));
  }
  if (*half >= kFirstExtraHalf && !configuration.knockout) {
    throw std::invalid_argument(
        fmt::format("a game that begins in the stage {} needs extra time; set match.knockout=true",
                    autoref::name_of(stage)));
  }
  if (*half < kFirstExtraHalf && *half >= configuration.halves) {
    throw std::invalid_argument(
        fmt::format("a game that begins in the stage {} needs {} halves, but it has {}; set "
                    "match.halves={}",
                    autoref::name_of(stage), *half + 1, configuration.halves, *half + 1));
  }
}

std::unique_ptr<Official> make_official(const Configuration& configuration) {
  if (configuration.control == Control::kAutoref) return std::make_unique<Official>(configuration);
  return std::make_unique<BesidePerson>(configuration);
}

}  // namespace

class Referee::Impl {
 public:
  explicit Impl(const Configuration& configuration)
      : configuration_(configuration.control == Control::kAutoref
                           ? configuration
                           : without_administration(configuration)),
        sight_(configuration_, configuration_.control != Control::kAutoref),
        official_(make_official(configuration_)) {
    validate(configuration);
    decisions_.reserve(4);
  }

  void begin(const MidwayStart& midway_start) {
    assert(!sight_.has_begun() && configuration_.control == Control::kAutoref);
    if (midway_start.signal) check_stage(midway_start.signal->stage, configuration_);
    official_->state().midway_start = midway_start;
  }

  View see(const Frame& frame) {
    const bool is_afresh = sight_.add(frame, is_play(state().machine_state));
    if (is_afresh) official_->forget(sight_.frame());
    return {sight_.frame(), is_afresh};
  }

  const RefereeSignal& judge(const Tracks& tracks, const PerSide<TeamRequests>& requests) {
    requests_ = requests;
    decisions_.clear();
    sight_.complete(tracks);
    if (is_play(state().machine_state)) follow_ball();
    decide_if(official_->find_before_rules(input()));
    const LastTouch last_touch = evaluate_last_touch();
    judge_frame(input_with(last_touch, sight_.frame()));
    if (pending_) follow(*std::exchange(pending_, std::nullopt));
    return state().signal;
  }

  void follow(const RefereeSignal& given) {
    official_->state().signal.blue_on_positive_half = given.blue_on_positive_half;
    if (sight_.has_begun()) {
      decide_if(official_->follow(given, input()));
    } else {
      pending_ = given;
    }
  }

  std::span<const Decision> decisions() const { return decisions_; }
  const RefereeState& state() const { return std::as_const(*official_).state(); }
  const Sight& sight() const { return sight_; }

 private:
  RefereeInput input() const { return input_with(sight_.last_touch(), sight_.frame()); }

  RefereeInput input_with(const LastTouch& last_touch, const Frame& frame) const {
    return {configuration_,  frame,     sight_.ball(),   last_touch,
            sight_.tracks(), requests_, sight_.history()};
  }

  // Follows the ball and its touches while play is on.
  void follow_ball() {
    // Somebody has put a ball back on the field after the referee called it out of the field.
    if (official_->is_exit_called() && sight_.ball() && !is_ball_out(input())) {
      official_->note_return();
      sight_.rejoin_play();
    }
    PlayState& play = official_->state().play;
    if (const Frame* joined = sight_.frame_to_join()) {
      play = play_joined(input_with(sight_.last_touch(), *joined));
      sight_.join_play();
      return;
    }
    sight_.follow_ball();
    // The order of touches is as reported by the online detector; the retrospective detector does
    // not change it.
    watch_play(play, input());
  }

  // Once the ball is out, the whole path since the touch is known.
  LastTouch evaluate_last_touch() const {
    const bool has_left = state().machine_state == State::kRun && !official_->is_exit_called() &&
                          is_ball_out(input());
    return has_left ? sight_.last_touch_in_hindsight() : sight_.last_touch();
  }

  void judge_frame(const RefereeInput& input) {
    const State before = state().machine_state;
    const std::uint32_t sent = state().signal.command_counter;
    apply_rules(input);
    // The machine's own events wait for the next frame if a rule has just changed its state or sent
    // a command.
    if (state().machine_state == before && state().signal.command_counter == sent)
      decide_if(official_->find(input), input);
    decide_if(official_->find_time_over(input), input);
    official_->show_time(input);
  }

  // Counted fouls do not change the machine's state, so later rules still run.
  void apply_rules(const RefereeInput& input) {
    const bool is_shootout = state().signal.stage == Stage::kShootout;
    for (const ListedRule& listed : rules()) {
      if (is_shootout && !entry_of(listed.id).in_shootout) continue;
      if (configuration_.rules.has(listed.id) && !evaluate(*listed.rule, input)) return;
    }
    if (is_shootout) evaluate(kShootoutRule, input);
  }

  // Returns whether the machine's state has stayed the same.
  bool evaluate(const Rule& rule, const RefereeInput& input) {
    const State before = state().machine_state;
    for (const RuleSearch& search : rule.searches()) {
      if (!search.active_in.has(before)) continue;
      decide_if(search.find(official_->state(), input), input);
      if (state().machine_state != before) return false;
    }
    return true;
  }

  void decide_if(const std::optional<Finding>& found) {
    if (found) decide(input(), *found);
  }
  void decide_if(const std::optional<Finding>& found, const RefereeInput& input) {
    if (found) decide(input, *found);
  }

  void decide(const RefereeInput& input, const Finding& found) {
    Finding finding = found;
    add_confidence(finding, state(), input);
    if (found.is_foul && finding.confidence < configuration_.least_confidence) return;
    std::optional<Step> taken = official_->next(input, finding);
    if (!taken) return;
    decisions_.push_back(decision_of(state(), input, finding, *taken));
    const RefereeState& after = taken->state;
    const bool play_starts =
        after.machine_state == State::kRun &&
        (!is_play(state().machine_state) || after.play.began_s != state().play.began_s);
    // A game may also begin with a restart.
    const bool is_joining =
        state().machine_state == State::kInit && (!state().midway_start || after.play.in_play);
    official_->enter(input, finding, *std::move(taken));
    // A play that is joined midway did not begin with the ball at rest.
    if (play_starts)
      sight_.begin_play(input.frame, is_joining ? std::nullopt : state().play.ball_from_m);
  }

  Configuration configuration_;
  PerSide<TeamRequests> requests_;
  Sight sight_;
  std::unique_ptr<Official> official_;
  std::optional<RefereeSignal> pending_;  // the signal given before the first frame
  std::vector<Decision> decisions_;
};

Referee::Referee(const Configuration& configuration)
    : impl_(std::make_unique<Impl>(configuration)) {}
Referee::~Referee() = default;
Referee::Referee(Referee&&) noexcept = default;
Referee& Referee::operator=(Referee&&) noexcept = default;

Referee::View Referee::see(const Frame& frame) { return impl_->see(frame); }

const RefereeSignal& Referee::judge(const Tracks& tracks, const PerSide<TeamRequests>& requests) {
  return impl_->judge(tracks, requests);
}

void Referee::begin(const MidwayStart& midway_start) { impl_->begin(midway_start); }
void Referee::follow(const RefereeSignal& given) { impl_->follow(given); }

std::span<const Decision> Referee::decisions() const { return impl_->decisions(); }
const Frame& Referee::frame() const { return impl_->sight().frame(); }
const LastTouch& Referee::last_touch() const { return impl_->sight().last_touch(); }
State Referee::state() const { return impl_->state().machine_state; }
bool Referee::is_ball_in_play() const {
  return impl_->state().machine_state == State::kRun && impl_->state().play.in_play;
}
bool Referee::is_over() const { return impl_->state().machine_state == State::kOver; }
std::span<const PerSide<int>> Referee::goals_by_half() const {
  const auto& goals = impl_->state().goals_by_half;
  return {goals.data(), goals.size()};
}
std::optional<PerSide<int>> Referee::shootout_goals() const {
  const ShootoutBook& book = impl_->state().shootout;
  return book.kicks == PerSide<int>{} ? std::nullopt : std::optional(book.goals);
}
int Referee::games_finished() const { return impl_->state().games_finished; }

}  // namespace autoref::referee
