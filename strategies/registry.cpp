#include "strategies/registry.hpp"

#include "strategies/basic/basic.hpp"
#include "strategies/dummy.hpp"
#include "strategies/rowdy/rowdy.hpp"

namespace autoref::strategies {
namespace {

std::unique_ptr<Strategy> make_basic(const Briefing& briefing) {
  return std::make_unique<basic::Basic>(briefing);
}

std::unique_ptr<Strategy> make_dummy(const Briefing& /*briefing*/) {
  return std::make_unique<Dummy>();
}

std::unique_ptr<Strategy> make_rowdy(const Briefing& briefing) {
  return std::make_unique<rowdy::Rowdy>(briefing);
}

// basic's, and the share of each kind of mischief.
std::vector<std::string_view> rowdy_params() {
  std::vector<std::string_view> names = {"shot_mps", "pass_mps", "otherwise"};
  for (const rowdy::Mischief* kind : rowdy::all_kinds()) names.push_back(kind->name);
  return names;
}

}  // namespace

const std::vector<Entry>& all_strategies() {
  static const std::vector<Entry> kEntries = {
      {"basic",
       "Keeper, wall, markers, a supporter and an attacker who shoots at the open side.",
       make_basic,
       {"shot_mps", "pass_mps"}},
      {"dummy", "Does nothing: its robots stand where they are.", make_dummy, {}},
      {"rowdy", "Plays like basic and breaks rules on purpose now and then, to measure a referee.",
       make_rowdy, rowdy_params()},
  };
  return kEntries;
}

const Entry* find_strategy(std::string_view name) {
  for (const Entry& entry : all_strategies()) {
    if (entry.name == name) return &entry;
  }
  return nullptr;
}

}  // namespace autoref::strategies
