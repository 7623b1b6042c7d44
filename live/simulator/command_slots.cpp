#include "live/simulator/command_slots.hpp"

namespace autoref::live {

void CommandSlots::add(Side side, const std::vector<league::CommandUpdate>& updates) {
  bool is_awaited = false;
  {
    const std::lock_guard lock(mutex_);
    for (const league::CommandUpdate& update : updates) {
      Slot& slot = slots_[side].at(static_cast<std::size_t>(update.robot));
      league::merge(update, slot.held);
      slot.is_new = slot.is_held = true;
    }
    ++packets_[side];
    is_awaited = is_waiting_;
  }
  if (is_awaited) news_.notify_one();
}

PerSide<std::int64_t> CommandSlots::packets() const {
  const std::lock_guard lock(mutex_);
  return packets_;
}

bool CommandSlots::wait(const PerSide<std::int64_t>& before, const PerSide<bool>& is_awaited,
                        Clock::time_point deadline) {
  std::unique_lock lock(mutex_);
  is_waiting_ = true;
  const bool is_complete = news_.wait_until(lock, deadline, [&] {
    for (const Side side : kSides) {
      if (is_awaited[side] && packets_[side] <= before[side]) return false;
    }
    return true;
  });
  is_waiting_ = false;
  return is_complete;
}

TeamCommands CommandSlots::collect_commands(Side side, std::int64_t frame, const SideState& state) {
  TeamCommands commands{};
  const std::lock_guard lock(mutex_);
  for (std::size_t number = 0; number < commands.size(); ++number) {
    Slot& slot = slots_[side].at(number);
    if (slot.is_new) slot.frame = frame;
    slot.is_new = false;
    if (slot.is_held && frame - slot.frame > lapse_frames_) slot = {};
    if (!slot.is_held) continue;
    commands.at(number) = transmitted(
        league::command_of(slot.held, state.headings.at(number), state.wheels.at(number)));
  }
  return commands;
}

}  // namespace autoref::live
