#include "league/team/delimited.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "league/team/team_fault.hpp"

namespace autoref::league {
namespace {

void append_varint(std::size_t value, std::string& bytes) {
  constexpr std::size_t kMore = 0x80;
  for (; value >= kMore; value >>= 7U) bytes += static_cast<char>(value | kMore);
  bytes += static_cast<char>(value);
}

std::optional<MessageExtent> extent_of(std::size_t begin, std::size_t size,
                                       std::string_view bytes) {
  if (size > kLongestOutput) {
    throw TeamFault(fmt::format("an output has {} bytes; the limit is {}", size, kLongestOutput));
  }
  if (bytes.size() - begin < size) return std::nullopt;
  return MessageExtent{begin, size, begin + size};
}

}  // namespace

void append_delimited(const google::protobuf::MessageLite& message, std::string& bytes) {
  append_varint(message.ByteSizeLong(), bytes);
  message.AppendToString(&bytes);
}

void append_delimited(std::string_view message, std::string& bytes) {
  append_varint(message.size(), bytes);
  bytes += message;
}

std::optional<MessageExtent> find_delimited(std::string_view bytes) {
  constexpr std::size_t kLongestVarint = 3;  // length of kLongestOutput as a varint
  std::size_t size = 0;
  for (std::size_t i = 0; i < std::min(kLongestVarint, bytes.size()); ++i) {
    const auto byte = static_cast<unsigned char>(bytes[i]);
    size |= static_cast<std::size_t>(byte & 0x7FU) << (7 * i);
    if ((byte & 0x80U) == 0) return extent_of(i + 1, size, bytes);
  }
  if (bytes.size() < kLongestVarint) return std::nullopt;
  throw TeamFault(fmt::format("an output's length is not a number up to {}", kLongestOutput));
}

}  // namespace autoref::league
