#include "live/referee/referee_status.hpp"

#include <fmt/format.h>

#include <cmath>

#include "logs/user_log.hpp"
#include "soccer/colour.hpp"

namespace autoref::live {
namespace {

std::string clock_of(double time_s) {
  const auto minutes = static_cast<long long>(time_s / 60);
  return fmt::format("{}:{:04.1f}", minutes, time_s - 60.0 * static_cast<double>(minutes));
}

std::string name_or(const std::string& name, const char* colour) {
  return name.empty() ? colour : fmt::format("{} ({})", name, colour);
}

}  // namespace

std::string call_line(const referee::Decision& decision) {
  if (!is_call(decision.finding.event)) return {};
  const std::optional<Side> offender = decision.finding.offender;
  std::string line =
      fmt::format("{}  {}", clock_of(decision.time_s), name_of(decision.finding.event));
  if (offender) line += fmt::format(" {}", colour_of(*offender));
  if (!decision.finding.evidence.empty()) line += ": " + decision.finding.evidence;
  return line;
}

std::string state_line(const LiveRefereeStatus& status) {
  const RefereeSignal& signal = status.signal;
  return fmt::format("{}, {}, {} {} : {} {}", name_of(signal.stage), name_of(signal.command),
                     name_or(status.names[Side::kWest], "yellow"), signal.goals[Side::kWest],
                     signal.goals[Side::kEast], name_or(status.names[Side::kEast], "blue"));
}

std::string controller_line(const ControllerStatus& controller) {
  std::string line = controller.is_registered ? "registered" : "not connected";
  const ControllerCounts& counts = controller.counts;
  line += fmt::format("; events: {} accepted, {} rejected, {} waiting, {} dropped", counts.accepted,
                      counts.rejected, controller.waiting, counts.dropped);
  if (controller.losses > 0) line += fmt::format("; {} connections lost", controller.losses);
  if (!controller.problem.empty()) line += "; " + controller.problem;
  if (!counts.last_rejection.empty()) line += "; last rejection: " + counts.last_rejection;
  return line;
}

std::string status_text(const LiveRefereeStatus& status, const std::deque<std::string>& calls,
                        std::size_t columns) {
  std::string text;
  const auto add = [&](const std::string& line) { text += line.substr(0, columns) + "\n"; };
  add(fmt::format("AutoRef  {}  {} frames", clock_of(status.time_s), status.frames));
  add("Game:    " + state_line(status));
  add("Vision:  " + text_of(status.vision));
  for (const std::string& fault : logs::texts_of(status.faults)) add("         " + fault);
  if (status.controller) add("Controller: " + controller_line(*status.controller));
  add("Calls:");
  for (const std::string& call : calls) add("  " + call);
  return text;
}

}  // namespace autoref::live
