// Reads the teams of a round robin. For scenario.cpp.
#pragma once

#include <string>

#include "runner/roundrobin.hpp"
#include "runner/settings_reader.hpp"
#include "runner/yaml.hpp"

namespace autoref::runner {

class RoundRobinReader {
 public:
  // Both must outlive the reader; the places of the teams' settings go into `places`.
  RoundRobinReader(const YamlFile& file, Places& places) : file_(file), places_(places) {}

  // Adds the teams to `robin`, whose base has been read, and the types they name to its base.
  // Throws InputError.
  void read(const YamlEntry& teams, RoundRobin& robin) const;

 private:
  void read_team(const YamlEntry& entry, RoundRobin& robin) const;

  const YamlFile& file_;
  Places& places_;
};

}  // namespace autoref::runner
