#include "game/record/session_writer.h"

#include <fmt/format.h>

#include <bit>
#include <cassert>
#include <utility>

#include "engine/core/little_endian.h"
#include "game/record/layout.h"
#include "game/record/packed_block.h"

namespace onggi::record {

using little_endian::put;
namespace {

bool is_within(double number, double least, double most) {
    return number >= least && number <= most;  // false for NaN
}

Result<void> check_header(const SessionHeader& header, std::size_t start_state_bytes,
                          std::size_t supplement_bytes) {
    if (!is_within(header.rate_hz, kMinSessionRateHz, kMaxSessionRateHz)) {
        return bad_input(fmt::format("session: expected a rate of {} to {} Hz, found {}", kMinSessionRateHz,
                                     kMaxSessionRateHz, header.rate_hz));
    }
    if (header.element_count < 1 || header.element_count > kMaxElements) {
        return bad_input(
            fmt::format("session: expected 1 to {} elements, found {}", kMaxElements, header.element_count));
    }
    if (header.sector_count < 1 || header.sector_count > kMaxSectors) {
        return bad_input(
            fmt::format("session: expected 1 to {} sectors, found {}", kMaxSectors, header.sector_count));
    }
    if (start_state_bytes > kMaxStartStateBytes) {
        return bad_input(fmt::format("session: expected at most {} bytes of start state, found {}",
                                     kMaxStartStateBytes, start_state_bytes));
    }
    if (supplement_bytes > kMaxSupplementBytes) {
        return bad_input(fmt::format("session: expected at most {} bytes of supplement, found {}",
                                     kMaxSupplementBytes, supplement_bytes));
    }
    return {};
}

std::vector<std::byte> header_bytes(const SessionHeader& header, std::span<const std::byte> start_state,
                                    std::uint16_t minor_version) {
    std::vector<std::byte> bytes;
    bytes.reserve(header_at::kSize);
    for (const char c : kMagic)
        bytes.push_back(static_cast<std::byte>(c));
    put(bytes, kMajorVersion);
    put(bytes, minor_version);
    put(bytes, static_cast<std::uint32_t>(header_at::kSize));
    put(bytes, header.rate_hz);
    put(bytes, header.element_count);
    put(bytes, header.sector_count);
    put(bytes, std::uint32_t{0});  // flags: not used yet
    put(bytes, static_cast<std::uint32_t>(header.tool_detail));
    put(bytes, static_cast<std::uint64_t>(start_state.size()));
    put(bytes, header.start_state_hash);
    put(bytes, checksum(start_state));
    put(bytes, kHashInterval);
    put(bytes, std::uint32_t{0});  // reserved
    put(bytes, checksum(bytes));
    assert(bytes.size() == header_at::kSize);
    return bytes;
}

struct BlockHead {
    std::uint32_t tag = 0;
    std::uint32_t record_bytes = 0;
    std::uint64_t first_tick = 0;
    std::uint32_t tick_count = 0;
    std::uint32_t body_checksum = 0;
    std::uint64_t state_hash = 0;
    std::uint32_t packed_bytes = 0;
};

std::vector<std::byte> head_bytes(const BlockHead& head) {
    std::vector<std::byte> bytes;
    bytes.reserve(block_at::kSize);
    put(bytes, head.tag);
    put(bytes, head.record_bytes);
    put(bytes, head.first_tick);
    put(bytes, head.tick_count);
    put(bytes, head.body_checksum);
    put(bytes, head.state_hash);
    put(bytes, head.packed_bytes);
    put(bytes, checksum(bytes));
    assert(bytes.size() == block_at::kSize);
    return bytes;
}

// Compares bits, because 0.0 and -0.0 are different inputs and a replay needs the recorded one.
bool same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool same_position(const dvec3& a, const dvec3& b) {
    return same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z);
}

// Compares all fields but the hands' positions.
bool same_settings(const tool::ToolState& a, const tool::ToolState& b) {
    return same_bits(a.radius_mm, b.radius_mm) && a.wheel_button == b.wheel_button && a.tool == b.tool &&
           a.side == b.side && same_bits(a.water, b.water) && a.wire == b.wire &&
           same_bits(a.wire_height_mm, b.wire_height_mm) &&
           same_bits(a.wheel_speed_rev_min, b.wheel_speed_rev_min) &&
           same_bits(a.assist_gap_mm, b.assist_gap_mm) && same_bits(a.shaft_mm, b.shaft_mm) &&
           a.second.present == b.second.present && a.second.tool == b.second.tool &&
           same_bits(a.second.radius_mm, b.second.radius_mm) && a.guided == b.guided &&
           a.pressing == b.pressing;
}

// Whether a plain tool record holds all of the tool's fields that differ from their defaults.
bool is_plain(const tool::ToolState& tool) {
    const tool::ToolState plain = tool::plain_tool(tool);
    return same_settings(tool, plain) && same_position(tool.second.position_mm, plain.second.position_mm);
}

void put_position(std::vector<std::byte>& bytes, const dvec3& position_mm) {
    put(bytes, position_mm.x);
    put(bytes, position_mm.y);
    put(bytes, position_mm.z);
}

}  // namespace

Result<SessionWriter> SessionWriter::create(const std::filesystem::path& destination,
                                            const SessionHeader& header,
                                            std::span<const std::byte> start_state, files::Beside beside,
                                            std::span<const std::byte> supplement) {
    if (auto valid = check_header(header, start_state.size(), supplement.size()); !valid)
        return valid.error();
    auto file = files::AtomicFile::create(destination, beside);
    if (!file) return file.error();
    // The lowest version that covers the content, so that older programs can read as much as possible.
    const auto minor_version = static_cast<std::uint16_t>(header.tool_detail == ToolDetail::kWhole ? 2
                                                          : supplement.empty()                     ? 0
                                                                                                   : 1);
    if (auto written = file->write(header_bytes(header, start_state, minor_version)); !written)
        return written.error();
    if (auto written = file->write(start_state); !written) return written.error();
    return SessionWriter(std::move(file).value(), header, supplement);
}

