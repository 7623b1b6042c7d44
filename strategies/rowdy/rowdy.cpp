#include "strategies/rowdy/rowdy.hpp"

#include <string>

#include "strategies/skills/prediction.hpp"

namespace autoref::strategies::rowdy {
namespace {

// After this time without an opportunity, the next opportunity counts as new and gets a new random
// draw.
constexpr double kBetweenChances_s = 1.0;

double share_of(const FoulBehaviour& kind, const std::map<std::string, double>& params) {
  const auto own = params.find(std::string(kind.name));
  if (own != params.end()) return own->second;
  const auto otherwise = params.find("otherwise");
  return otherwise == params.end() || otherwise->second < 0 ? kind.share : otherwise->second;
}

}  // namespace

Rowdy::Rowdy(const TeamContext& context)
    : context_(context), basic_(context), random_(context.random) {
  const auto kinds = all_kinds();
  for (std::size_t i = 0; i < habits_.size(); ++i) {
    habits_[i].kind = kinds[i];
    habits_[i].share = share_of(*kinds[i], context.params);
  }
}

void Rowdy::decide(const TeamView& view, TeamCommands& commands) {
  basic_.decide(view, commands);
  requests_ = basic_.requests();
  look_ahead(view, now_);
  const RowdyView seen{context_.field, context_.rules, now_, requests_.keeper};
  look_for_chances(seen);
  if (under_way_ != nullptr && !go_on(seen, commands)) under_way_ = nullptr;
}

void Rowdy::look_for_chances(const RowdyView& view) {
  for (Habit& habit : habits_) consider(habit, view);
}

// Draws once per opportunity, however many frames the opportunity lasts. An opportunity during
// another foul behaviour is missed.
void Rowdy::consider(Habit& habit, const RowdyView& view) {
  const std::optional<ActiveFoul> chance = habit.kind->find_chance(view);
  if (!chance) return;
  const bool is_new = now_.time_s - habit.last_chance_s > kBetweenChances_s;
  habit.last_chance_s = now_.time_s;
  if (!is_new || under_way_ != nullptr || random_.uniform() >= habit.share) return;
  under_way_ = habit.kind;
  active_foul_ = *chance;
  active_foul_.amount = random_.uniform();
  active_foul_.begun_s = now_.time_s;
}

// Returns false once the foul behaviour is over; the team then plays normally.
bool Rowdy::go_on(const RowdyView& view, TeamCommands& commands) {
  if (now_.time_s - active_foul_.begun_s > under_way_->longest_s) return false;
  if (active_foul_.robot >= 0 && find(now_.own, active_foul_.robot) == nullptr) return false;
  // Uses copies, which are discarded if the behaviour ends in this frame.
  TeamCommands wanted = commands;
  TeamRequests asked = requests_;
  TeamOutput output{wanted, asked};
  if (!under_way_->go_on(view, active_foul_, output)) return false;
  commands = wanted;
  requests_ = asked;
  return true;
}

}  // namespace autoref::strategies::rowdy
