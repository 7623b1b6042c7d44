// Situations for tests.
#pragma once

#include <string>

#include "experiments/kinds/scenario_reader.hpp"
#include "experiments/kinds/situations/situations.hpp"

namespace autoref::experiments {

// In one situation, a ball rolls into the empty goal from 1 m; in the other, a ball lies in front
// of an idle robot. Both teams stand still.
inline const std::string kSmallSituations =
    "schema: 1\n"
    "kind: situations\n"
    "attackers: { one: { strategy: dummy }, two: { strategy: dummy } }\n"
    "defenders: { still: { strategy: dummy } }\n"
    "lasts_s: 2\n"
    "situations:\n"
    "  goal:\n"
    "    ball: { x_m: 2, y_m: [-0.1, 0.1], vx_mps: 3 }\n"
    "    attackers: { 0: { x_m: -2, y_m: 0 }, 3: { x_m: 1, y_m: [0.5, 1] } }\n"
    "    defenders: { 1: { x_m: 2, y_m: { mean: -1, sd: 0.2 } } }\n"
    "  rest:\n"
    "    ball: { x_m: 0, y_m: 0 }\n"
    "    attackers: { 0: { x_m: -1, y_m: 0 } }\n"
    "pairs: 2\n"
    "seed: 7\n";

inline Scenario small_situations() { return read_scenario_text(kSmallSituations, "x.yaml"); }

inline Situations situations_in(const Scenario& scenario) { return *scenario.as<Situations>(); }

}  // namespace autoref::experiments
