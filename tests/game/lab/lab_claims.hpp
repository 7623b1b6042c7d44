// Claims about the simulated world that the scenes in scenarios/lab show, with numbers from
// independent sources.
#pragma once

#include <string>
#include <vector>

#include "game/lab/lab.hpp"

namespace autoref::game {

struct Claim {
  std::string name;  // name of the test
  std::string what;
  std::string scene;
  double claimed = 0;
  double tolerance = 0;
  std::string unit;
  std::string source;
  double (*measure)(const LabRecord& record) = nullptr;
};

const std::vector<Claim>& lab_claims();

std::string lab_file(const std::string& scene);
// Measures the claim in the default world, or in a world with this many sub-steps per frame.
double measured(const Claim& claim);
double measured_with(const Claim& claim, int substeps);

// The table in sim/README.md: claims, measurements and sources.
std::string lab_table();

}  // namespace autoref::game
