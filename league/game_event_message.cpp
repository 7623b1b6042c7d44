#include "league/game_event_message.hpp"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include "league/message_fields.hpp"

namespace autoref::league {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::Reflection;

constexpr std::size_t kLongestText = 1000;
constexpr int kMostEvents = 100;
constexpr int kUnknownTeam = 0;

std::string mapped(std::string_view text, int (*map)(int)) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [map](unsigned char c) { return static_cast<char>(map(c)); });
  return result;
}

// The part of the message that belongs to the type; null if there is none. Parts have the types'
// names in lower case.
const FieldDescriptor* part_of(GameEventType type) {
  const std::string_view name = name_of(type);
  if (name.empty()) return nullptr;
  return GameEventMessage::descriptor()->FindFieldByName(mapped(name, std::tolower));
}

// Writes the members of an event to the fields of the same names.
class FieldWriter {
 public:
  explicit FieldWriter(Message& message)
      : message_(message), reflection_(*message.GetReflection()) {}

  template <typename T>
  void operator()(const char* name, const std::optional<T>& value) const {
    const FieldDescriptor* field = message_.GetDescriptor()->FindFieldByName(name);
    if (field != nullptr && value) set(field, *value);
  }
  void operator()(const char* name, const std::string& text) const {
    const FieldDescriptor* field = message_.GetDescriptor()->FindFieldByName(name);
    if (field != nullptr && !text.empty()) reflection_.SetString(&message_, field, text);
  }

  void complete() const {
    for (int i = 0; i < message_.GetDescriptor()->field_count(); ++i) {
      const FieldDescriptor* field = message_.GetDescriptor()->field(i);
      if (field->is_required() && !reflection_.HasField(message_, field)) set_nothing(field);
    }
  }

 private:
  void set(const FieldDescriptor* field, Side side) const {
    reflection_.SetInt32(&message_, field, side == Side::kWest ? kYellowTeam : kBlueTeam);
  }
  void set(const FieldDescriptor* field, int number) const {
    if (field->cpp_type() == FieldDescriptor::CPPTYPE_INT32) {
      reflection_.SetInt32(&message_, field, number);
    } else {
      reflection_.SetUInt32(&message_, field, static_cast<std::uint32_t>(std::max(0, number)));
    }
  }
  void set(const FieldDescriptor* field, const Vec2& position_m) const {
    auto& location = static_cast<Location&>(*reflection_.MutableMessage(&message_, field));
    location.set_x(static_cast<float>(position_m.x()));
    location.set_y(static_cast<float>(position_m.y()));
  }
  void set(const FieldDescriptor* field, double number) const {
    reflection_.SetFloat(&message_, field, static_cast<float>(number));
  }
  void set(const FieldDescriptor* field, bool is_true) const {
    reflection_.SetBool(&message_, field, is_true);
  }
  void set(const FieldDescriptor* field, std::uint64_t number) const {
    reflection_.SetUInt64(&message_, field, number);
  }

  // All required fields are teams, bools or texts.
  void set_nothing(const FieldDescriptor* field) const {
    if (field->cpp_type() == FieldDescriptor::CPPTYPE_INT32)
      reflection_.SetInt32(&message_, field, kUnknownTeam);
    if (field->cpp_type() == FieldDescriptor::CPPTYPE_BOOL)
      reflection_.SetBool(&message_, field, false);
    if (field->cpp_type() == FieldDescriptor::CPPTYPE_STRING)
      reflection_.SetString(&message_, field, "");
  }

  Message& message_;
  const Reflection& reflection_;
};

std::string bounded_text(const std::string& text) {
  return text.size() <= kLongestText ? text : std::string();
}

// Reads the members of an event from the fields of the same names.
class FieldReader {
 public:
  explicit FieldReader(const Message& message)
      : message_(message), reflection_(*message.GetReflection()) {}

  template <typename T>
  void operator()(const char* name, T& value) const {
    const FieldDescriptor* field = message_.GetDescriptor()->FindFieldByName(name);
    if (field != nullptr && reflection_.HasField(message_, field)) read(field, value);
  }

