// Sessions made up for tests: a hand that rests, moves, changes its tool.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "game/record/packed_block.h"
#include "game/record/session.h"
#include "game/record/session_writer.h"
#include "game/tool/tool.h"
#include "tests/support/session_checksums.h"
#include "tests/support/temporary_folder.h"

namespace onggi::record {

inline const std::string kStartState = "a lump of clay, opaque here";

inline std::span<const std::byte> bytes_of(std::string_view text) {
    return std::as_bytes(std::span(text.data(), text.size()));
}

// Rests for 300 ticks, moves for 300, rests with another tool for 300, and so on.
inline tool::ToolState tool_at(std::uint64_t tick) {
    const std::uint64_t part = tick / 300;
    tool::ToolState tool;
    const std::uint64_t moved = part % 2 == 0 ? part * 300 : tick;
    tool.position_mm = {60.0 + static_cast<double>(moved) / 8192.0, -0.0, static_cast<double>(part) / 3.0};
    tool.radius_mm = 10.0 + static_cast<double>(part % 30);
    tool.wheel_button = part % 3 == 1;
    return tool;
}

// A pair of hands: rests, moves one hand, moves both, changes the tools, releases and presses again.
inline tool::ToolState both_hands_at(std::uint64_t tick) {
    tool::ToolState tool = tool_at(tick);
    const std::uint64_t part = tick / 300;
    tool.tool = static_cast<tool::Tool>(part % 4);
    tool.side = static_cast<tool::Side>(part % 3);
    tool.water = part % 2 == 0 ? 0.25 : 1.0;
    tool.wire = part == 2 ? tool::Wire::kCutRim : tool::Wire::kNone;
    tool.wire_height_mm = static_cast<double>(part);
    tool.wheel_speed_rev_min = 100.0 + static_cast<double>(part);
    tool.assist_gap_mm = part % 5 == 4 ? 6.5 : 0.0;
    tool.shaft_mm = static_cast<double>(part % 3);
    tool.guided = part % 6 == 2 || part % 6 == 3;
    tool.pressing = part == 0 || tick % 90 < 60;
    if (part % 4 != 3) {
        const double moved = part % 4 == 1 ? static_cast<double>(tick) / 4096.0 : 0.0;
        tool.second = {.present = true,
                       .tool = tool::Tool::kRib,
                       .radius_mm = 7.0,
                       .position_mm = {-60.0 - moved, 20.0, -0.0}};
    }
    return tool;
}

inline dvec3 force_at(std::uint64_t tick) {
    return {static_cast<double>(tick) / 7.0, 0.0, tick % 500 < 250 ? 0.0 : -0.0};
}

inline std::uint64_t hash_after(std::uint64_t tick) {
    return 0x9e3779b97f4a7c15ULL * (tick + 1);
}

inline SessionHeader test_header() {
    return {.rate_hz = 4000.0,
            .element_count = 2000,
            .sector_count = 1,
            .tool_detail = ToolDetail::kPlain,
            .start_state_hash = 0x0123456789abcdefULL};
}

inline Result<void> record_ticks(SessionWriter& writer, std::uint64_t ticks) {
    for (std::uint64_t tick = 0; tick < ticks; ++tick) {
        if (auto added = writer.add_tick(tool_at(tick), force_at(tick)); !added) return added;
        if (!writer.block_is_full()) continue;
        if (auto ended = writer.end_block(hash_after(tick)); !ended) return ended;
    }
    return {};
}

inline SessionHeader studio_header() {
    SessionHeader header = test_header();
    header.tool_detail = ToolDetail::kWhole;
    header.sector_count = 256;
    return header;
}

// The bytes of a session of both hands.
inline std::string studio_session_bytes(std::uint64_t ticks) {
    const test::TemporaryFolder folder;
    auto writer = SessionWriter::create(folder / "s.onggi", studio_header(), bytes_of(kStartState));
    EXPECT_TRUE(writer) << writer.error().message;
    for (std::uint64_t tick = 0; tick < ticks; ++tick) {
        EXPECT_TRUE(writer->add_tick(both_hands_at(tick), force_at(tick)));
        if (!writer->block_is_full()) continue;
        EXPECT_TRUE(writer->end_block(hash_after(tick)));
    }
    EXPECT_TRUE(writer->prepare(hash_after(ticks - 1)));
    EXPECT_TRUE(writer->commit());
    return test::content_of(folder / "s.onggi");
}

// The bytes of that session in the version before blocks were packed, without the checks of its forces.
inline std::string unpacked(std::string_view packed) {
    const std::size_t blocks_at = test::kSessionHeaderBytes + test::get_at<std::uint64_t>(packed, 40);
    std::string bytes(packed.substr(0, blocks_at));
    test::put_at<std::uint16_t>(bytes, 10, 0);
    test::mend_session_header(bytes);
    for (std::size_t at = blocks_at; at < packed.size();) {
        const std::size_t block_at = bytes.size();
        bytes += packed.substr(at, test::kSessionBlockHeadBytes);
        at += test::kSessionBlockHeadBytes;
        if (bytes.substr(block_at, 4) == "TCKP") {
            const auto record_bytes = test::get_at<std::uint32_t>(bytes, block_at + 4);
            const auto ticks = test::get_at<std::uint32_t>(bytes, block_at + 16);
            const auto packed_bytes = test::get_at<std::uint32_t>(bytes, block_at + 32);
            const auto body = unpack_block(bytes_of(packed.substr(at, packed_bytes)), record_bytes, ticks);
            if (!body) return {};
            const std::string_view text(reinterpret_cast<const char*>(body->data()), body->size());
            bytes.replace(block_at, 4, "TCKS");
            test::put_at<std::uint32_t>(bytes, block_at + 32, 0);
            bytes += text.substr(0, record_bytes);
            bytes += std::string(std::size_t{4} * ticks, '\0');
            at += packed_bytes;
        }
        test::mend_session_block(bytes, block_at);
    }
    return bytes;
}

constexpr const char* kSupplement = "what was done to it later";

// The bytes of a session of `ticks` ticks.
inline std::string session_bytes(std::uint64_t ticks, std::string_view supplement = {}) {
    const test::TemporaryFolder folder;
    auto writer = SessionWriter::create(folder / "s.onggi", test_header(), bytes_of(kStartState),
                                        files::Beside::kNameless, bytes_of(supplement));
    EXPECT_TRUE(writer) << writer.error().message;
    EXPECT_TRUE(record_ticks(*writer, ticks));
    EXPECT_TRUE(writer->prepare(hash_after(ticks - 1)));
    EXPECT_EQ(folder.names(), std::vector<std::string>{});
    EXPECT_TRUE(writer->commit());
    return test::content_of(folder / "s.onggi");
}

inline std::size_t first_block_at() {
    return test::kSessionHeaderBytes + kStartState.size();
}

}  // namespace onggi::record
