#include "experiments/report/bracket_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "view/page.hpp"

namespace autoref::experiments {
namespace {

constexpr std::size_t kHeadLines = 1;  // number of grid lines above the ties
constexpr std::size_t kMostTies = 32;  // maximum number of ties in the first round shown

bool has_tie_at(const BracketPlace& place, const CupBracket& bracket) {
  return std::any_of(bracket.ties.begin(), bracket.ties.end(),
                     [&place](const TieResult& tie) { return tie.place == place; });
}

std::string team_html(const TieTeam& team) {
  const char* const kind = team.has_won ? " has-won" : team.is_known ? "" : " is-open";
  const char* const tag = team.has_won ? "strong" : "span";
  return fmt::format("<p class=\"tie-team{0}\"><{1}>{2}</{1}><{1}>{3}</{1}></p>", kind, tag,
                     view::html_text(team.name), view::html_text(team.goals));
}

// CSS classes for the lines to the ties before and after this one.
std::string lines_of(const BracketPlace& place, const CupBracket& bracket) {
  const auto& [ties_in_round, position] = place;
  const bool is_fed = has_tie_at({2 * ties_in_round, 2 * position}, bracket) ||
                      has_tie_at({2 * ties_in_round, 2 * position + 1}, bracket);
  const char* const onward = ties_in_round == 1  ? ""
                             : position % 2 == 0 ? " leads-down"
                                                 : " leads-up";
  return std::string(is_fed ? " is-fed" : "") + onward;
}

std::string tie_html(const TieResult& tie, const std::string& classes, const std::string& area) {
  std::string text = fmt::format(
      "<div class=\"tie{}\" style=\"grid-area:{}\"><div><p class=\"tie-name\">{}</p>{}{}", classes,
      area, view::html_text(tie.name), team_html(tie.teams[0]), team_html(tie.teams[1]));
  if (!tie.decision.empty() && !tie.is_usual)
    text += fmt::format("<p class=\"tie-name\">{}</p>", view::html_text(tie.decision));
  return text + "</div></div>\n";
}

std::string placed_tie_html(const TieResult& tie, std::size_t column, std::size_t lines,
                            const CupBracket& bracket) {
  const std::size_t span = lines / tie.place->ties_in_round;
  return tie_html(
      tie, lines_of(*tie.place, bracket),
      fmt::format("{}/{}/span {}", kHeadLines + 1 + tie.place->position * span, column, span));
}

}  // namespace

std::vector<std::size_t> rounds_of(const CupBracket& bracket) {
  std::vector<std::size_t> rounds;
  for (const TieResult& tie : bracket.ties) {
    if (!tie.place || tie.place->ties_in_round > kMostTies) continue;
    if (rounds.empty() || rounds.back() != tie.place->ties_in_round)
      rounds.push_back(tie.place->ties_in_round);
  }
  return rounds;
}

std::string bracket_html(const CupBracket& bracket) {
  const std::vector<std::size_t> rounds = rounds_of(bracket);
  const std::size_t lines = rounds.front();
  std::string text =
      fmt::format("<div class=\"wide\"><div class=\"bracket\" style=\"--rounds:{};--lines:{}\">\n",
                  rounds.size(), lines);
  for (std::size_t column = 1; column <= rounds.size(); ++column) {
    text += fmt::format("<p class=\"round-name\" style=\"grid-area:1/{}\">{}</p>\n", column,
                        name_of_round(rounds[column - 1]));
    for (const TieResult& tie : bracket.ties) {
      if (tie.place && tie.place->ties_in_round == rounds[column - 1])
        text += placed_tie_html(tie, column, lines, bracket);
    }
  }
  for (const TieResult& tie : bracket.ties) {
    if (!tie.place)
      text +=
          tie_html(tie, " is-apart", fmt::format("{}/{}", kHeadLines + 1 + lines, rounds.size()));
  }
  return text + "</div></div>\n";
}

}  // namespace autoref::experiments
