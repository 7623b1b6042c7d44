#include "live/controller/controller_reporter.hpp"

#include <fmt/format.h>

#include <utility>

#include "live/live_options.hpp"

namespace autoref::live {

ControllerReporter::ControllerReporter(const Address& controller, std::string uuid)
    : uuid_(std::move(uuid)),
      is_host_known_(!controller.host.empty()),
      client_(thread_, controller, kIdentifier) {}

void ControllerReporter::note_referee(const std::string& host) {
  if (is_host_known_ || host == host_) return;
  host_ = host;
  client_.set_host(host);
}

void ControllerReporter::report(GameEvent event) {
  event.id = fmt::format("{}-{}", uuid_, ++reported_);
  client_.report(event);
}

}  // namespace autoref::live
