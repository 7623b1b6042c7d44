#include "league/team/json_output.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <bitset>
#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>

#include "league/team/output_builder.hpp"
#include "league/team/team_fault.hpp"

namespace autoref::league {
namespace {

// `value` without a point or exponent if it is a whole number.
template <typename Number>
std::string_view digits_of(Number value, std::array<char, 32>& buffer) {
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), static_cast<std::size_t>(end - buffer.data())};
}

using nlohmann::json;

enum class JsonType : std::uint8_t { kInteger, kNumber, kYesOrNo, kText, kArray };

std::string_view description_of(JsonType type) {
  static constexpr std::array<std::string_view, 5> kDescriptions = {
      "an integer", "a number", "true or false", "a string", "an array"};
  return kDescriptions.at(static_cast<std::size_t>(type));
}

// The object, or array, whose members are being read.
enum class JsonLevel : std::uint8_t { kOutside, kOutput, kCommands, kCommand };

std::string_view description_of(JsonLevel level) {
  return level == JsonLevel::kCommands || level == JsonLevel::kCommand ? "a command"
                                                                       : "an output line";
}

struct JsonMember {
  std::string_view name;
  JsonLevel level;
  JsonType type;
};

constexpr std::array<JsonMember, 13> kMembers = {
    {{"frame", JsonLevel::kOutput, JsonType::kInteger},
     {"commands", JsonLevel::kOutput, JsonType::kArray},
     {"keeper", JsonLevel::kOutput, JsonType::kInteger},
     {"leaves", JsonLevel::kOutput, JsonType::kInteger},
     {"timeout", JsonLevel::kOutput, JsonType::kYesOrNo},
     {"text", JsonLevel::kOutput, JsonType::kText},
     {"robot", JsonLevel::kCommand, JsonType::kInteger},
     {"vx_mps", JsonLevel::kCommand, JsonType::kNumber},
     {"vy_mps", JsonLevel::kCommand, JsonType::kNumber},
     {"angular_velocity_radps", JsonLevel::kCommand, JsonType::kNumber},
     {"kick_mps", JsonLevel::kCommand, JsonType::kNumber},
     {"chip", JsonLevel::kCommand, JsonType::kYesOrNo},
     {"dribble", JsonLevel::kCommand, JsonType::kYesOrNo}}};

// Fills an output with the values found by the library's parser, in order. The parser calls the
// public functions; they throw TeamFault.
class OutputHandler {
 public:
  explicit OutputHandler(TeamOutput& output) : builder_(output) {}

  bool null() { return check_is_member(); }
  bool boolean(bool value) {
    expect(JsonType::kYesOrNo);
    if (member_->name == "timeout") builder_.set_timeout(value);
    if (member_->name == "chip") command_.chip = value;
    if (member_->name == "dribble") command_.dribble = value;
    return true;
  }
  bool number_integer(std::int64_t value) {
    if (is_expected(JsonType::kNumber)) return set_number(static_cast<double>(value));
    expect(JsonType::kInteger);
    if (member_->name == "frame") builder_.set_frame(frame_.emplace(value));
    if (member_->name == "keeper") builder_.set_keeper(value);
    if (member_->name == "leaves") builder_.set_leaves(value);
    if (member_->name == "robot") robot_ = value;
    return true;
  }
  bool number_unsigned(std::uint64_t value) {
    if (value >> 63U == 0) return number_integer(static_cast<std::int64_t>(value));
    return number_float(static_cast<double>(value), {});
  }
  bool number_float(double value, const std::string& /*text*/) {
    expect(JsonType::kNumber);
    return set_number(value);
  }
  bool string(const std::string& value) {
    expect(JsonType::kText);
    builder_.set_text(value);
    return true;
  }
  static bool binary(const json::binary_t& /*value*/) {
    return false;
  }  // binary values do not occur in JSON

  bool start_object(std::size_t /*size*/) {
    if (level_ != JsonLevel::kOutside && level_ != JsonLevel::kCommands) refuse_value();
    level_ = level_ == JsonLevel::kOutside ? JsonLevel::kOutput : JsonLevel::kCommand;
    if (level_ != JsonLevel::kCommand) return true;
    robot_.reset();
    command_ = {};
    for (std::size_t i = 0; i < kMembers.size(); ++i) {
      if (kMembers[i].level == JsonLevel::kCommand) found_.reset(i);
    }
    return true;
  }
  bool key(const std::string& name) {
    member_ = std::find_if(kMembers.begin(), kMembers.end(), [&](const JsonMember& member) {
      return member.level == level_ && member.name == name;
    });
    if (member_ == kMembers.end()) fail("{} has the unknown member {}", excerpt_of(name));
    const auto index = static_cast<std::size_t>(member_ - kMembers.begin());
    if (found_[index]) fail("{} has two members {}", excerpt_of(name));
    found_.set(index);
    return true;
  }
  bool end_object() {
    if (level_ == JsonLevel::kCommand) {
      if (!robot_) fail("{} does not name a robot");
      builder_.add_command(*robot_, command_);
      level_ = JsonLevel::kCommands;
    } else if (!frame_) {
      fail("{} does not name a frame");
    }
    return true;
  }
  bool start_array(std::size_t /*size*/) {
    expect(JsonType::kArray);
    level_ = JsonLevel::kCommands;
    return true;
  }
  bool end_array() {
    level_ = JsonLevel::kOutput;
    return true;
  }
  bool parse_error(std::size_t /*position*/, const std::string& /*token*/,
                   const json::exception& error) {
    syntax_error_ = explanation_of(error);
    return false;
  }

