#include "app/game/page_recorder.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "app/game/shown_game.hpp"
#include "game/loop/event_log.hpp"
#include "io/checksum.hpp"
#include "soccer/published.hpp"
#include "view/page.hpp"

namespace autoref::app {

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

}  // namespace autoref::app
