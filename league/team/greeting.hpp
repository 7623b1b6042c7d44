// The greeting, which is the first line that a team's program writes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "soccer/named.hpp"

namespace autoref::league {

enum class TeamEncoding : std::uint8_t { kJson, kFlat, kLeague };

// How the program gets the robots and the ball: as motion estimated by the simulator's tracker, or
// as detections from the latest camera frame.
enum class TeamMotion : std::uint8_t { kTracked, kDetections };

// The names used in a greeting.
constexpr auto names_of(TeamEncoding /*any*/) {
  return std::to_array<Named<TeamEncoding>>({{TeamEncoding::kJson, "json"},
                                             {TeamEncoding::kFlat, "flat"},
                                             {TeamEncoding::kLeague, "league"}});
}

constexpr auto names_of(TeamMotion /*any*/) {
  return std::to_array<Named<TeamMotion>>(
      {{TeamMotion::kTracked, "tracked"}, {TeamMotion::kDetections, "detections"}});
}

using autoref::name_of;

struct Greeting {
  TeamEncoding encoding = TeamEncoding::kJson;
  TeamMotion motion = TeamMotion::kTracked;
  bool operator==(const Greeting&) const = default;
};

// Reads "autoref-team 1 ENCODING [MOTION]", with the names above. MOTION defaults to tracked, or,
// if the encoding is league, to detections. Throws TeamFault if the line does not have this form.
Greeting greeting_of(std::string_view line);

struct GreetingAndSize {
  Greeting greeting;
  std::size_t size = 0;  // length of the line in bytes, including its end
};

// The greeting at the beginning of a program's output; nullopt if its line is not complete. Throws
// TeamFault as soon as the bytes cannot become a greeting.
std::optional<GreetingAndSize> find_greeting(std::string_view bytes);

}  // namespace autoref::league
