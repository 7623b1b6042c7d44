#include "app/game/page_recorder.hpp"

#include <fmt/format.h>
#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>
#include <utility>

#include "game/loop/event_log.hpp"
#include "io/build_id.hpp"
#include "io/checksum.hpp"
#include "io/errors.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/rules/rule_changes.hpp"
#include "view/page.hpp"

namespace autoref::app {
namespace {

constexpr std::chrono::seconds kFarewell{1};

}  // namespace

view::RecordedDecision recorded(const referee::Decision& decision) {
  return view::recorded(game::decision_object(decision));
}

void PageRecorder::on_frame(const Frame& frame, const RefereeSignal& signal,
                            const sim::World& /*world*/) {
  recording_.add(published(frame, signal.blue_on_positive_half));
  recording_.add(frame.time_s, published(signal));
}

void PageRecorder::on_decision(const referee::Decision& decision) {
  recording_.add(recorded(decision));
}

std::string PageRecorder::page(const game::GameConfiguration& game,
                               const game::GameRecord& record) const {
  std::vector<view::PageFact> facts = facts_of(game);
  facts.insert(facts.end() - 1, {"state", io::hash_text(record.state_hash)});
  return view::page_of({recording_, game.field, game::shown_names(game), std::move(facts)});
}

std::vector<view::PageFact> facts_of(const game::GameConfiguration& game) {
  return {{"rules", name_with_changes(game.match.rules.name, game::rule_changes_in(game))},
          {"seed", std::to_string(game.seed)},
          {"build", std::string(io::build_id())}};
}

void WebObserver::on_frame(const Frame& frame, const RefereeSignal& signal,
                           const sim::World& /*world*/) {
  view_->add(published(frame, signal.blue_on_positive_half), published(signal));
}

void WebObserver::on_decision(const referee::Decision& decision) { view_->add(recorded(decision)); }

GameOnWeb::GameOnWeb(const game::GameConfiguration& game, const WebFlags& web) {
  if (web.address.empty()) return;
  const view::GameRecording nothing_yet;
  view_.emplace(web_options_of(web), view::PageContent{nothing_yet, game.field,
                                                       game::shown_names(game), facts_of(game)});
  web_.emplace(*view_);
  io::write_message(stderr, fmt::format("watch at {}\n", view_->url()));
}

void GameOnWeb::end() {
  if (!view_) return;
  view_->end();
  std::this_thread::sleep_for(kFarewell);
}

}  // namespace autoref::app
