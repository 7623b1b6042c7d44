#include "tests/referee/rules/script_reader.hpp"

#include <array>
#include <string>

#include "tests/referee/rules/case_words.hpp"

namespace autoref::referee {
namespace {

using Kind = Cue::Kind;

void read_drive(YamlKeys& keys, Cue& cue) {
  cue.robot = robot_of(keys, "drive");
  cue.target = keys.vector("to_m");
  cue.speed = keys.number("speed_mps");
}

void read_turn(YamlKeys& keys, Cue& cue) {
  cue.robot = robot_of(keys, "turn");
  cue.angle_deg = keys.number("facing_deg");
  cue.speed = keys.number("speed_degps");
}

void read_kick(YamlKeys& keys, Cue& cue) {
  cue.robot = robot_of(keys, "kick");
  cue.speed = keys.number("speed_mps");
  cue.angle_deg = keys.number_or("upwards_deg", 0);
}

void read_carry(YamlKeys& keys, Cue& cue) { cue.robot = robot_of(keys, "carry"); }

void read_roll(YamlKeys& keys, Cue& cue) { cue.target = keys.vector("ball_mps"); }

void read_robot_seen(YamlKeys& keys, Cue& cue) {
  cue.robot = robot_of(keys, "robot");
  cue.on = keys.yes_or_no("seen");
}

void read_ball_seen(YamlKeys& keys, Cue& cue) { cue.on = keys.yes_or_no("ball_seen"); }

void read_request(YamlKeys& keys, Cue& cue) {
  cue.robot.side = side_of(keys, "timeout");
  cue.on = keys.yes_or_no("asked");
}

// One key determines the kind of cue; the other keys belong to it.
struct CueWord {
  const char* key;
  Kind kind;
  void (*read)(YamlKeys& keys, Cue& cue);
};

constexpr std::array kCueWords = {
    CueWord{"drive", Kind::kDrive, read_drive},
    CueWord{"turn", Kind::kTurn, read_turn},
    CueWord{"kick", Kind::kKick, read_kick},
    CueWord{"carry", Kind::kCarry, read_carry},
    CueWord{"ball_mps", Kind::kRoll, read_roll},
    CueWord{"robot", Kind::kRobotSeen, read_robot_seen},
    CueWord{"ball_seen", Kind::kBallSeen, read_ball_seen},
    CueWord{"timeout", Kind::kRequest, read_request},
};

Cue read_cue(YamlKeys& keys) {
  Cue cue;
  cue.at_s = keys.number("at_s");
  for (const CueWord& word : kCueWords) {
    if (!keys.has(word.key)) continue;
    cue.kind = word.kind;
    word.read(keys, cue);
    keys.finish();
    return cue;
  }
  keys.refuse("at_s", "the cue has no action");
}

}  // namespace

std::vector<Cue> read_script(YamlKeys& keys) {
  std::vector<Cue> script;
  if (!keys.has("script")) return script;
  for (const YAML::Node& node : keys.child("script")) {
    YamlKeys cue(node, keys.file());
    script.push_back(read_cue(cue));
    if (script.size() > 1 && script.back().at_s < script[script.size() - 2].at_s) {
      cue.refuse("at_s", "earlier than the previous cue");
    }
  }
  return script;
}

}  // namespace autoref::referee
