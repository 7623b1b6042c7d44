#include "strategies/registry.hpp"

#include "strategies/basic/basic.hpp"
#include "strategies/rowdy/rowdy.hpp"
#include "strategies/teams/chaser.hpp"
#include "strategies/teams/dummy.hpp"
#include "strategies/teams/playbooks.hpp"

namespace autoref::strategies {
namespace {

std::unique_ptr<Strategy> make_basic(const TeamContext& context) {
  return std::make_unique<basic::Basic>(context);
}

template <TeamPlaybook (*playbook)()>
std::unique_ptr<Strategy> make_squad(const TeamContext& context) {
  return std::make_unique<Squad>(context, playbook());
}

std::unique_ptr<Strategy> make_chaser(const TeamContext& context) {
  return std::make_unique<Chaser>(context);
}

std::unique_ptr<Strategy> make_dummy(const TeamContext& /*context*/) {
  return std::make_unique<Dummy>();
}

std::unique_ptr<Strategy> make_rowdy(const TeamContext& context) {
  return std::make_unique<rowdy::Rowdy>(context);
}

// The parameters of `basic`, and one parameter per foul behaviour: the fraction of opportunities
// taken.
std::vector<Tunable> rowdy_params() {
  std::vector<Tunable> params = tunables_of(basic::Style{});
  params.push_back({{"otherwise",
                     {-1, 1},
                     "Fraction of opportunities taken, for fouls without their own setting; below "
                     "0: their defaults."},
                    -1});
  for (const rowdy::FoulBehaviour* kind : rowdy::all_kinds()) {
    params.push_back(
        {{kind->name, kFraction, "Fraction of its opportunities that are taken."}, kind->share});
  }
  return params;
}

}  // namespace

const std::vector<Entry>& all_strategies() {
  static const std::vector<Entry> kEntries = {
      {"basic",
       "Keeper, wall, markers, a supporter and an attacker that shoots at the open side of the "
       "goal.",
       make_basic, tunables_of(basic::Style{})},
      {"chaser",
       "The simple baseline: one robot chases the ball and kicks at the goal, the others stand.",
       make_chaser,
       {}},
      {"cobalt",
       "Takes the clearest shot, or else the most valuable pass, dribble or clearance, and covers "
       "its goal with wall and keeper together.",
       make_squad<cobalt_playbook>, tunables_of(cobalt_playbook().style)},
      {"cobalt1", "The previous version of cobalt, kept for comparison.",
       make_squad<cobalt1_playbook>, tunables_of(cobalt1_playbook().style)},
      {"counter",
       "Defends in a deep block behind the ball and plays long balls to one or two forwards.",
       make_squad<counter_playbook>, tunables_of(counter_playbook().style)},
      {"dummy", "Does nothing: its robots stand where they are.", make_dummy, {}},
      {"possession", "Keeps the ball with short, safe passes and waits for a clear chance.",
       make_squad<possession_playbook>, tunables_of(possession_playbook().style)},
      {"rowdy",
       "Plays like basic, but breaks rules on purpose now and then, to evaluate a referee.",
       make_rowdy, rowdy_params()},
      {"shadow", "Marks man to man all over the field; each robot follows its own opponent.",
       make_squad<shadow_playbook>, tunables_of(shadow_playbook().style)},
      {"zone",
       "A fixed formation that shifts with the ball; only the fastest robot leaves it for the "
       "ball.",
       make_squad<zone_playbook>, tunables_of(zone_playbook().style)},
  };
  return kEntries;
}

const std::vector<std::string_view>& teams_by_strength() {
  static const std::vector<std::string_view> kTeams = {"cobalt", "counter", "shadow", "possession",
                                                       "zone",   "basic",   "chaser", "dummy"};
  return kTeams;
}

const Entry* find_strategy(std::string_view name) {
  for (const Entry& entry : all_strategies()) {
    if (entry.name == name) return &entry;
  }
  return nullptr;
}

}  // namespace autoref::strategies
