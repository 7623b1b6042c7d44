#include "experiments/schedule/named_teams.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace autoref::experiments {
namespace {

bool is_letter_of_names(char c) {
  const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  return is_letter || (c >= '0' && c <= '9') || c == '-' || c == '_';
}

}  // namespace

std::string matchup_name(const Matchup& matchup) { return matchup.team_a + "~" + matchup.team_b; }

void check_team_name(std::string_view name) {
  const bool is_word = !name.empty() && std::all_of(name.begin(), name.end(), is_letter_of_names);
  if (is_word && name.find("-p") == std::string_view::npos) return;
  throw std::invalid_argument(
      fmt::format("a team's name must consist of letters, digits, - and _, without '-p', which "
                  "marks the pair in a game's id (write _p); found '{}'",
                  name));
}

}  // namespace autoref::experiments
