#include "tests/referee/rules/case_words.hpp"

#include <sstream>

namespace autoref::referee {

Event event_of(YamlKeys& keys, const std::string& key, const std::string& word) {
  for (int i = 0; i < kEventCount; ++i) {
    if (name_of(static_cast<Event>(i)) == word) return static_cast<Event>(i);
  }
  keys.refuse(key, "'" + word + "' is not an event");
}

std::vector<Event> events_of(YamlKeys& keys, const std::string& key) {
  std::vector<Event> events;
  for (const YAML::Node& word : keys.child(key)) {
    events.push_back(event_of(keys, key, word.as<std::string>()));
  }
  if (events.empty()) keys.refuse(key, "expected a list of events");
  return events;
}

Side side_of(YamlKeys& keys, const std::string& key, const std::string& word) {
  return word_in<Side>(keys, key, word, {{"west", Side::kWest}, {"east", Side::kEast}});
}

Side side_of(YamlKeys& keys, const std::string& key) { return side_of(keys, key, keys.text(key)); }

RobotId robot_of(YamlKeys& keys, const std::string& key, const std::string& words) {
  std::istringstream in(words);
  std::string side;
  int number = -1;
  in >> side >> number;
  if (in.fail() || !in.eof()) keys.refuse(key, "expected a side and a number such as 'west 3'");
  if (number < 0 || number >= kMaxRobots) keys.refuse(key, "numbers are 0 to 15");
  return {side_of(keys, key, side), number};
}

RobotId robot_of(YamlKeys& keys, const std::string& key) {
  return robot_of(keys, key, keys.text(key));
}

Command command_of(YamlKeys& keys, const std::string& key) {
  std::istringstream in(keys.text(key));
  std::string kind;
  std::string side = "west";
  in >> kind;
  const CommandKind command =
      word_in<CommandKind>(keys, key, kind,
                           {{"halt", CommandKind::kHalt},
                            {"stop", CommandKind::kStop},
                            {"force_start", CommandKind::kForceStart},
                            {"prepare_kickoff", CommandKind::kPrepareKickoff},
                            {"prepare_penalty", CommandKind::kPreparePenalty},
                            {"direct_free", CommandKind::kDirectFree},
                            {"indirect_free", CommandKind::kIndirectFree}});
  if (is_for_one_side(command) && !(in >> side)) keys.refuse(key, "a side is missing");
  return {command, side_of(keys, key, side)};
}

Card card_of(YamlKeys& keys, const std::string& key) {
  return word_in<Card>(keys, key, keys.text(key),
                       {{"none", Card::kNone}, {"yellow", Card::kYellow}, {"red", Card::kRed}});
}

}  // namespace autoref::referee
