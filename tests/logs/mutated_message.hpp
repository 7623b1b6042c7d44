// Sets a random field of a protobuf message to an unexpected value.
#pragma once

#include <google/protobuf/message.h>

#include "soccer/random.hpp"

namespace autoref::logs {

void mutate(google::protobuf::Message& message, RandomStream& chance);

}  // namespace autoref::logs
