#include "tests/logs/mutated_message.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <string>

namespace autoref::logs {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::Reflection;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Positions in m and mm, times in s, and what no packet should contain.
constexpr std::array kNumbers = {std::numeric_limits<double>::quiet_NaN(),
                                 kInfinity,
                                 -kInfinity,
                                 0.0,
                                 -0.001,
                                 1.0,
                                 3.5,
                                 -2000.0,
                                 4500.0,
                                 1e5,
                                 -1e5,
                                 1e12,
                                 3e38,
                                 1e-38};
// Robots, commands, stages, lengths in mm, times in us.
constexpr std::array<std::int64_t, 18> kWholeNumbers = {0,
                                                        1,
                                                        2,
                                                        3,
                                                        5,
                                                        8,
                                                        9,
                                                        13,
                                                        15,
                                                        16,
                                                        255,
                                                        9000,
                                                        12000,
                                                        -1,
                                                        std::numeric_limits<std::int32_t>::max(),
                                                        std::numeric_limits<std::int32_t>::min(),
                                                        std::numeric_limits<std::int64_t>::max(),
                                                        std::numeric_limits<std::int64_t>::min()};

std::size_t index_below(std::size_t count, RandomStream& chance) {
  return static_cast<std::size_t>(chance.uniform() * static_cast<double>(count));
}

template <typename List>
auto any_of(const List& list, RandomStream& chance) {
  return list[index_below(list.size(), chance)];
}

std::string any_text(RandomStream& chance) {
  const std::array<std::string, 4> texts = {"", std::string("\xff\xfe\0\n\"", 5), "a",
                                            std::string(3000, 'x')};
  return any_of(texts, chance);
}

void set_value(Message& message, const FieldDescriptor& field, RandomStream& chance) {
  const Reflection& access = *message.GetReflection();
  const std::int64_t whole = any_of(kWholeNumbers, chance);
  const double number = any_of(kNumbers, chance);
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_INT32:
      return access.SetInt32(&message, &field, static_cast<std::int32_t>(whole));
    case FieldDescriptor::CPPTYPE_UINT32:
      return access.SetUInt32(&message, &field, static_cast<std::uint32_t>(whole));
    case FieldDescriptor::CPPTYPE_INT64:
      return access.SetInt64(&message, &field, whole);
    case FieldDescriptor::CPPTYPE_UINT64:
      return access.SetUInt64(&message, &field, static_cast<std::uint64_t>(whole));
    case FieldDescriptor::CPPTYPE_FLOAT:
      return access.SetFloat(&message, &field, static_cast<float>(number));
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return access.SetDouble(&message, &field, number);
    case FieldDescriptor::CPPTYPE_BOOL:
      return access.SetBool(&message, &field, whole % 2 == 0);
    case FieldDescriptor::CPPTYPE_STRING:
      return access.SetString(&message, &field, any_text(chance));
    default:
      return access.ClearField(&message, &field);
  }
}

void mutate_list(Message& message, const FieldDescriptor& field, RandomStream& chance) {
  const Reflection& access = *message.GetReflection();
  const int size = access.FieldSize(message, &field);
  const bool is_of_messages = field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE;
  if (size == 0) return;
  if (chance.uniform() < 0.1) return access.RemoveLast(&message, &field);
  if (!is_of_messages) return access.ClearField(&message, &field);
  const auto index = static_cast<int>(index_below(static_cast<std::size_t>(size), chance));
  if (chance.uniform() < 0.1) {
    access.AddMessage(&message, &field)
        ->CopyFrom(access.GetRepeatedMessage(message, &field, index));
    return;
  }
  mutate(*access.MutableRepeatedMessage(&message, &field, index), chance);
}

}  // namespace

void mutate(Message& message, RandomStream& chance) {
  const auto& type = *message.GetDescriptor();
  const Reflection& access = *message.GetReflection();
  const FieldDescriptor& field = *type.field(
      static_cast<int>(index_below(static_cast<std::size_t>(type.field_count()), chance)));
  if (field.is_repeated()) return mutate_list(message, field, chance);
  if (chance.uniform() < 0.05) return access.ClearField(&message, &field);
  if (field.cpp_type() != FieldDescriptor::CPPTYPE_MESSAGE)
    return set_value(message, field, chance);
  // A part that is missing stays so most of the time, since it would be incomplete.
  if (access.HasField(message, &field) || chance.uniform() < 0.1)
    mutate(*access.MutableMessage(&message, &field), chance);
}

}  // namespace autoref::logs
