#include "engine/record/session.h"

#include <algorithm>
#include <cassert>

#include "engine/core/little_endian.h"
#include "engine/record/layout.h"

namespace onggi::record {

using little_endian::get;
using little_endian::get_double;

const std::byte* Session::at(std::size_t offset) const noexcept {
    return reinterpret_cast<const std::byte*>(bytes_.data()) + offset;
}

std::span<const std::byte> Session::supplement() const noexcept {
    if (supplement_bytes_ == 0) return {};
    return {at(supplement_at_), supplement_bytes_};
}

std::span<const std::byte> Session::start_state() const noexcept {
    return {at(start_state_at_), start_state_bytes_};
}

std::uint32_t Session::force_check_at(std::uint64_t tick) const noexcept {
    assert(tick < tick_count_);
    // Every block but the last holds kHashInterval ticks: the reader has made sure.
    const Block& block = blocks_[static_cast<std::size_t>(tick / kHashInterval)];
    return get<std::uint32_t>(
        at(block.checks_at + static_cast<std::size_t>(tick - block.first_tick) * kCheckBytes));
}

haptics::ToolState SessionCursor::at(std::uint64_t tick) noexcept {
    if (session_->tick_count() == 0) return {};
    tick = std::min(tick, session_->tick_count() - 1);
    if (!entered_ || tick < tick_ || tick / kHashInterval != block_) {
        enter(static_cast<std::size_t>(tick / kHashInterval));
    }
    while (tick_ < tick)
        step();
    return tool_;
}

void SessionCursor::enter(std::size_t block) noexcept {
    block_ = block;
    record_at_ = session_->blocks_[block].records_at;
    held_ = 0;
    step();
    tick_ = session_->blocks_[block].first_tick;
    entered_ = true;
}

// To the next tick of the same block.
void SessionCursor::step() noexcept {
    ++tick_;
    if (held_ > 0) {
        --held_;
        return;
    }
    const std::byte* record = session_->at(record_at_);
    const auto kind = static_cast<RecordKind>(get<std::uint8_t>(record));
    ++record;
    record_at_ += 1 + record_bytes(kind);
    if (kind == RecordKind::kRepeat) {
        held_ = get<std::uint16_t>(record) - 1U;
        return;
    }
    if (kind == RecordKind::kWholeTool) {
        tool_ = get_whole_tool(record);
        return;
    }
    if (kind == RecordKind::kBothPositions) {
        get_both_positions(record, tool_);
        return;
    }
    const dvec3 position_mm{get_double(record), get_double(record + 8), get_double(record + 16)};
    if (kind == RecordKind::kTool) tool_ = {};
    tool_.position_mm = position_mm;
    if (kind == RecordKind::kPosition) return;
    tool_.radius_mm = get_double(record + kPositionBytes);
    tool_.wheel_button = get<std::uint8_t>(record + kToolBytes - 1) == 1;
}

haptics::DeviceCapabilities SessionPlayer::capabilities() const {
    return {.name = "session"};
}

haptics::ToolState SessionPlayer::read(std::uint64_t tick, double /*dt_s*/) noexcept {
    return cursor_.at(tick);
}

}  // namespace onggi::record
