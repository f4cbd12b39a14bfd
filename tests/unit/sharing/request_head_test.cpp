#include "game/sharing/request_head.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "tests/sharing/request_heads.h"

namespace onggi::sharing {
namespace {

TEST(RequestHead, RejectsWhatTheStandardWantsRefused) {
    for (const test::HeadCase& one : test::refused_heads()) {
        const RequestHead head = read_head(one.bytes);
        // Targets are refused where they are answered: game/sharing/share_request.h.
        if (head.kind == RequestHead::Kind::kFine && std::string_view(one.section).starts_with("3")) continue;
        EXPECT_EQ(head.kind, RequestHead::Kind::kRefused) << one.section;
        EXPECT_EQ(head.status, one.status) << one.section;
    }
}

TEST(RequestHead, TakesWholeHeadsAndWaitsForTheRest) {
    for (const test::HeadCase& one : test::answered_heads()) {
        const RequestHead head = read_head(one.bytes);
        ASSERT_EQ(head.kind, RequestHead::Kind::kFine) << one.section;
        EXPECT_EQ(head.method, "GET") << one.section;
        EXPECT_TRUE(head.target.ends_with("/robots.txt")) << one.section;
        for (std::size_t bytes = 0; bytes < head.bytes; ++bytes)
            EXPECT_EQ(read_head(one.bytes.substr(0, bytes)).kind, RequestHead::Kind::kIncomplete)
                << one.section << bytes;
        EXPECT_EQ(read_head(one.bytes.substr(0, head.bytes) + '\0').bytes, head.bytes) << one.section;
    }
}

TEST(RequestHead, IsRefusedAtItsFirstBadLine) {
    EXPECT_EQ(read_head("SSH-2.0-OpenSSH_9.2\r\n").status, 400);
    EXPECT_EQ(read_head("GET / HTTP/1.1\r\nX : y\r\n").status, 400);
    EXPECT_EQ(read_head("GET / HTTP/1.1\r\nX: y\r").kind, RequestHead::Kind::kIncomplete);
}

TEST(RequestHead, EndsAtItsLimit) {
    const std::string line = "GET / HTTP/1.1\r\nHost: pots\r\nX: ";
    const std::string most = line + std::string(kMostHeadBytes - line.size() - 4, 'a') + "\r\n\r\n";
    EXPECT_EQ(read_head(most).kind, RequestHead::Kind::kFine);
    EXPECT_EQ(read_head(most.substr(0, most.size() - 1)).kind, RequestHead::Kind::kIncomplete);
    EXPECT_EQ(read_head("\n" + most).status, 431);
    EXPECT_EQ(read_head(std::string(kMostHeadBytes - 1, 'a')).kind, RequestHead::Kind::kIncomplete);
    EXPECT_EQ(read_head(std::string(kMostHeadBytes, 'a')).status, 414);
}

}  // namespace
}  // namespace onggi::sharing
