#include "live/referee/live_referee.hpp"

#include <chrono>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "game/loop/game_event_fields.hpp"
#include "league/log_contents.hpp"
#include "league/record_reader.hpp"
#include "live/controller/placement_watch.hpp"
#include "live/network/record_source.hpp"
#include "live/referee/referee_outputs.hpp"
#include "live/referee/vision_quality.hpp"
#include "logs/facts_collector.hpp"
#include "logs/log_referee.hpp"
#include "logs/recorded_ends.hpp"
#include "soccer/referee_signal.hpp"

namespace autoref::live {
namespace {

constexpr std::chrono::milliseconds kIdleEvery{50};

using Clock = RecordSource::Clock;

constexpr std::chrono::milliseconds kIdle{20};
constexpr double kGather_s = 2;
constexpr double kLongestGather_s = 10;
constexpr std::size_t kMostGathered = 50'000;  // maximum number of packets
// Parsed packets take two to three times as much memory, and malicious ones thirty times as much:
// at most 3 GB.
constexpr std::size_t kMostGathered_bytes = 100'000'000;

std::vector<RecordGroup> groups_of(const LiveRefereeOptions& options) {
  std::vector<RecordGroup> groups;
  if (options.source == league::FrameSource::kTracker) {
    groups.push_back(
        {league::MessageKind::kTracker2020, kVisionGroup, options.ports.tracker, "--tracker-port"});
  }
  groups.push_back(
      {league::MessageKind::kVision2014, kVisionGroup, options.ports.vision, "--vision-port"});
  if (!options.commands) {
    groups.push_back({league::MessageKind::kReferee2013, kRefereeGroup, options.ports.referee,
                      "--referee-port"});
  }
  return groups;
}

class EndFinder final : public league::LogVisitor {
 public:
  explicit EndFinder(const Field& field) : end_(field) {}
  void on_frame(const Frame& frame) override { end_.add(frame); }
  void on_referee(double /*time_s*/, const league::RefereePacket& packet) override {
    end_.add(packet);
  }
  std::optional<Side> end() const { return end_.end(); }

 private:
  logs::YellowEnd end_;
};

}  // namespace

// Passes everything on to a first visitor and then to a second one.
class VisitorPair final : public league::LogVisitor {
 public:
  VisitorPair(league::LogVisitor& first, league::LogVisitor& second)
      : first_(first), second_(second) {}

  void on_frame(const Frame& frame) override {
    first_.on_frame(frame);
    second_.on_frame(frame);
  }
  void on_tracks(const Frame& frame, const Tracks& tracks) override {
    first_.on_tracks(frame, tracks);
    second_.on_tracks(frame, tracks);
  }
  void on_vision(double time_s, const league::VisionPacket& packet) override {
    first_.on_vision(time_s, packet);
    second_.on_vision(time_s, packet);
  }
  void on_referee(double time_s, const league::RefereePacket& packet) override {
    first_.on_referee(time_s, packet);
    second_.on_referee(time_s, packet);
  }

 private:
  league::LogVisitor& first_;
  league::LogVisitor& second_;
};

// A packet from the network.
struct LiveMessage {
  league::ParsedMessage message;
  double time_s = 0;  // time since the first packet
  std::string host;   // host of the sender
};

class LiveSession final : league::LogVisitor {
 public:
  // `watch` and `outputs` must outlive the object.
  LiveSession(const referee::Configuration& configuration, const logs::RecordedFacts& facts,
              bool frames_are_tracked, const LiveRefereeCallbacks& watch, RefereeOutputs& outputs);

  void process(const LiveMessage& live);

  // Sends what is due, and calls on_idle every 50 ms. Call this often.
  void idle();

 private:
  using Clock = std::chrono::steady_clock;

  void on_frame(const Frame& frame) override;  // called after the referee has judged the frame
  void on_vision(double time_s, const league::VisionPacket& packet) override;
  void on_referee(double time_s, const league::RefereePacket& packet) override;
  void report(const referee::Decision& decision);
  void report(const GameEvent& event);
  double frame_time_s(Clock::time_point now) const;

