// The first line that a team's program writes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace autoref::league {

enum class TeamEncoding : std::uint8_t { kProtobuf, kJson, kFlat, kLeague };

// What the program is given of robots and ball: motion as the simulator's tracker estimates it, or
// the detections of the latest camera frame.
enum class TeamMotion : std::uint8_t { kTracked, kDetections };

// As in a greeting: "json", "tracked".
std::string_view name_of(TeamEncoding encoding);
std::string_view name_of(TeamMotion motion);

struct Greeting {
  TeamEncoding encoding = TeamEncoding::kProtobuf;
  TeamMotion motion = TeamMotion::kTracked;
  bool operator==(const Greeting&) const = default;
};

// Reads "autoref-team 1 ENCODING [MOTION]", where ENCODING is protobuf, json, flat or league, and
// MOTION is tracked or detections (the default of league only). Throws TeamFault if the line is
// anything else.
Greeting greeting_of(std::string_view line);

struct GreetingAndSize {
  Greeting greeting;
  std::size_t size = 0;  // bytes of the line, including its end
};

// The greeting at the beginning of a program's output; nullopt if its line is not complete. Throws
// TeamFault as soon as the bytes cannot become a greeting.
std::optional<GreetingAndSize> find_greeting(std::string_view bytes);

}  // namespace autoref::league
