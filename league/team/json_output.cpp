#include "league/team/json_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "league/team/excerpt.hpp"
#include "league/team/output_builder.hpp"
#include "league/team/team_fault.hpp"

namespace autoref::league {
namespace {

using nlohmann::json;

// The members of an object of an output. Throws TeamFault for a value of the wrong type, and for
// members that nobody asked for.
class Members {
 public:
  Members(const json& object, std::string_view where) : object_(&object), where_(where) {
    if (!object.is_object()) fail("is not an object");
  }

  const json* find(const char* name) {
    const auto found = object_->find(name);
    if (found == object_->end()) return nullptr;
    ++known_;
    return found->is_null() ? nullptr : &*found;
  }
  double number(const char* name) {
    const json* value = find(name);
    if (value != nullptr && !value->is_number()) fail(name, "is not a number");
    return value != nullptr ? value->get<double>() : 0;
  }
  std::optional<std::int64_t> integer(const char* name) {
    const json* value = find(name);
    if (value == nullptr) return std::nullopt;
    const bool is_too_large =
        value->is_number_unsigned() && value->get<std::uint64_t>() > std::uint64_t{1} << 62U;
    if (!value->is_number_integer() || is_too_large) fail(name, "is not an integer");
    return value->get<std::int64_t>();
  }
  bool yes_or_no(const char* name) {
    const json* value = find(name);
    if (value != nullptr && !value->is_boolean()) fail(name, "is not true or false");
    return value != nullptr && value->get<bool>();
  }
  void refuse_others(std::initializer_list<std::string_view> names) const {
    if (known_ == object_->size()) return;
    for (const auto& member : object_->items()) {
      if (std::find(names.begin(), names.end(), member.key()) == names.end())
        fail(fmt::format("has the unknown member {}", excerpt_of(member.key())));
    }
  }
  [[noreturn]] void fail(std::string_view what) const {
    throw TeamFault(fmt::format("{} {}", where_, what));
  }
  [[noreturn]] void fail(std::string_view name, std::string_view what) const {
    throw TeamFault(fmt::format("{} of {} {}", name, where_, what));
  }

 private:
  const json* object_;
  std::string_view where_;
  std::size_t known_ = 0;
};

void add_json_command(const json& value, OutputBuilder& builder) {
  Members members(value, "a command");
  const std::optional<std::int64_t> robot = members.integer("robot");
  if (!robot) members.fail("names no robot");
  RobotCommand command;
  command.velocity_mps = {members.number("vx_mps"), members.number("vy_mps")};
  command.angular_velocity_radps = members.number("angular_velocity_radps");
  command.kick_mps = members.number("kick_mps");
  command.chip = members.yes_or_no("chip");
  command.dribble = members.yes_or_no("dribble");
  members.refuse_others(
      {"robot", "vx_mps", "vy_mps", "angular_velocity_radps", "kick_mps", "chip", "dribble"});
  builder.add_command(*robot, command);
}

// Refuses objects with two members of one name, and deep nesting.
class ShapeCheck {
 public:
  bool operator()(int depth, json::parse_event_t event, const json& parsed) {
    constexpr int kDeepest = 3;
    if (depth > kDeepest) throw TeamFault("an output line is nested too deeply");
    if (event == json::parse_event_t::object_start) names_.emplace_back();
    if (event == json::parse_event_t::object_end) names_.pop_back();
    if (event == json::parse_event_t::key && !names_.back().insert(parsed).second) {
      throw TeamFault(fmt::format("an output line has two members {} in one object",
                                  excerpt_of(parsed.get_ref<const std::string&>())));
    }
    return true;
  }

 private:
  std::vector<std::set<std::string>> names_;
};

// What the library says, without its number and without the text that it read.
std::string_view explanation_of(const json::exception& error) {
  constexpr std::size_t kLongest = 120;
  std::string_view what = error.what();
  const std::size_t begin = what.find("] ");
  if (begin != std::string_view::npos) what.remove_prefix(begin + 2);
  return what.substr(0, std::min(kLongest, what.find("; last read")));
}

json parsed_line(std::string_view line) {
  ShapeCheck check;
  try {
    return json::parse(line, std::ref(check));
  } catch (const json::exception& error) {
    throw TeamFault(fmt::format("an output line is not JSON: {} in {}", explanation_of(error),
                                excerpt_of(line)));
  }
}

}  // namespace

void read_json_output(std::string_view line, TeamOutput& output) {
  const json value = parsed_line(line);
  Members members(value, "an output line");
  OutputBuilder builder(output);
  const std::optional<std::int64_t> frame = members.integer("frame");
  if (!frame) members.fail("names no frame");
  builder.set_frame(*frame);
  if (const auto keeper = members.integer("keeper")) builder.set_keeper(*keeper);
  if (const auto leaves = members.integer("leaves")) builder.set_leaves(*leaves);
  builder.set_timeout(members.yes_or_no("timeout"));
  if (const json* text = members.find("text")) {
    if (!text->is_string()) members.fail("text", "is not a string");
    builder.set_text(text->get_ref<const std::string&>());
  }
  if (const json* commands = members.find("commands")) {
    if (!commands->is_array()) members.fail("commands", "is not an array");
    for (const json& command : *commands) add_json_command(command, builder);
  }
  members.refuse_others({"frame", "keeper", "leaves", "timeout", "text", "commands"});
}

}  // namespace autoref::league
