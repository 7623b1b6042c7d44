#include "live/controller/controller_session.hpp"

#include <fmt/format.h>

#include <utility>

#include "league/game_event_message.hpp"
#include "league/messages/game_controller.pb.h"
#include "league/team/delimited.hpp"
#include "league/team/team_fault.hpp"

namespace autoref::live {
namespace {

constexpr int kRejected = 2;  // a status of the controller

std::string event_message(const GameEvent& event) {
  league::AutoRefToController message;
  league::fill_game_event(event, *message.mutable_game_event());
  std::string bytes;
  league::append_delimited(message, bytes);
  return bytes;
}

std::string registration(const std::string& identifier) {
  league::AutoRefRegistration message;
  message.set_identifier(identifier);
  std::string bytes;
  league::append_delimited(message, bytes);
  return bytes;
}

std::string sign_of_life() {
  std::string bytes;
  league::append_delimited(league::AutoRefToController(), bytes);
  return bytes;
}

}  // namespace

void ControllerSession::begin(double now_s) {
  phase_ = Phase::kGreeting;
  sent_ = Sent::kNothing;
  sent_s_ = now_s;
  input_.clear();
}

void ControllerSession::report(GameEvent event, double now_s) {
  if (phase_ != Phase::kRegistered) drop_old(now_s);
  if (events_.size() == kMostWaiting) {
    events_.pop_front();
    ++counts_.dropped;
    if (sent_ == Sent::kEvent) sent_ = Sent::kSignOfLife;  // its reply is still outstanding
  }
  events_.push_back({std::move(event), now_s});
}

void ControllerSession::receive(std::string_view bytes, double now_s) {
  input_ += bytes;
  sent_s_ = now_s;
  try {
    while (const auto extent = league::find_delimited(input_)) {
      league::ControllerToAutoRef message;
      if (!message.ParseFromString(input_.substr(extent->begin, extent->size)))
        throw ControllerFault("the game controller sent a message that is not a reply");
      input_.erase(0, extent->end);
      take_reply(message.controller_reply().status_code(), message.controller_reply().reason());
    }
  } catch (const league::TeamFault&) {
    throw ControllerFault("the game controller sent a message that is too long");
  }
}

void ControllerSession::take_reply(int status, const std::string& reason) {
  const bool is_rejected = status == kRejected;
  const Sent answered = std::exchange(sent_, Sent::kNothing);
  if (is_rejected) counts_.last_rejection = reason;
  switch (answered) {
    case Sent::kRegistration:
      if (is_rejected)
        throw ControllerFault(
            fmt::format("the game controller rejected '{}': {}", identifier_, reason));
      phase_ = Phase::kRegistered;
      return;
    case Sent::kEvent:
      ++(is_rejected ? counts_.rejected : counts_.accepted);
      events_.pop_front();
      return;
    case Sent::kNothing:
      if (phase_ == Phase::kGreeting) phase_ = Phase::kRegistering;
      return;
    case Sent::kSignOfLife:
      return;
  }
}

void ControllerSession::drop_old(double now_s) {
  while (!events_.empty() && now_s - events_.front().at_s > kLongestWait_s) {
    events_.pop_front();
    ++counts_.dropped;
  }
}

std::string ControllerSession::send(double now_s) {
  if (sent_ != Sent::kNothing || phase_ == Phase::kGreeting) {
    if (now_s - sent_s_ > kLongestReply_s)
      throw ControllerFault(
          fmt::format("the game controller has not replied for {} s", kLongestReply_s));
    return {};
  }
  drop_old(now_s);
  const bool is_quiet = now_s - sent_s_ > kSignOfLife_s;
  if (phase_ == Phase::kRegistered && events_.empty() && !is_quiet) return {};
  sent_s_ = now_s;
  if (phase_ == Phase::kRegistering) {
    sent_ = Sent::kRegistration;
    return registration(identifier_);
  }
  sent_ = events_.empty() ? Sent::kSignOfLife : Sent::kEvent;
  return events_.empty() ? sign_of_life() : event_message(events_.front().event);
}

}  // namespace autoref::live