  // The error if the parser has failed.
  const std::string& syntax_error() const { return syntax_error_; }

 private:
  // The library's explanation, without the error number and without the text that it read.
  static std::string_view explanation_of(const json::exception& error) {
    constexpr std::size_t kLongest = 120;
    std::string_view what = error.what();
    const std::size_t begin = what.find("] ");
    if (begin != std::string_view::npos) what.remove_prefix(begin + 2);
    return what.substr(0, std::min(kLongest, what.find("; last read")));
  }

  // `text` contains {} for the level and for each of `values`.
  template <typename... Values>
  [[noreturn]] void fail(std::string_view text, const Values&... values) const {
    throw TeamFault(fmt::format(fmt::runtime(text), description_of(level_), values...));
  }
  bool is_member() const { return level_ == JsonLevel::kOutput || level_ == JsonLevel::kCommand; }
  bool is_expected(JsonType type) const { return is_member() && member_->type == type; }
  bool check_is_member() const {
    if (!is_member()) fail("{} is not an object");
    return true;
  }
  void expect(JsonType type) const {
    check_is_member();
    if (member_->type != type) refuse_value();
  }
  [[noreturn]] void refuse_value() const {
    throw TeamFault(fmt::format("{} of {} is not {}", member_->name, description_of(level_),
                                description_of(member_->type)));
  }
  bool set_number(double value) {
    if (member_->name == "vx_mps") command_.velocity_mps.x() = value;
    if (member_->name == "vy_mps") command_.velocity_mps.y() = value;
    if (member_->name == "angular_velocity_radps") command_.angular_velocity_radps = value;
    if (member_->name == "kick_mps") command_.kick_mps = value;
    return true;
  }

  OutputBuilder builder_;
  JsonLevel level_ = JsonLevel::kOutside;
  std::array<JsonMember, 13>::const_iterator member_ = kMembers.end();
  std::bitset<kMembers.size()> found_;
  std::optional<std::int64_t> frame_;
  std::optional<std::int64_t> robot_;
  RobotCommand command_;
  std::string syntax_error_;
};

}  // namespace

void JsonText::begin(std::string_view name) {
  if (!is_first_) *text_ += ',';
  is_first_ = false;
  if (name.empty()) return;
  *text_ += '"';
  *text_ += name;
  *text_ += "\":";
}

JsonText& JsonText::open(char bracket, std::string_view name) {
  begin(name);
  *text_ += bracket;
  is_first_ = true;
  return *this;
}

JsonText& JsonText::close(char bracket) {
  *text_ += bracket;
  is_first_ = false;
  return *this;
}

JsonText& JsonText::member(std::string_view name, double value) {
  begin(name);
  std::array<char, 32> buffer{};
  const std::string_view digits = digits_of(value, buffer);
  *text_ += digits;
  if (digits.find_first_of(".e") == std::string_view::npos) *text_ += ".0";
  return *this;
}

JsonText& JsonText::member(std::string_view name, std::int64_t value) {
  begin(name);
  std::array<char, 32> buffer{};
  *text_ += digits_of(value, buffer);
  return *this;
}

JsonText& JsonText::member(std::string_view name, bool value) {
  begin(name);
  *text_ += value ? "true" : "false";
  return *this;
}

JsonText& JsonText::member(std::string_view name, std::string_view value) {
  begin(name);
  *text_ += '"';
  *text_ += value;
  *text_ += '"';
  return *this;
}

JsonText& JsonText::null(std::string_view name) {
  begin(name);
  *text_ += "null";
  return *this;
}

void read_json_output(std::string_view line, TeamOutput& output) {
  OutputHandler handler(output);
  if (json::sax_parse(line, &handler)) return;
  throw TeamFault(fmt::format("an output line is not JSON: {} in {}", handler.syntax_error(),
                              excerpt_of(line)));
}

}  // namespace autoref::league
