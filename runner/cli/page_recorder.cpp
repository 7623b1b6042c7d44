#include "runner/cli/page_recorder.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "runner/cli/shown_game.hpp"
#include "runner/game/event_log.hpp"
#include "runner/io/checksum.hpp"
#include "runner/view/page.hpp"
#include "soccer/published.hpp"

namespace autoref::runner {

RecordedDecision recorded(const referee::Decision& decision) {
  return recorded(decision_object(decision));
}

void PageRecorder::on_frame(const Frame& frame, const RefereeSignal& signal,
                            const sim::World& /*world*/) {
  recording_.add(published(frame, signal.blue_on_positive_half));
  recording_.add(frame.time_s, published(signal));
}

void PageRecorder::on_decision(const referee::Decision& decision) {
  recording_.add(recorded(decision));
}

std::string PageRecorder::page(const GameConfiguration& game, const GameRecord& record) const {
  std::vector<PageFact> facts = facts_of(game);
  facts.insert(facts.end() - 1, {"state", hash_text(record.state_hash)});
  return page_of({recording_, game.field, shown_names(game), std::move(facts)});
}

}  // namespace autoref::runner