 private:
  void read(const FieldDescriptor* field, std::optional<Side>& side) const {
    const int team = reflection_.GetInt32(message_, field);
    if (team == kYellowTeam) side = Side::kWest;
    if (team == kBlueTeam) side = Side::kEast;
  }
  void read(const FieldDescriptor* field, std::optional<int>& number) const {
    const bool is_signed = field->cpp_type() == FieldDescriptor::CPPTYPE_INT32;
    const std::int64_t value = is_signed ? std::int64_t{reflection_.GetInt32(message_, field)}
                                         : std::int64_t{reflection_.GetUInt32(message_, field)};
    if (value <= std::numeric_limits<int>::max()) number = static_cast<int>(value);
  }
  void read(const FieldDescriptor* field, std::optional<Vec2>& position_m) const {
    const auto& location = static_cast<const Location&>(reflection_.GetMessage(message_, field));
    const Vec2 found_m(static_cast<double>(location.x()), static_cast<double>(location.y()));
    if (is_finite(found_m)) position_m = found_m;
  }
  void read(const FieldDescriptor* field, std::optional<double>& number) const {
    const auto value = static_cast<double>(reflection_.GetFloat(message_, field));
    if (std::isfinite(value)) number = value;
  }
  void read(const FieldDescriptor* field, std::optional<bool>& is_true) const {
    is_true = reflection_.GetBool(message_, field);
  }
  void read(const FieldDescriptor* field, std::optional<std::uint64_t>& number) const {
    number = reflection_.GetUInt64(message_, field);
  }
  void read(const FieldDescriptor* field, std::string& text) const {
    text = bounded_text(reflection_.GetString(message_, field));
  }

  const Message& message_;
  const Reflection& reflection_;
};

}  // namespace

void fill_game_event(const GameEvent& event, GameEventMessage& message) {
  message.Clear();
  message.set_type(static_cast<std::int32_t>(event.type));
  for (const std::string& origin : event.origin) message.add_origin(origin);
  if (event.created_us) message.set_created_timestamp(*event.created_us);
  if (!event.id.empty()) message.set_id(event.id);
  const FieldDescriptor* part = part_of(event.type);
  if (part == nullptr) return;
  const FieldWriter writer(*message.GetReflection()->MutableMessage(&message, part));
  visit_fields(event, writer);
  writer.complete();
}

GameEvent game_event_of(const GameEventMessage& message) {
  GameEvent event;
  event.type = static_cast<GameEventType>(message.type());
  for (const std::string& origin : message.origin()) {
    if (event.origin.size() < kMostEvents) event.origin.push_back(bounded_text(origin));
  }
  if (message.has_created_timestamp()) event.created_us = message.created_timestamp();
  event.id = bounded_text(message.id());
  const FieldDescriptor* part = message.GetReflection()->GetOneofFieldDescriptor(
      message, GameEventMessage::descriptor()->FindOneofByName("event"));
  if (part == nullptr) return event;
  event.type = game_event_type(mapped(part->name(), std::toupper)).value_or(event.type);
  visit_fields(event, FieldReader(message.GetReflection()->GetMessage(message, part)));
  return event;
}

bool add_game_event(const GameEvent& event, RefereePacket& packet) {
  GameEventMessage message;
  fill_game_event(event, message);
  message.SerializeToString(packet.add_game_events());
  if (packet.ByteSizeLong() < kLongestPacket) return true;
  packet.mutable_game_events()->RemoveLast();
  return false;
}

std::vector<GameEvent> game_events_of(const RefereePacket& packet) {
  std::vector<GameEvent> events;
  GameEventMessage message;
  for (const std::string& bytes : packet.game_events()) {
    if (events.size() == kMostEvents) break;
    if (!message.ParsePartialFromString(bytes) || !message.IsInitialized()) continue;
    events.push_back(game_event_of(message));
  }
  return events;
}

}  // namespace autoref::league
