#include "live/referee/live_referee.hpp"

#include <chrono>
#include <vector>

#include "league/record_reader.hpp"
#include "live/referee/live_judge.hpp"
#include "live/referee/referee_outputs.hpp"
#include "logs/fact_finder.hpp"
#include "logs/yellow_end.hpp"

namespace autoref::live {
namespace {

using Clock = RecordSource::Clock;

constexpr std::chrono::milliseconds kIdle{20};
constexpr double kGather_s = 2;
constexpr double kLongestGather_s = 10;
constexpr std::size_t kMostGathered = 50'000;  // packets
// Parsed, packets take two to three times as much memory; malicious ones thirty times, so at most
// 3 GB.
constexpr std::size_t kMostGathered_bytes = 100'000'000;
constexpr double kNs = 1e-9;

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
  void on_frame(const Frame& frame) override { end_.take(frame); }
  void on_referee(double /*time_s*/, const league::RefereePacket& packet) override {
    end_.take(packet);
  }
  std::optional<Side> end() const { return end_.end(); }

 private:
  logs::YellowEnd end_;
};

}  // namespace

class LiveReferee::Impl {
 public:
  explicit Impl(const LiveRefereeOptions& options)
      : options_(options), source_(options.interface, groups_of(options)) {}

  logs::RecordedFacts gather(const std::function<void(std::int64_t packets)>& check) {
    logs::FactFinder finder;
    league::RecordReader reader(finder, is_tracked());
    std::optional<Clock::time_point> first;
    while (!is_enough(reader, first)) {
      check(static_cast<std::int64_t>(gathered_.size()));
      std::optional<LiveMessage> live = next_message();
      if (!live) continue;
      reader.take(live->message, live->time_s, live->host);
      if (gathered_.size() < kMostGathered && received_bytes_ <= kMostGathered_bytes)
        gathered_.push_back(*std::move(live));
      if (!first && reader.frames() > 0) first = Clock::now();
    }
    league::LogSummary summary;
    summary.first_ns = first_ns_;
    summary.frames = reader.frames();
    summary.field = reader.merger().field();
    summary.field_gaps = reader.merger().field_gaps();
    logs::RecordedFacts facts = finder.facts(summary);
    facts.teams.yellow_end = yellow_end(summary.field.value_or(Field{}));
    return facts;
  }

  void run(const referee::Configuration& configuration, const logs::RecordedFacts& facts,
           const LiveRefereeWatch& watch) {
    RefereeOutputs outputs(options_, configuration.field, facts.names);
    LiveJudge judge(configuration, facts, is_tracked(), watch, outputs);
    for (const LiveMessage& live : gathered_) judge.take(live);
    gathered_ = {};
    const auto begun = Clock::now();
    const std::chrono::duration<double> length_s(options_.seconds);
    while (options_.seconds == 0 || Clock::now() - begun < length_s) {
      if (const std::optional<LiveMessage> live = next_message()) judge.take(*live);
      judge.idle();
    }
  }

 private:
  bool is_tracked() const { return options_.source == league::FrameSource::kTracker; }

  // The next packet; nullopt if none arrives for a moment.
  std::optional<LiveMessage> next_message() {
    const std::optional<ReceivedRecord> record = source_.take(Clock::now() + kIdle);
    if (!record) return std::nullopt;
    if (first_ns_ == 0) first_ns_ = record->arrived_ns;
    received_bytes_ += record->bytes.size();
    LiveMessage live;
    league::parse(record->kind, record->bytes, live.message);
    live.time_s = static_cast<double>(record->arrived_ns - first_ns_) * kNs;
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
    for (const LiveMessage& live : gathered_) reader.take(live.message, live.time_s, live.host);
    return finder.end();
  }

  LiveRefereeOptions options_;
  RecordSource source_;
  std::vector<LiveMessage> gathered_;
  std::int64_t first_ns_ = 0;       // when the first packet arrived
  std::size_t received_bytes_ = 0;  // of all packets
};

LiveReferee::LiveReferee(const LiveRefereeOptions& options)
    : impl_(std::make_unique<Impl>(options)) {}
LiveReferee::~LiveReferee() = default;

logs::RecordedFacts LiveReferee::gather(const std::function<void(std::int64_t packets)>& check) {
  return impl_->gather(check);
}

void LiveReferee::run(const referee::Configuration& configuration, const logs::RecordedFacts& facts,
                      const LiveRefereeWatch& watch) {
  impl_->run(configuration, facts, watch);
}

}  // namespace autoref::live
