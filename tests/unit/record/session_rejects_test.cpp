#include <gtest/gtest.h>

#include <bit>

#include "tests/support/refusal.h"
#include "tests/unit/record/recordings.h"

namespace onggi::record {
namespace {

// The error message for these bytes.
std::string refusal(const std::string& bytes) {
    return test::refusal(parse_session(bytes, "s.onggi"));
}

// A session with a changed number and corrected checksums.
template <typename T>
std::string with_header_field(std::size_t offset, T number) {
    std::string bytes = session_bytes(1500);
    test::put_at(bytes, offset, number);
    test::mend_session_header(bytes);
    return bytes;
}

template <typename T>
std::string with_block_field(std::size_t offset, T number) {
    std::string bytes = session_bytes(1500);
    test::put_at(bytes, first_block_at() + offset, number);
    test::mend_session_block(bytes, first_block_at());
    return bytes;
}

TEST(RejectsSession, OfAnotherKind) {
    EXPECT_EQ(refusal(""), "s.onggi: byte 0: expected the first bytes of a session, found ''");
    EXPECT_EQ(refusal("t_s,x_mm"),
              "s.onggi: byte 0: expected the first bytes of a session, found 't_s,x_mm'");
    // The effect of a text-mode copy.
    std::string bytes = session_bytes(10);
    bytes.erase(6, 1);
    EXPECT_NE(refusal(bytes).find("byte 0: expected the first bytes"), std::string::npos);
}

TEST(RejectsSession, OfTheVersionsInWhichNoHandCouldLetGo) {
    const std::string expected = "s.onggi: byte 8: expected a session of version 2.2, found 1.";
    const std::string reason = ", recorded before hands could let go: record it again";
    std::string bytes = with_header_field<std::uint16_t>(8, 1);
    EXPECT_EQ(refusal(bytes), expected + "0" + reason);
    test::put_at<std::uint16_t>(bytes, 10, 1);
    EXPECT_EQ(refusal(bytes), expected + "1" + reason) << "whatever its checksum says";
    EXPECT_FALSE(parse_session(bytes, "s.onggi", Damage::kCutThere)) << "and nothing of it can be recovered";
}

TEST(RejectsSession, OfANewerOrUnknownVersion) {
    EXPECT_EQ(refusal(with_header_field<std::uint16_t>(8, 3)),
              "s.onggi: byte 8: expected a session of version 2.2, found 3.0, written by a newer program");
    EXPECT_NE(refusal(with_header_field<std::uint16_t>(10, 3)).find("found 2.3, written by a newer program"),
              std::string::npos);
    EXPECT_NE(refusal(with_header_field<std::uint16_t>(8, 0)).find("byte 8: expected a session of version"),
              std::string::npos);
    // Even if a newer header has its checksum elsewhere.
    std::string bytes = session_bytes(10);
    test::put_at<std::uint16_t>(bytes, 8, 7);
    EXPECT_NE(refusal(bytes).find("newer program"), std::string::npos);
}

TEST(RejectsSession, WithAnInvalidSupplement) {
    const std::string good = session_bytes(1500, kSupplement);
    const std::size_t at = session_bytes(1500).size() - 40;  // where the end would be
    const auto with = [&](std::size_t field, std::uint32_t number) {
        std::string bytes = good;
        test::put_at(bytes, at + field, number);
        test::mend_session_block(bytes, at);
        return refusal(bytes);
    };
    const std::string place = "s.onggi: byte " + std::to_string(at + 4);
    EXPECT_EQ(with(4, 0), place + ": expected 1 to 1048576 bytes of supplement, found 0");
    EXPECT_EQ(with(4, 1U << 30U), place + ": expected 1 to 1048576 bytes of supplement, found 1073741824");
    EXPECT_NE(with(8, 7).find("as the number of ticks"), std::string::npos);
    EXPECT_NE(with(16, 1).find("in a supplement's field"), std::string::npos);
    EXPECT_NE(with(24, 1).find("as the supplement's hash"), std::string::npos);
    std::string bytes = good;
    bytes[at + 41] = static_cast<char>(bytes[at + 41] + 1);
    EXPECT_NE(refusal(bytes).find("of the supplement, found"), std::string::npos);
    // A second one, and one in a session of the version before.
    bytes = good;
    bytes.insert(at, good.substr(at, 40 + std::string_view(kSupplement).size()));
    EXPECT_NE(refusal(bytes).find("expected a block of ticks or the end, found 53444441"), std::string::npos);
    bytes = good;
    test::put_at<std::uint16_t>(bytes, 10, 0);
    test::mend_session_header(bytes);
    EXPECT_NE(refusal(bytes).find("expected a block of ticks or the end, found 53444441"), std::string::npos);
}

TEST(RejectsSession, WithAbsurdNumbersInItsHeader) {
    const auto expect_at = [](std::size_t offset, const std::string& bytes) {
        EXPECT_TRUE(refusal(bytes).starts_with("s.onggi: byte " + std::to_string(offset) + ": "))
            << refusal(bytes);
    };
    expect_at(12, with_header_field<std::uint32_t>(12, 71));
    for (const double rate : {0.0, -1000.0, 99.9, 10000.1, 1e300})
        expect_at(16, with_header_field(16, rate));
    expect_at(16, with_header_field(16, std::bit_cast<double>(0x7ff8000000000000ULL)));
    for (const std::uint32_t count : {0U, 200001U, 0xffffffffU})
        expect_at(24, with_header_field(24, count));
    for (const std::uint32_t count : {0U, 4097U, 0xffffffffU})
        expect_at(28, with_header_field(28, count));
    expect_at(32, with_header_field<std::uint32_t>(32, 1));
    for (const std::uint32_t clay : {0U, 3U})
        expect_at(36, with_header_field(36, clay));
    for (const std::uint64_t size : {kMaxStartStateBytes + 1, ~std::uint64_t{0}}) {
        expect_at(40, with_header_field(40, size));
    }
    expect_at(60, with_header_field<std::uint32_t>(60, 999));
    expect_at(64, with_header_field<std::uint32_t>(64, 1));
}

TEST(RejectsSession, CutInItsHeaderOrStartState) {
    const std::string whole = session_bytes(1500);
    for (std::size_t size = 0; size < first_block_at(); ++size) {
        EXPECT_FALSE(parse_session(whole.substr(0, size), "s.onggi")) << size;
    }
    EXPECT_EQ(refusal(whole.substr(0, 40)),
              "s.onggi: byte 40: expected a header of 72 bytes, found the end of the file");
    EXPECT_EQ(refusal(whole.substr(0, 80)),
              "s.onggi: byte 80: expected 27 bytes of start state, found the end of the file after 8");
}

TEST(RejectsSession, WithAnyBitTurned) {
    const std::string whole = session_bytes(1300);
    for (std::size_t byte = 0; byte < whole.size(); ++byte) {
        std::string bytes = whole;
        bytes[byte] = static_cast<char>(bytes[byte] ^ (1 << (byte % 8)));
        EXPECT_NE(refusal(bytes), "accepted") << "byte " << byte;
    }
}

TEST(RejectsSession, SayingWhereTheDamageIs) {
    std::string bytes = session_bytes(1300);
    bytes[first_block_at() + 60] ^= 1;
    EXPECT_NE(
        refusal(bytes).find("byte " + std::to_string(first_block_at() + 20) + ": expected the checksum"),
        std::string::npos)
        << refusal(bytes);
    EXPECT_NE(refusal(bytes).find("of a block's body"), std::string::npos);
    bytes = session_bytes(1300);
    bytes[test::kSessionHeaderBytes] ^= 1;
    EXPECT_NE(refusal(bytes).find("byte 56: expected the checksum"), std::string::npos) << refusal(bytes);
}

TEST(RejectsSession, WithMoreAfterItsEnd) {
    const std::string whole = session_bytes(1300);
    EXPECT_EQ(refusal(whole + "x"), "s.onggi: byte " + std::to_string(whole.size()) +
                                        ": expected the end of the file, found 1 bytes more");
    EXPECT_NE(refusal(whole + whole).find("expected the end of the file"), std::string::npos);
}

TEST(RejectsSession, WithABlockThatDoesNotFit) {
    const auto expect_at = [](std::size_t field, const std::string& bytes) {
        const std::string start = "s.onggi: byte " + std::to_string(first_block_at() + field) + ": ";
        EXPECT_TRUE(refusal(bytes).starts_with(start)) << refusal(bytes);
    };
    expect_at(0, with_block_field<std::uint32_t>(0, 0x12345678));
    expect_at(4, with_block_field<std::uint32_t>(4, 0));
    expect_at(4, with_block_field<std::uint32_t>(4, 0x7fffffff));
    expect_at(8, with_block_field<std::uint64_t>(8, 1000));
    expect_at(16, with_block_field<std::uint32_t>(16, 0));
    expect_at(16, with_block_field<std::uint32_t>(16, 1001));
    expect_at(32, with_block_field<std::uint32_t>(32, 1));
    // One tick fewer than its records have.
    EXPECT_NE(refusal(with_block_field<std::uint32_t>(16, 999)), "accepted");
}

TEST(RejectsSession, WithRecordsThatMakeNoSense) {
    const std::size_t records = test::kSessionBlockHeadBytes;  // after the block's head: kind, then x
    const auto expect_found = [](const std::string& bytes, const std::string& what) {
        EXPECT_NE(refusal(bytes).find(what), std::string::npos) << refusal(bytes);
    };
    expect_found(with_block_field<std::uint8_t>(records, 2), "a tool record to open the block");
    for (const int kind : {0, 5, 6, 9})  // kind 5 is there for the studio's clay only
        expect_found(with_block_field(records + 34, static_cast<std::uint8_t>(kind)), "a record's kind");
    expect_found(with_block_field(records + 1, 1000.5), "a coordinate of -1000 to 1000 mm, found 1000.5");
    expect_found(with_block_field(records + 9, std::bit_cast<double>(0x7ff8000000000000ULL)), "a coordinate");
    expect_found(with_block_field(records + 25, 41.0), "a tool radius of 2 to 40 mm, found 41");
    expect_found(with_block_field<std::uint8_t>(records + 33, 2), "a button of 0 or 1, found 2");
    expect_found(with_block_field<std::uint16_t>(records + 35, 0), "at least one repeat");
    expect_found(with_block_field<std::uint16_t>(records + 35, 0xffff), "records of 1000 ticks");
}

TEST(RejectsSession, WithAnEndThatCountsOtherwise) {
    for (const std::size_t field : {4U, 8U, 16U, 20U, 24U, 32U}) {
        std::string bytes = session_bytes(1300);
        const std::size_t end = bytes.size() - test::kSessionBlockHeadBytes;
        bytes[end + field] ^= 1;
        test::mend_session_block(bytes, end);
        EXPECT_NE(refusal(bytes).find("byte " + std::to_string(end + field) + ": "), std::string::npos)
            << refusal(bytes);
    }
}

TEST(RejectsSession, WithHandsThatNoToolWouldBe) {
    const auto refused = [](std::size_t offset, auto number) {
        std::string bytes = unpacked(studio_session_bytes(700));
        // After the block's head and the record's kind: places, settings, choices.
        test::put_at(bytes, first_block_at() + test::kSessionBlockHeadBytes + 1 + offset, number);
        test::mend_session_block(bytes, first_block_at());
        return refusal(bytes);
    };
    const auto expect_found = [](const std::string& line, const std::string& what) {
        EXPECT_NE(line.find(what), std::string::npos) << line;
    };
    expect_found(refused(24, 1000.5), "a coordinate, mm, of -1000 to 1000, found 1000.5");
    expect_found(refused(48, 1.0), "a tool radius, mm of 2 to 40, found 1");
    expect_found(refused(64, 61.0), "an assist's gap, mm of 0 to 60, found 61");
    expect_found(refused(80, 301.0), "a wheel's speed, rev/min of 0 to 300, found 301");
    expect_found(refused(96, std::bit_cast<double>(0x7ff8000000000000ULL)), "water of 0 to 1, found nan");
    expect_found(refused(104, std::uint8_t{2}), "a button of 0 to 1, found 2");
    expect_found(refused(105, std::uint8_t{4}), "a tool of 0 to 3, found 4");
    expect_found(refused(107, std::uint8_t{3}), "a command of 0 to 2, found 3");
    expect_found(refused(110, std::uint8_t{2}), "being guided of 0 to 1, found 2");
    expect_found(refused(111, std::uint8_t{255}), "pressing of 0 to 1, found 255");
}

TEST(RejectsSession, OfThePapersClayWithHandsItCannotHear) {
    std::string bytes = unpacked(studio_session_bytes(700));
    test::put_at<std::uint32_t>(bytes, 36, 1);
    test::mend_session_header(bytes);
    EXPECT_NE(refusal(bytes).find("a tool record to open the block"), std::string::npos) << refusal(bytes);
}

TEST(RejectsSession, WithABlockThatIsNotPackedSo) {
    const std::string whole = studio_session_bytes(1700);
    const std::size_t body_at = first_block_at() + test::kSessionBlockHeadBytes;
    const auto refused = [&](const auto& change) {
        std::string bytes = whole;
        change(bytes);
        test::mend_session_block(bytes, first_block_at());
        return refusal(bytes);
    };
    const auto packed_bytes = test::get_at<std::uint32_t>(whole, first_block_at() + 32);
    const auto record_bytes = test::get_at<std::uint32_t>(whole, first_block_at() + 4);
    for (const std::string& line :
         {refused([&](std::string& bytes) { bytes[body_at] ^= 0x55; }),
          refused([&](std::string& bytes) { bytes[body_at + packed_bytes / 2] ^= 1; }),
          refused([&](std::string& bytes) { test::put_at(bytes, first_block_at() + 4, record_bytes - 8); }),
          refused([&](std::string& bytes) { test::put_at(bytes, first_block_at() + 4, record_bytes + 8); })})
        EXPECT_NE(line.find(" bytes of packed records, found other bytes"), std::string::npos) << line;
    EXPECT_NE(refused([&](std::string& bytes) {
                  test::put_at(bytes, first_block_at() + 32, 0U);
              }).find("1 to 226000 packed bytes, found 0"),
              std::string::npos);
    std::string earlier = whole;
    test::put_at<std::uint16_t>(earlier, 10, 1);
    test::mend_session_header(earlier);
    EXPECT_NE(refusal(earlier).find("a block of ticks or the end"), std::string::npos) << refusal(earlier);
}

TEST(RejectsSession, WithABlockAfterOneThatIsNotFull) {
    const std::string whole = session_bytes(500);
    const std::string block =
        whole.substr(first_block_at(), whole.size() - first_block_at() - test::kSessionBlockHeadBytes);
    std::string bytes = whole.substr(0, whole.size() - test::kSessionBlockHeadBytes) + block;
    test::put_at<std::uint64_t>(bytes, first_block_at() + block.size() + 8, 500);
    test::mend_session_block(bytes, first_block_at() + block.size());
    EXPECT_NE(refusal(bytes).find("expected the end after a block that is not full"), std::string::npos)
        << refusal(bytes);
}

// After a power cut there is no better copy.
TEST(CutsASession, WhereItIsDamagedIfThatIsAskedFor) {
    const std::string whole = session_bytes(3300);
    const auto read = parse_session(whole, "s.onggi");
    ASSERT_TRUE(read);
    for (std::size_t byte = first_block_at(); byte < whole.size(); byte += 37) {
        std::string bytes = whole;
        bytes[byte] ^= 4;
        const auto cut = parse_session(bytes, "s.onggi", Damage::kCutThere);
        ASSERT_TRUE(cut) << "byte " << byte;
        std::size_t blocks = 0;
        while (blocks < read->blocks().size() &&
               read->blocks()[blocks].checks_at + read->blocks()[blocks].tick_count * 4 <= byte)
            ++blocks;
        ASSERT_EQ(cut->blocks().size(), blocks) << "byte " << byte;
        EXPECT_FALSE(cut->is_complete());
        EXPECT_NE(cut->damage().find("s.onggi: byte "), std::string::npos) << cut->damage();
    }
    EXPECT_TRUE(parse_session(whole, "s.onggi", Damage::kCutThere)->damage().empty());
    for (std::size_t byte = 0; byte < first_block_at(); byte += 5) {
        std::string bytes = whole;
        bytes[byte] ^= 4;
        EXPECT_FALSE(parse_session(bytes, "s.onggi", Damage::kCutThere)) << "without its start it is nothing";
    }
}

}  // namespace
}  // namespace onggi::record
