// Whether the Inverse service is found, and why not.
#include "engine/haptics/haply/service_probe.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <vector>

#include "tests/support/held_port.h"
#include "tests/unit/haply/fake_service.h"

namespace onggi::haptics::haply {
namespace {

using testing::FakeService;

TEST(FindService, FindsOneThatListens) {
    const FakeService service;
    const auto found = find_service({.port = service.port()});
    EXPECT_TRUE(found) << found.error().message;
}

TEST(FindService, ReportsThatNothingListens) {
    const test::HeldPort port;
    const auto found = find_service({.port = port.number()});
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().kind, ErrorKind::kSystemLacks);
    EXPECT_EQ(found.error().message, fmt::format("nothing listens at 127.0.0.1:{}", port.number()));
}

TEST(FindService, TimesOutWithoutAnAnswer) {
    // A queue of waiting connections that is full: the kernel lets the next one wait.
    const int listening = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    ASSERT_EQ(::bind(listening, reinterpret_cast<sockaddr*>(&address), size), 0);
    ASSERT_EQ(::listen(listening, 0), 0);
    ASSERT_EQ(::getsockname(listening, reinterpret_cast<sockaddr*>(&address), &size), 0);
    std::vector<int> waiting;
    for (int count = 0; count < 4; ++count) {
        waiting.push_back(::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK, 0));
        (void)::connect(waiting.back(), reinterpret_cast<sockaddr*>(&address), size);
    }
    const int port = ntohs(address.sin_port);
    const auto began = std::chrono::steady_clock::now();
    const auto found = find_service({.port = port}, 50);
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().message, fmt::format("no answer from 127.0.0.1:{} within 50 ms", port));
    EXPECT_GE(std::chrono::steady_clock::now() - began, std::chrono::milliseconds(45));
    for (const int socket : waiting)
        ::close(socket);
    ::close(listening);
}

TEST(FindService, RejectsAnInvalidAddress) {
    const auto found = find_service({.host = "not here"});
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().message, "not here:10001: expected an IPv4 address");
}

}  // namespace
}  // namespace onggi::haptics::haply
