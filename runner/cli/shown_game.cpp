#include "runner/cli/shown_game.hpp"

#include <fmt/format.h>

#include <chrono>
#include <thread>

#include "runner/cli/page_recorder.hpp"
#include "runner/io/build_id.hpp"
#include "runner/io/errors.hpp"
#include "soccer/published.hpp"

namespace autoref::runner {
namespace {

constexpr std::chrono::seconds kFarewell{1};

}  // namespace

std::vector<PageFact> facts_of(const GameConfiguration& game) {
  return {{"rules", game.match.rules.name},
          {"seed", std::to_string(game.seed)},
          {"build", std::string(build_id())}};
}

void WebObserver::on_frame(const Frame& frame, const RefereeSignal& signal,
                           const sim::World& /*world*/) {
  view_->add(published(frame, signal.blue_on_positive_half), published(signal));
}

void WebObserver::on_decision(const referee::Decision& decision) { view_->add(recorded(decision)); }

ShownGame::ShownGame(const GameConfiguration& game, const WebFlags& web) {
  if (web.address.empty()) return;
  const GameRecording nothing_yet;
  view_.emplace(web_options_of(web),
                PageContent{nothing_yet, game.field, shown_names(game), facts_of(game)});
  web_.emplace(*view_);
  write_message(stderr, fmt::format("watch at {}\n", view_->url()));
}

void ShownGame::end() {
  if (!view_) return;
  view_->end();
  std::this_thread::sleep_for(kFarewell);
}

}  // namespace autoref::runner