  const LiveRefereeCallbacks& watch_;
  RefereeOutputs& outputs_;
  logs::LogReferee referee_;
  VisitorPair both_;
  league::RecordReader reader_;
  VisionQuality quality_;
  PlacementWatch placement_;
  LiveRefereeStatus status_;
  Clock::time_point judged_ = Clock::now();
  Clock::time_point idle_due_{};
};

LiveSession::LiveSession(const referee::Configuration& configuration,
                         const logs::RecordedFacts& facts, bool frames_are_tracked,
                         const LiveRefereeCallbacks& watch, RefereeOutputs& outputs)
    : watch_(watch),
      outputs_(outputs),
      referee_({configuration}, facts.teams, logs::SignalOrder::kByArrival,
               [this](const referee::Decision& decision) { report(decision); }),
      both_(referee_, *this),
      reader_(both_, frames_are_tracked) {
  status_.names = facts.names;
}

void LiveSession::process(const LiveMessage& live) {
  const league::ReadResult result = reader_.read(live.message, live.time_s, live.host);
  if (std::holds_alternative<league::RefereePacket>(live.message.packet) &&
      result == league::ReadResult::kUsed)
    outputs_.note_referee(live.host);
}

void LiveSession::idle() {
  const auto now = Clock::now();
  outputs_.send_signal(referee_.signal(), frame_time_s(now));
  if (now < idle_due_) return;
  idle_due_ = now + kIdleEvery;
  status_.signal = referee_.signal();
  status_.vision = quality_.report();
  status_.faults = reader_.faults();
  status_.controller = outputs_.controller_status();
  if (watch_.on_idle) watch_.on_idle(status_);
}

void LiveSession::on_frame(const Frame& frame) {
  quality_.add(frame);
  status_.time_s = frame.time_s;
  ++status_.frames;
  judged_ = Clock::now();
  outputs_.set_start(reader_.merger().clocks().start_capture_s());
  const Tracks& tracks = referee_.referee().tracks();
  outputs_.send_tracks(tracks, referee_.is_turned());
  outputs_.send_signal(referee_.signal(), frame.time_s);
  if (referee_.configuration().control == referee::Control::kHuman) {
    if (const auto placed = placement_.update(referee_.signal(), tracks)) report(*placed);
  }
  if (watch_.on_frame) watch_.on_frame(frame, published(referee_.signal()));
}

void LiveSession::on_vision(double time_s, const league::VisionPacket& packet) {
  quality_.add(time_s, packet);
}

void LiveSession::on_referee(double /*time_s*/, const league::RefereePacket& packet) {
  status_.has_referee = true;
  status_.names = {{packet.yellow().name(), packet.blue().name()}};
}

void LiveSession::report(const referee::Decision& decision) {
  const std::optional<GameEvent> event =
      game::game_event_of(decision, reader_.merger().clocks().start_capture_s().value_or(0));
  outputs_.note(decision);
  if (watch_.on_decision) watch_.on_decision(decision);
  if (event) report(*event);
}

void LiveSession::report(const GameEvent& event) {
  outputs_.report(event);
  if (watch_.on_game_event) watch_.on_game_event(event);
}

// The time on the frames' clock, even while no frames arrive.
double LiveSession::frame_time_s(Clock::time_point now) const {
  return status_.time_s + std::chrono::duration<double>(now - judged_).count();
}

class LiveReferee::Impl {
 public:
  explicit Impl(const LiveRefereeOptions& options)
      : options_(options), source_(options.interface, groups_of(options)) {}

  logs::RecordedFacts gather(const std::function<void(std::int64_t packets)>& check) {
    logs::FactsCollector collector;
    league::RecordReader reader(collector, is_tracked());
    std::optional<Clock::time_point> first;
    while (!is_enough(reader, first)) {
      check(static_cast<std::int64_t>(gathered_.size()));
      std::optional<LiveMessage> live = next_message();
      if (!live) continue;
      reader.read(live->message, live->time_s, live->host);
      if (gathered_.size() < kMostGathered && received_bytes_ <= kMostGathered_bytes)
        gathered_.push_back(*std::move(live));
      if (!first && reader.frames() > 0) first = Clock::now();
    }
    league::LogSummary summary;
    summary.first_ns = first_ns_;
    summary.frames = reader.frames();
    summary.field = reader.merger().field();
    summary.field_gaps = reader.merger().field_gaps();
    logs::RecordedFacts facts = collector.facts(summary);
    facts.teams.yellow_end = yellow_end(summary.field.value_or(Field{}));
    return facts;
  }

  void run(const referee::Configuration& configuration, const logs::RecordedFacts& facts,
           const LiveRefereeCallbacks& watch) {
    RefereeOutputs outputs(options_, configuration.field, facts.names);
    LiveSession session(configuration, facts, is_tracked(), watch, outputs);
    for (const LiveMessage& live : gathered_) session.process(live);
    gathered_ = {};
    const auto begun = Clock::now();
    const std::chrono::duration<double> length_s(options_.seconds);
    while (options_.seconds == 0 || Clock::now() - begun < length_s) {
      if (const std::optional<LiveMessage> live = next_message()) session.process(*live);
      session.idle();
    }
  }

 private:
  bool is_tracked() const { return options_.source == league::FrameSource::kTracker; }

  // The next packet; nullopt if none arrives within a short time.
  std::optional<LiveMessage> next_message() {
    const std::optional<ReceivedRecord> record = source_.next(Clock::now() + kIdle);
    if (!record) return std::nullopt;
    if (first_ns_ == 0) first_ns_ = record->arrived_ns;
    received_bytes_ += record->bytes.size();
    LiveMessage live;
    league::parse(record->kind, record->bytes, live.message);
    live.time_s = record->arrived_after_s(first_ns_);
    live.host = record->host;
    return live;
  }

  static bool is_enough(const league::RecordReader& reader,
                        const std::optional<Clock::time_point>& first) {
    if (!first) return false;
    const double waited_s = std::chrono::duration<double>(Clock::now() - *first).count();
    return waited_s >= (reader.merger().field() ? kGather_s : kLongestGather_s);
  }

  std::optional<Side> yellow_end(const Field& field) {
    EndFinder finder(field);
    league::RecordReader reader(finder, is_tracked());
    for (const LiveMessage& live : gathered_) reader.read(live.message, live.time_s, live.host);
    return finder.end();
  }

  LiveRefereeOptions options_;
  RecordSource source_;
  std::vector<LiveMessage> gathered_;
  std::int64_t first_ns_ = 0;       // when the first packet arrived
  std::size_t received_bytes_ = 0;  // total size of all packets
};

LiveReferee::LiveReferee(const LiveRefereeOptions& options)
    : impl_(std::make_unique<Impl>(options)) {}
LiveReferee::~LiveReferee() = default;

logs::RecordedFacts LiveReferee::gather(const std::function<void(std::int64_t packets)>& check) {
  return impl_->gather(check);
}

void LiveReferee::run(const referee::Configuration& configuration, const logs::RecordedFacts& facts,
                      const LiveRefereeCallbacks& watch) {
  impl_->run(configuration, facts, watch);
}

}  // namespace autoref::live
