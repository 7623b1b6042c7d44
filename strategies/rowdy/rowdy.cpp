#include "strategies/rowdy/rowdy.hpp"

#include <string>

#include "strategies/skills/outlook.hpp"

namespace autoref::strategies::rowdy {
namespace {

// An opportunity is a new one, and the dice are thrown again, when there was none for so long.
constexpr double kBetweenChances_s = 1.0;

double share_of(const Mischief& kind, const std::map<std::string, double>& params) {
  const auto own = params.find(std::string(kind.name));
  if (own != params.end()) return own->second;
  const auto otherwise = params.find("otherwise");
  return otherwise == params.end() || otherwise->second < 0 ? kind.share : otherwise->second;
}

}  // namespace

Rowdy::Rowdy(const Briefing& briefing)
    : briefing_(briefing), basic_(briefing), random_(briefing.random) {
  const auto kinds = all_kinds();
  for (std::size_t i = 0; i < habits_.size(); ++i) {
    habits_[i].kind = kinds[i];
    habits_[i].share = share_of(*kinds[i], briefing.params);
  }
}

void Rowdy::decide(const TeamView& view, TeamOrders& orders) {
  basic_.decide(view, orders);
  requests_ = basic_.requests();
  look_ahead(view, now_);
  const Scene scene{briefing_.field, briefing_.rules, now_, requests_.keeper};
  look_for_chances(scene);
  if (under_way_ != nullptr && !go_on(scene, orders)) under_way_ = nullptr;
}

void Rowdy::look_for_chances(const Scene& scene) {
  for (Habit& habit : habits_) consider(habit, scene);
}

// A chance that comes while another mischief is under way is missed.
void Rowdy::consider(Habit& habit, const Scene& scene) {
  const std::optional<Deed> chance = habit.kind->find_chance(scene);
  if (!chance) return;
  const bool is_new = now_.time_s - habit.last_chance_s > kBetweenChances_s;
  habit.last_chance_s = now_.time_s;
  if (!is_new || under_way_ != nullptr || random_.uniform() >= habit.share) return;
  under_way_ = habit.kind;
  deed_ = *chance;
  deed_.amount = random_.uniform();
  deed_.begun_s = now_.time_s;
}

// False once the mischief is over, done or given up; then the team does as it should.
bool Rowdy::go_on(const Scene& scene, TeamOrders& orders) {
  if (now_.time_s - deed_.begun_s > under_way_->longest_s) return false;
  if (deed_.robot >= 0 && find(now_.own, deed_.robot) == nullptr) return false;
  TeamOrders wanted = orders;
  TeamRequests asked = requests_;
  Will will{wanted, asked};
  if (!under_way_->go_on(scene, deed_, will)) return false;
  orders = wanted;
  requests_ = asked;
  return true;
}

}  // namespace autoref::strategies::rowdy
