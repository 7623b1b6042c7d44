// A search for weaknesses for tests.
#pragma once

#include <string>

namespace autoref::experiments {

// The ball and two attackers anywhere in a square, two defenders at rest.
inline std::string weakness_text(const std::string& more = "searches: 2\niterations: 12\n") {
  return "schema: 1\n"
         "kind: weakness\n"
         "attackers: { one: { strategy: dummy } }\n"
         "defenders: { still: { strategy: dummy } }\n"
         "situations:\n"
         "  field:\n"
         "    ball: { x_m: 0, y_m: [-2, 2] }\n"
         "    attackers: { 1: { x_m: [-2, -1], y_m: -1 }, 2: { x_m: [-2, -1], y_m: 1 } }\n"
         "    defenders: { 0: { x_m: 2, y_m: 0 }, 3: { x_m: 1, y_m: 0 } }\n" +
         more +
         "pairs: 4\n"
         "test: { pairs: 40 }\n"
         "reduction: { pairs: 20, kept: 0.5 }\n"
         "seed: 7\n";
}

}  // namespace autoref::experiments
