#include "game/record/session.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <set>
#include <utility>

#include "game/tool/tool.h"
#include "tests/support/hostile_system.h"
#include "tests/unit/record/recordings.h"

namespace onggi::record {
namespace {

using test::TemporaryFolder;

Session session_of(std::string bytes) {
    auto session = parse_session(std::move(bytes), "s.onggi");
    EXPECT_TRUE(session) << session.error().message;
    return std::move(session).value();
}

TEST(Session, GivesBackHeaderAndStartState) {
    const Session session = session_of(session_bytes(10));
    EXPECT_EQ(session.header(), test_header());
    const auto state = session.start_state();
    EXPECT_EQ(std::string(reinterpret_cast<const char*>(state.data()), state.size()), kStartState);
    EXPECT_TRUE(session.is_complete());
    EXPECT_EQ(session.usable_bytes(), session.file_bytes());
}

TEST(Session, GivesBackEveryTick) {
    for (const std::uint64_t ticks : {1U, 2U, 299U, 999U, 1000U, 1001U, 2000U, 7350U}) {
        const Session session = session_of(session_bytes(ticks));
        ASSERT_EQ(session.tick_count(), ticks);
        SessionCursor cursor(session);
        for (std::uint64_t tick = 0; tick < ticks; ++tick) {
            const tool::ToolState tool = cursor.at(tick);
            ASSERT_EQ(tool, tool_at(tick)) << tick;
            // -0.0 equals 0.0, but it is not the same input.
            ASSERT_TRUE(std::signbit(tool.position_mm.y)) << tick;
            ASSERT_TRUE(session.has_force_at(tick, force_at(tick))) << tick;
        }
    }
}

TEST(Session, HasAHashEveryThousandTicksAndAtItsEnd) {
    const Session session = session_of(session_bytes(2500));
    ASSERT_EQ(session.blocks().size(), 3U);
    EXPECT_EQ(session.blocks()[0].state_hash, hash_after(999));
    EXPECT_EQ(session.blocks()[1].state_hash, hash_after(1999));
    EXPECT_EQ(session.blocks()[2].state_hash, hash_after(2499));
    EXPECT_EQ(session.blocks()[2].first_tick, 2000U);
    EXPECT_EQ(session.blocks()[2].tick_count, 500U);
}

TEST(Session, CanBeEmpty) {
    const TemporaryFolder folder;
    auto writer = SessionWriter::create(folder / "s.onggi", test_header(), {});
    ASSERT_TRUE(writer);
    ASSERT_TRUE(writer->prepare(1));
    ASSERT_TRUE(writer->commit());
    const Session session = session_of(test::content_of(folder / "s.onggi"));
    EXPECT_EQ(session.tick_count(), 0U);
    EXPECT_TRUE(session.is_complete());
    EXPECT_TRUE(session.start_state().empty());
    EXPECT_EQ(SessionCursor(session).at(3), tool::ToolState{});
}

TEST(Session, GivesBackItsSupplementAndPlaysAllTheSame) {
    const Session session = session_of(session_bytes(1500, kSupplement));
    const auto found = session.supplement();
    EXPECT_EQ(std::string(reinterpret_cast<const char*>(found.data()), found.size()), kSupplement);
    EXPECT_TRUE(session.is_complete());
    EXPECT_EQ(session.tick_count(), 1500U);
    EXPECT_TRUE(session_of(session_bytes(1500)).supplement().empty());
}

TEST(Session, IsOfTheVersionBeforeWhereItHasNoSupplement) {
    EXPECT_EQ(session_bytes(10)[10], 0);
    EXPECT_EQ(session_bytes(10, kSupplement)[10], 1);
}

TEST(Session, PlaysAllItsTicksWhereItIsCutWithinItsSupplement) {
    const std::string whole = session_bytes(1500, kSupplement);
    for (std::size_t missing = 1; missing <= 80 + std::string_view(kSupplement).size(); ++missing) {
        const Session session = session_of(whole.substr(0, whole.size() - missing));
        ASSERT_FALSE(session.is_complete());
        ASSERT_EQ(session.tick_count(), 1500U);
        ASSERT_EQ(session.supplement().empty(), missing > 40);
    }
}

TEST(Session, IsTheSameFileEveryTime) {
    EXPECT_EQ(session_bytes(3456), session_bytes(3456));
}

TEST(Session, HasTheBytesItsDocumentSays) {
    const TemporaryFolder folder;
    auto writer = SessionWriter::create(folder / "s.onggi", {.rate_hz = 1000.0, .start_state_hash = 0x1122},
                                        bytes_of("AB"));
    ASSERT_TRUE(writer);
    const tool::ToolState tool{.position_mm = {1.0, 2.0, 4.0}, .radius_mm = 10.0, .wheel_button = true};
    ASSERT_TRUE(writer->add_tick(tool, {}));
    ASSERT_TRUE(writer->add_tick(tool, {}));
    ASSERT_TRUE(writer->prepare(0x77));
    ASSERT_TRUE(writer->commit());
    const std::string bytes = test::content_of(folder / "s.onggi");
    const auto hex = [&](std::size_t from, std::size_t count) {
        std::string text;
        for (std::size_t at = from; at < from + count; ++at) {
            char digits[4];
            std::snprintf(digits, sizeof digits, "%02x", static_cast<unsigned char>(bytes.at(at)));
            text += digits;
        }
        return text;
    };
    EXPECT_EQ(hex(0, 16),
              "894f4e4747490d0a"
              "0200"
              "0000"
              "48000000");
    EXPECT_EQ(hex(16, 24),
              "0000000000408f40"
              "d0070000"
              "01000000"
              "00000000"
              "01000000");
    EXPECT_EQ(hex(40, 16),
              "0200000000000000"
              "2211000000000000");
    EXPECT_EQ(hex(60, 8),
              "e8030000"
              "00000000");
    EXPECT_EQ(bytes.substr(72, 2), "AB");
    // The block: "TCKS", 37 bytes of records, first tick 0, 2 ticks, [checksum], state hash, reserved.
    EXPECT_EQ(hex(74, 20),
              "54434b53"
              "25000000"
              "0000000000000000"
              "02000000");
    EXPECT_EQ(hex(98, 12),
              "7700000000000000"
              "00000000");
    // A tool, then one repetition.
    EXPECT_EQ(hex(114, 37),
              "01"
              "000000000000f03f"
              "0000000000000040"
              "0000000000001040"
              "0000000000002440"
              "01"
              "03"
              "0100");
    // Two checks, then the end: "END.", 2 ticks, 1 block.
    EXPECT_EQ(hex(151, 4), hex(155, 4));
    EXPECT_EQ(hex(159, 20),
              "454e442e"
              "00000000"
              "0200000000000000"
              "01000000");
    EXPECT_EQ(bytes.size(), 159U + 40U);
}

TEST(Session, KeepsARestingHandSmallAndAMovingOneUnder30BytesATick) {
    // 300 ticks rest, 300 move: about 14.5 bytes a tick on average, checks included.
    EXPECT_LT(session_bytes(60000).size(), 60000U * 18U);
}

TEST(SessionCursor, FindsAnyTickInAnyOrder) {
    const Session session = session_of(session_bytes(4321));
    SessionCursor cursor(session);
    std::uint64_t tick = 17;
    for (int i = 0; i < 500; ++i) {
        tick = (tick * 6364136223846793005ULL + 1442695040888963407ULL) % 4321;
        ASSERT_EQ(cursor.at(tick), tool_at(tick)) << tick;
        ASSERT_EQ(cursor.at(tick), tool_at(tick)) << "again " << tick;
    }
    EXPECT_EQ(cursor.at(4320), tool_at(4320));
    EXPECT_EQ(cursor.at(1000000), tool_at(4320));
    EXPECT_EQ(cursor.at(0), tool_at(0));
}

TEST(ForceCheck, TellsForcesApartByTheirBits) {
    std::set<std::uint32_t> seen;
    for (const dvec3& force : {dvec3(0, 0, 0), dvec3(-0.0, 0, 0), dvec3(0, 1, 0), dvec3(1, 0, 0),
                               dvec3(std::nextafter(1.0, 2.0), 0, 0), dvec3(0, 0, 1)}) {
        EXPECT_TRUE(seen.insert(force_check(force)).second);
    }
}

// The offsets at which blocks of a session begin, its end marker's last.
std::vector<std::size_t> block_offsets(const Session& session) {
    std::vector<std::size_t> offsets;
    for (const Session::Block& block : session.blocks())
        offsets.push_back(block.records_at - test::kSessionBlockHeadBytes);
    offsets.push_back(session.file_bytes() - test::kSessionBlockHeadBytes);
    return offsets;
}

TEST(ACutSession, PlaysUpToItsLastWholeBlock) {
    const std::string whole = session_bytes(3500);
    const auto offsets = block_offsets(session_of(whole));
    ASSERT_EQ(offsets.size(), 5U);
    std::set<std::size_t> sizes;
    for (std::size_t size = first_block_at(); size < whole.size(); size += 97)
        sizes.insert(size);
    for (const std::size_t offset : offsets)
        sizes.insert({offset - 1, offset, offset + 1, offset + 39, offset + 40});
    sizes.erase(sizes.lower_bound(whole.size()), sizes.end());
    sizes.erase(first_block_at() - 1);
    for (const std::size_t size : sizes) {
        const auto session = parse_session(whole.substr(0, size), "s.onggi");
        ASSERT_TRUE(session) << size << " " << session.error().message;
        EXPECT_FALSE(session->is_complete());
        std::size_t whole_blocks = 0;
        while (whole_blocks < 4 && offsets[whole_blocks + 1] <= size)
            ++whole_blocks;
        ASSERT_EQ(session->blocks().size(), whole_blocks) << size;
        ASSERT_EQ(session->tick_count(), std::min<std::uint64_t>(whole_blocks * 1000, 3500)) << size;
        ASSERT_EQ(session->usable_bytes(), whole_blocks == 0 ? first_block_at() : offsets[whole_blocks]);
    }
}

TEST(SessionWriter, LeavesItsCompleteBlocksIfTheProgramIsKilled) {
    const TemporaryFolder folder;
    EXPECT_EQ(test::in_child([&] {
                  auto writer = SessionWriter::create(folder / "s.onggi", test_header(),
                                                      bytes_of(kStartState), files::Beside::kNamed);
                  if (!writer || !record_ticks(*writer, 2700)) return std::string("failed");
                  ::kill(::getpid(), SIGKILL);
                  return std::string("alive");
              }),
              "killed by signal 9");
    const Session session = session_of(test::content_of(folder / "s.onggi.part"));
    EXPECT_FALSE(session.is_complete());
    ASSERT_EQ(session.tick_count(), 2000U);
    SessionCursor cursor(session);
    for (std::uint64_t tick = 0; tick < 2000; ++tick)
        ASSERT_EQ(cursor.at(tick), tool_at(tick));
}

TEST(SessionWriter, OnAFullDiskLeavesNoFile) {
    const TemporaryFolder folder;
    EXPECT_EQ(
        test::in_child([&] {
            test::fill_disk_after(folder.path(), std::size_t{64} << 10U);
            auto writer = SessionWriter::create(folder / "s.onggi", test_header(), bytes_of(kStartState));
            if (!writer) return writer.error().message;
            auto done = record_ticks(*writer, 60000);
            if (done) done = writer->prepare(0);
            if (done) return std::string("written");
            return std::to_string(exit_code(done.error().kind)) + " " + std::to_string(folder.names().size());
        }),
        "3 0");
}

TEST(StudioSession, HoldsBothHandsAndAllTheySay) {
    const auto session = parse_session(studio_session_bytes(5000), "s.onggi");
    ASSERT_TRUE(session) << session.error().message;
    EXPECT_EQ(session->header(), studio_header());
    SessionCursor cursor(*session);
    for (std::uint64_t tick = 0; tick < 5000; ++tick)
        ASSERT_EQ(cursor.at(tick), both_hands_at(tick)) << tick;
    for (const std::uint64_t tick : {4999U, 2500U, 299U, 300U, 0U, 1234U})
        ASSERT_EQ(cursor.at(tick), both_hands_at(tick)) << tick;
}

// The last two bytes of a tool, where its document has them.
TEST(StudioSession, EndsAToolWithWhetherItIsGuidedAndWhetherItPresses) {
    const test::TemporaryFolder folder;
    for (const auto& [guided, pressing] : {std::pair{false, false}, {true, false}, {true, true}}) {
        auto writer = SessionWriter::create(folder / "s.onggi", studio_header(), {});
        ASSERT_TRUE(writer);
        ASSERT_TRUE(writer->add_tick({.guided = guided, .pressing = pressing}, dvec3(0.0)));
        ASSERT_TRUE(writer->prepare(0));
        ASSERT_TRUE(writer->commit());
        const std::string bytes = unpacked(test::content_of(folder / "s.onggi"));
        const std::size_t record_at = test::kSessionHeaderBytes + test::kSessionBlockHeadBytes;
        EXPECT_EQ(bytes.at(record_at), 4);
        EXPECT_EQ(bytes.at(record_at + 1 + 110), guided ? 1 : 0);
        EXPECT_EQ(bytes.at(record_at + 1 + 111), pressing ? 1 : 0);
        EXPECT_EQ(bytes.size(), record_at + 1 + 112 + 4 + test::kSessionBlockHeadBytes);
    }
}

TEST(StudioSession, IsTheSamePackedAndInTheVersionBefore) {
    const std::string packed = studio_session_bytes(4321);
    const std::string plain = unpacked(packed);
    EXPECT_EQ(packed[10], 2);
    EXPECT_LT(3 * packed.size(), plain.size());
    const Session session = session_of(packed);
    const Session before = session_of(plain);
    ASSERT_EQ(session.blocks().size(), before.blocks().size());
    EXPECT_TRUE(session.is_complete());
    SessionCursor cursor(session);
    SessionCursor cursor_before(before);
    int taken_for_it = 0;
    for (std::uint64_t tick = 0; tick < 4321; ++tick) {
        ASSERT_EQ(cursor.at(tick), cursor_before.at(tick)) << tick;
        ASSERT_TRUE(session.has_force_at(tick, force_at(tick))) << tick;
        taken_for_it += session.has_force_at(tick, force_at(tick) + dvec3(0.0, 1.0, 0.0)) ? 1 : 0;
    }
    EXPECT_LE(taken_for_it, 1) << "one in 65536";
    for (std::size_t size = first_block_at(); size < packed.size(); size += 101) {
        const auto cut = parse_session(packed.substr(0, size), "s.onggi");
        ASSERT_TRUE(cut) << cut.error().message;
        ASSERT_FALSE(cut->is_complete());
        ASSERT_EQ(cut->tick_count() % 1000, cut->tick_count() > 4000 ? 321U : 0U);
    }
}

TEST(StudioSession, KeepsAHandThatLetsGoWhereItIs) {
    const test::TemporaryFolder folder;
    auto writer = SessionWriter::create(folder / "s.onggi", studio_header(), {});
    ASSERT_TRUE(writer);
    const auto finger_at = [](std::uint64_t tick) {
        return tool::ToolState{
            .position_mm = {50.0, 20.0, 0.0}, .guided = tick % 7 < 4, .pressing = tick % 5 < 3 || tick > 800};
    };
    for (std::uint64_t tick = 0; tick < 1000; ++tick)
        ASSERT_TRUE(writer->add_tick(finger_at(tick), dvec3(0.0)));
    ASSERT_TRUE(writer->prepare(0));
    ASSERT_TRUE(writer->commit());
    const Session session = session_of(test::content_of(folder / "s.onggi"));
    SessionCursor cursor(session);
    for (std::uint64_t tick = 0; tick < 1000; ++tick)
        ASSERT_EQ(cursor.at(tick), finger_at(tick)) << tick;
}

TEST(StudioSession, TakesLittleForHandsThatRest) {
    EXPECT_LT(studio_session_bytes(250).size(), first_block_at() + 250 * 5 + 300);
}

TEST(SessionWriter, RejectsAToolThatThePapersClayCannotHear) {
    const TemporaryFolder folder;
    auto writer = SessionWriter::create(folder / "s.onggi", test_header(), {});
    ASSERT_TRUE(writer);
    EXPECT_FALSE(writer->add_tick({.tool = tool::Tool::kSponge}, dvec3(0.0)));
    EXPECT_FALSE(writer->add_tick({.wheel_speed_rev_min = 100.0}, dvec3(0.0)));
    EXPECT_FALSE(writer->add_tick({.guided = true}, dvec3(0.0)));
    EXPECT_FALSE(writer->add_tick({.pressing = false}, dvec3(0.0)));
    EXPECT_TRUE(writer->add_tick({}, dvec3(0.0)));
}

TEST(SessionWriter, RejectsInputThatTheReaderWouldReject) {
    const TemporaryFolder folder;
    const auto refused = [&](SessionHeader header) {
        return !SessionWriter::create(folder / "s.onggi", header, {});
    };
    EXPECT_TRUE(refused({.rate_hz = 99.0}));
    EXPECT_TRUE(refused({.rate_hz = 10001.0}));
    EXPECT_TRUE(refused({.rate_hz = std::nan("")}));
    EXPECT_TRUE(refused({.element_count = 0}));
    EXPECT_TRUE(refused({.element_count = kMaxElements + 1}));
    EXPECT_TRUE(refused({.sector_count = 0}));
    EXPECT_TRUE(refused({.sector_count = kMaxSectors + 1}));

    auto writer = SessionWriter::create(folder / "s.onggi", test_header(), {});
    ASSERT_TRUE(writer);
    EXPECT_FALSE(writer->add_tick({.position_mm = {std::nan(""), 0, 0}}, dvec3(0.0)));
    EXPECT_FALSE(writer->add_tick({.position_mm = {std::nan(""), 0, 0}, .guided = true, .pressing = false},
                                  dvec3(0.0)));
    EXPECT_FALSE(writer->add_tick({.position_mm = {0, 1000.5, 0}}, dvec3(0.0)));
    EXPECT_FALSE(writer->add_tick({.radius_mm = 1.0}, dvec3(0.0)));
    EXPECT_TRUE(writer->add_tick({}, dvec3(0.0)));
    EXPECT_EQ(writer->tick_count(), 1U);
}

TEST(SessionWriter, LeavesItsWholeBlocksWhereTheRecordingIsLeft) {
    const test::TemporaryFolder folder;
    {
        auto writer = SessionWriter::create(folder / "s.onggi", test_header(), bytes_of(kStartState),
                                            files::Beside::kNamed);
        ASSERT_TRUE(writer) << writer.error().message;
        ASSERT_TRUE(record_ticks(*writer, 2345));
        ASSERT_TRUE(writer->leave());
    }
    EXPECT_EQ(folder.names(), std::vector<std::string>{"s.onggi.part"});
    const auto session = parse_session(test::content_of(folder / "s.onggi.part"), "s.onggi");
    ASSERT_TRUE(session) << session.error().message;
    EXPECT_FALSE(session->is_complete());
    EXPECT_EQ(session->tick_count(), 2000U);
}

}  // namespace
}  // namespace onggi::record