SessionWriter::SessionWriter(files::AtomicFile file, const SessionHeader& header,
                             std::span<const std::byte> supplement)
    : file_(std::move(file)),
      header_(header),
      supplement_(supplement.begin(), supplement.end()) {
    checks_.reserve(kHashInterval);
    const bool is_whole = header.tool_detail == ToolDetail::kWhole;
    records_.reserve(kHashInterval * (1 + (is_whole ? tool::kWholeToolBytes : kToolBytes)));
}

Result<void> SessionWriter::add_tick(const tool::ToolState& tool, const dvec3& force_n) {
    return add_tick(tool, force_check(force_n));
}

Result<void> SessionWriter::add_tick(const tool::ToolState& tool, std::uint32_t kept_force_check) {
    assert(!block_is_full());
    const dvec3& at = tool.position_mm;
    if (tool::within_limits(tool, {}) != tool) {
        return failed(
            fmt::format("session: tick {}: expected a tool within its limits, found one at ({}, {}, "
                        "{}) mm of radius {} mm",
                        tick_count_, at.x, at.y, at.z, tool.radius_mm));
    }
    if (static_cast<double>(tick_count_) >= kMaxSessionSeconds * header_.rate_hz) {
        return failed(fmt::format("session: expected at most {} s, found more", kMaxSessionSeconds));
    }
    if (header_.tool_detail != ToolDetail::kWhole && !is_plain(tool)) {
        return failed(
            fmt::format("session: tick {}: expected a plain tool in this session, found more", tick_count_));
    }
    keep_tool(tool);
    checks_.push_back(kept_force_check);
    ++tick_count_;
    ++ticks_in_block_;
    return {};
}

void SessionWriter::keep_tool(const tool::ToolState& tool) {
    const bool same_tool = last_tool_ && same_settings(*last_tool_, tool);
    const bool same_first = same_tool && same_position(last_tool_->position_mm, tool.position_mm);
    const bool same_second =
        same_tool && same_position(last_tool_->second.position_mm, tool.second.position_mm);
    if (same_first && same_second) {
        ++run_;
        return;
    }
    flush_run();
    const auto open = [&](RecordKind kind) { put(records_, static_cast<std::uint8_t>(kind)); };
    if (same_second) {
        open(RecordKind::kPosition);
        put_position(records_, tool.position_mm);
    } else if (same_tool) {
        open(RecordKind::kBothPositions);
        tool::put_both_positions(records_, tool);
    } else if (is_plain(tool)) {
        open(RecordKind::kTool);
        put_position(records_, tool.position_mm);
        put(records_, tool.radius_mm);
        put(records_, static_cast<std::uint8_t>(tool.wheel_button ? 1 : 0));
    } else {
        open(RecordKind::kWholeTool);
        tool::put_whole_tool(records_, tool);
    }
    last_tool_ = tool;
}

void SessionWriter::flush_run() {
    if (run_ == 0) return;
    put(records_, static_cast<std::uint8_t>(RecordKind::kRepeat));
    put(records_, static_cast<std::uint16_t>(run_));
    run_ = 0;
}

Result<void> SessionWriter::end_block(std::uint64_t state_hash) {
    if (ticks_in_block_ == 0) return {};
    flush_run();
    BlockHead head{.tag = is_packed() ? kPackedTag : kTicksTag,
                   .record_bytes = static_cast<std::uint32_t>(records_.size()),
                   .first_tick = tick_count_ - ticks_in_block_,
                   .tick_count = ticks_in_block_,
                   .state_hash = state_hash};
    if (is_packed()) {
        records_ = pack_block(records_, checks_);
        head.packed_bytes = static_cast<std::uint32_t>(records_.size());
    } else {
        for (const std::uint32_t check : checks_)
            put(records_, check);
    }
    head.body_checksum = checksum(records_);
    if (auto written = file_.write(head_bytes(head)); !written) return written;
    if (auto written = file_.write(records_); !written) return written;
    ++block_count_;
    ticks_in_block_ = 0;
    records_.clear();
    checks_.clear();
    last_tool_.reset();
    // To survive a crash, a recording leaves the program's memory block by block.
    return file_.beside().empty() ? Result<void>{} : file_.flush();
}

Result<void> SessionWriter::sync() {
    return file_.prepare();
}

Result<void> SessionWriter::leave() {
    auto synced = file_.prepare();
    if (synced) file_.leave();
    return synced;
}

Result<void> SessionWriter::prepare(std::uint64_t state_hash) {
    if (auto ended = end_block(state_hash); !ended) return ended;
    if (!supplement_.empty()) {
        const auto head = head_bytes({.tag = kSupplementTag,
                                      .record_bytes = static_cast<std::uint32_t>(supplement_.size()),
                                      .first_tick = tick_count_,
                                      .body_checksum = checksum(supplement_)});
        if (auto written = file_.write(head); !written) return written;
        if (auto written = file_.write(supplement_); !written) return written;
    }
    const auto end = head_bytes({.tag = kEndTag,
                                 .record_bytes = 0,
                                 .first_tick = tick_count_,
                                 .tick_count = static_cast<std::uint32_t>(block_count_),
                                 .body_checksum = 0,
                                 .state_hash = 0});
    if (auto written = file_.write(end); !written) return written;
    return file_.prepare();
}

Result<void> SessionWriter::commit() {
    return file_.commit();
}

}  // namespace onggi::record
