// The reference page of scenario files: the keys of each kind.
#include <fmt/format.h>

#include "app/description/reference_pages.hpp"
#include "experiments/kinds/all_kinds.hpp"
#include "experiments/kinds/scenario.hpp"

namespace autoref::app {
namespace {

constexpr const char* kAboutFiles =
    "Each kind of scenario, with all of its keys. Every file also has `schema: 1`, its `kind`, and "
    "may have `about`, one sentence that reports show. The keys of `teams`, `match`, `field`, "
    "`sim` and `base` are [settings](settings.md); [scenarios](../scenarios.md) and "
    "[experiments](../experiments.md) explain and show them. Robot types and scenes of the lab "
    "have [files of their own](other-files.md).\n\n";

const std::vector<experiments::KeyRow> kGameRows = {
    {"`types`", "robot types by name", "what `type` may name, instead of a file"},
    {"`teams`", "`a` and `b`", "the two teams"},
    {"`match`", "settings", "rule book, halves, who commands"},
    {"`field`", "settings", "sizes of the field"},
    {"`sim`", "settings", "world, robots, cameras"},
    {"`seed`", "whole number; 42", "random seed of the game"}};

std::string section(const std::string& title, std::string_view about,
                    const std::vector<experiments::KeyRow>& keys) {
  std::vector<std::vector<std::string>> rows = {{"name", "value", "meaning"}};
  for (const experiments::KeyRow& key : keys) rows.push_back({key.names, key.value, key.about});
  return fmt::format("## {}\n\n{}{}{}", title, about, about.empty() ? "" : "\n\n",
                     reference_table(rows));
}

// A link to a section of this page, whose anchor has no colon.
std::string link_to(const std::string& title) {
  std::string anchor;
  for (const char c : title) {
    if (c != ':') anchor += c == ' ' ? '-' : c;
  }
  return fmt::format("see [below](#{})", anchor);
}

std::string sections_of(const experiments::Kind& kind) {
  const std::unique_ptr<experiments::Experiment> experiment = kind.make();
  std::vector<experiments::KeyRow> rows;
  std::string below;
  for (const experiments::Key& key : experiment->keys()) {
    if (!key.below) {
      rows.push_back({code_span(key.name), key.value, key.about});
      continue;
    }
    const experiments::KeysBelow inner = key.below();
    const std::string title = fmt::format("{}: {}", kind.name, inner.title);
    rows.push_back({code_span(key.name), link_to(title), key.about});
    below += section(title, inner.about, inner.rows);
  }
  return section(std::string(kind.name), kind.about, rows) + below;
}

}  // namespace

std::string scenario_files_page() {
  std::string page =
      reference_head("Keys of scenario files", "scenario-files") + kAboutFiles +
      section(std::string(experiments::kGameKind), "One game, for `play` and `live`.", kGameRows);
  for (const experiments::Kind* kind : experiments::kinds_of_experiments())
    page += sections_of(*kind);
  page.pop_back();
  return page;
}

}  // namespace autoref::app
