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
constexpr double kGrowEvery_s = 1;

}  // namespace

view::RecordedDecision recorded(const referee::Decision& decision) {
  return view::recorded(game::decision_object(decision));
}

view::RecordedChain recorded(const game::PossessionChain& chain, double frame_rate_hz) {
  return {static_cast<double>(chain.first_frame) / frame_rate_hz,
          static_cast<double>(chain.last_frame) / frame_rate_hz,
          chain.team,
          std::string(name_of(chain.start)),
          std::string(name_of(chain.end)),
          chain.passes,
          chain.shots,
          chain.xg};
}

view::RecordedShot recorded(const game::Shot& shot, double frame_rate_hz,
                            bool blue_on_positive_half) {
  return {static_cast<double>(shot.frame) / frame_rate_hz, shot.team,
          published(shot.from_m, blue_on_positive_half), shot.chance, shot.has_scored};
}

view::RecordedAction recorded(const game::BallAction& action, double frame_rate_hz,
                              bool blue_on_positive_half) {
  return {static_cast<double>(action.first_frame) / frame_rate_hz,
          static_cast<double>(action.last_frame) / frame_rate_hz,
          action.team,
          action.robot,
          std::string(name_of(action.kind)),
          published(action.first_m, blue_on_positive_half),
          published(action.last_m, blue_on_positive_half),
          action.worth};
}

view::ChainKinds chain_kinds() {
  return {all_names<game::ChainStart>(), all_names<game::ChainEnd>()};
}

PageRecorder::PageRecorder(const game::GameConfiguration& game, io::PendingFile* growing)
    : game_(&game), growing_(growing) {
  if (game.scene) return;  // it ends long before a game would
  win_probability_.emplace(game, [this](double time_s, const game::WinProbability& probability) {
    add(view::RecordedWinProbability{time_s, probability.west, probability.draw});
  });
}

void PageRecorder::on_frame(const Frame& frame, const RefereeSignal& signal,
                            const sim::World& /*world*/) {
  add(published(frame, signal.blue_on_positive_half));
  add(frame.time_s, published(signal));
  blue_on_positive_half_ = signal.blue_on_positive_half;
  if (growing_ != nullptr && newest_.last_s() - newest_.first_s() >= kGrowEvery_s) grow();
}

void PageRecorder::grow() {
  if (!std::exchange(has_grown_, true)) growing_->write(view::page_of(content({})));
  growing_->write(view::page_part(newest_.take_recording()));
}

void PageRecorder::on_decision(const referee::Decision& decision) { add(recorded(decision)); }

void PageRecorder::on_action(const game::BallAction& action) {
  add(recorded(action, game_->sim.frame_rate_hz, blue_on_positive_half_));
}

void PageRecorder::on_chain(const game::PossessionChain& chain) {
  add(recorded(chain, game_->sim.frame_rate_hz));
}

// The teams change ends during breaks, so they have not done so since the shot.
void PageRecorder::on_shot(const game::Shot& shot) {
  add(recorded(shot, game_->sim.frame_rate_hz, blue_on_positive_half_));
}

view::PageContent PageRecorder::content(const view::GameRecording& recording) const {
  return {recording,        game_->field, game::shown_names(*game_),
          facts_of(*game_), std::nullopt, chain_kinds()};
}

std::string PageRecorder::page(const game::GameRecord& record) const {
  view::PageContent all = content(recording_);
  all.facts.insert(all.facts.end() - 1, {"state", io::hash_text(record.state_hash)});
  return view::page_of(all);
}

std::vector<view::PageFact> facts_of(const game::GameConfiguration& game) {
  return {{"rules", name_with_changes(game.match.rules.name, game::rule_changes_in(game))},
          {"seed", std::to_string(game.seed)},
          {"build", std::string(io::build_id())}};
}

void WebObserver::on_frame(const Frame& frame, const RefereeSignal& signal,
                           const sim::World& /*world*/) {
  view_->add(published(frame, signal.blue_on_positive_half), published(signal));
  blue_on_positive_half_ = signal.blue_on_positive_half;
}

void WebObserver::on_decision(const referee::Decision& decision) { view_->add(recorded(decision)); }

void WebObserver::on_chain(const game::PossessionChain& chain) {
  view_->add(recorded(chain, frame_rate_hz_));
}

void WebObserver::on_shot(const game::Shot& shot) {
  view_->add(recorded(shot, frame_rate_hz_, blue_on_positive_half_));
}

GameOnWeb::GameOnWeb(const game::GameConfiguration& game, const WebFlags& web) {
  if (web.address.empty()) return;
  const view::GameRecording nothing_yet;
  view_.emplace(web_options_of(web),
                view::PageContent{nothing_yet, game.field, game::shown_names(game), facts_of(game),
                                  std::nullopt, chain_kinds()});
  web_.emplace(*view_, game.sim.frame_rate_hz);
  io::write_message(stderr, fmt::format("watch at {}\n", view_->url()));
}

void GameOnWeb::end() {
  if (!view_) return;
  view_->end();
  std::this_thread::sleep_for(kFarewell);
}

}  // namespace autoref::app
