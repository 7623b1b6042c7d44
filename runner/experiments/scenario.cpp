#include "runner/experiments/scenario.hpp"

namespace autoref::runner {

// In the order of the variant's types, as is kVerbs below.
const std::vector<std::string>& kinds() {
  static const std::vector<std::string> kKinds = {
      "game", "sweep", "judge", "roundrobin", "sprt", "gauntlet", "knockout", "situations", "tune"};
  return kKinds;
}

std::string_view kind_of(const Scenario& scenario) { return kinds()[scenario.content.index()]; }

std::string_view verb_of(const Scenario& scenario) {
  static const std::vector<std::string> kVerbs = {"play", "run", "judge", "run", "run",
                                                  "run",  "run", "run",   "tune"};
  return kVerbs[scenario.content.index()];
}

}  // namespace autoref::runner
