// Messages that are preceded by their length in bytes as a varint.
#pragma once

#include <google/protobuf/message_lite.h>

#include <optional>
#include <string>
#include <string_view>

#include "league/team/team_codec.hpp"

namespace autoref::league {

void append_delimited(const google::protobuf::MessageLite& message, std::string& bytes);
void append_delimited(std::string_view message, std::string& bytes);

// See TeamCodec::find_message.
std::optional<MessageExtent> find_delimited(std::string_view bytes);

}  // namespace autoref::league
