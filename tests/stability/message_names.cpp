// The messages of teams' programs.
#include <fmt/format.h>
#include <google/protobuf/descriptor.h>
#include <yaml-cpp/yaml.h>

#include <regex>
#include <sstream>

#include "league/messages/league_input.pb.h"
#include "league/team/team_codec.hpp"
#include "tests/checkout.hpp"
#include "tests/stability/promised_names.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::stability {
namespace {

// "league LeagueInput.frame = 5 int64"
void add_league(Names& names) {
  const google::protobuf::Descriptor& message = *team::LeagueInput::descriptor();
  for (int i = 0; i < message.field_count(); ++i) {
    const google::protobuf::FieldDescriptor& field = *message.field(i);
    names.push_back(fmt::format("league {}.{} = {} {}", message.name(), field.name(),
                                field.number(), field.type_name()));
  }
}

// "flat 2: 8 i64 frame": a number of the second table of docs/team-programs.md. Another test
// compares the tables with the records.
void add_flat(Names& names) {
  const std::regex row(R"(\| (\d+) \| (\w+) \| `(\w+)` \|.*)");
  std::istringstream page(content_of(in_checkout("docs/team-programs.md")));
  int table = 0;
  for (std::string line; std::getline(page, line);) {
    std::smatch cells;
    if (line.starts_with("| offset |")) ++table;
    if (table > 0 && std::regex_match(line, cells, row))
      names.push_back(
          fmt::format("flat {}: {} {} {}", table, cells[1].str(), cells[2].str(), cells[3].str()));
  }
}

// "play HALT = 0": a number in flat records, and the word in JSON.
template <typename Enumeration>
void add_values(const char* field, Names& names) {
  for (const Named<Enumeration>& value : names_of(Enumeration{}))
    names.push_back(fmt::format("{} {} = {}", field, value.name, static_cast<int>(value.value)));
}

void add_members(const YAML::Node& node, const std::string& path, Names& names) {
  if (node.IsSequence() && node.size() > 0) add_members(node[0], path + "[]", names);
  if (!node.IsMap()) return;
  for (const auto& member : node) {
    const std::string name = path + "." + member.first.as<std::string>();
    names.push_back(name);
    add_members(member.second, name, names);
  }
}

// "json .frame.ball.x_m"
void add_json(Names& names) {
  league::TeamStart start;
  start.robots.resize(1);
  league::TeamFrame frame;
  frame.view.own.push_back({});
  frame.view.opponents.push_back({});
  const auto codec = league::make_team_codec(league::TeamEncoding::kJson);
  std::string lines;
  codec->append(start, lines);
  codec->append(frame, lines);
  codec->append(league::TeamEnd{"time", 1, 0}, lines);
  std::istringstream text(lines);
  for (std::string line; std::getline(text, line);) add_members(YAML::Load(line), "json ", names);
}

}  // namespace

Names message_names() {
  Names names;
  add_league(names);
  add_flat(names);
  add_values<Play>("play", names);
  add_values<CommandKind>("next", names);
  add_json(names);
  return names;
}

}  // namespace autoref::stability
