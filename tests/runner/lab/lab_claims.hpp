// What the scenes of scenarios/lab claim about the simulated world, as numbers of others.
#pragma once

#include <string>
#include <vector>

#include "runner/lab/lab.hpp"

namespace autoref::runner {

struct Claim {
  std::string name;  // the test's
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
// In the default world, and in one that takes as many sub-steps in every frame.
double measured(const Claim& claim);
double measured_with(const Claim& claim, int substeps);

// The table in sim/README.md: what is claimed, what the scenes show, whose number it is.
std::string lab_table();

}  // namespace autoref::runner
