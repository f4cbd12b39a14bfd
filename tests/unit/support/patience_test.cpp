// How long tests wait, and the ports they hold.
#include "tests/support/patience.h"

#include <gtest/gtest.h>
#include <stdlib.h>  // NOLINT: setenv is POSIX

#include <string>

#include "tests/support/comes_true.h"
#include "tests/support/held_port.h"

namespace onggi::test {
namespace {

using namespace std::chrono_literals;

// Restores ctest's value at the end.
class Patience : public testing::Test {
  protected:
    ~Patience() override { put(before_ == nullptr ? nullptr : kept_.c_str()); }
    static void put(const char* slowness) {
        if (slowness == nullptr) {
            ::unsetenv("ONGGI_SLOWNESS");
        } else {
            ::setenv("ONGGI_SLOWNESS", slowness, 1);
        }
    }

  private:
    const char* before_ = std::getenv("ONGGI_SLOWNESS");
    const std::string kept_ = before_ == nullptr ? "" : before_;
};

TEST_F(Patience, GrowsWithTheSlownessThatWasMeasured) {
    put("2.5");
    EXPECT_EQ(slowness(), 2.5);
    EXPECT_EQ(scaled(2s), 5000ms);
    EXPECT_EQ(scaled(10ms), 25ms);
}

TEST_F(Patience, IsAtLeastThatOfTheReferenceMachine) {
    for (const char* none : {static_cast<const char*>(nullptr), "", "soon", "0.5", "-3", "nan"}) {
        put(none);
        EXPECT_EQ(slowness(), 1.0);
        EXPECT_EQ(scaled(1min), 60'000ms);
    }
}

TEST_F(Patience, EndsWhenTheConditionHoldsOrTheTimeIsOver) {
    int looks = 0;
    EXPECT_TRUE(comes_true([&] { return ++looks == 3; }));
    EXPECT_FALSE(comes_true([] { return false; }, 0s));
}

int bound_socket(int port) {
    const int bound = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const int yes = 1;
    ::setsockopt(bound, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_port = htons(static_cast<std::uint16_t>(port));
    place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (::bind(bound, reinterpret_cast<const sockaddr*>(&place), sizeof place) == 0) return bound;
    ::close(bound);
    return -1;
}

TEST(HeldPort, IsListenedAtAgainAndAgainByItsNumber) {
    const HeldPort port;
    EXPECT_GT(port.number(), 0);
    for (int time = 0; time < 2; ++time) {
        const int server = bound_socket(port.number());
        ASSERT_GE(server, 0) << time;
        EXPECT_EQ(::listen(server, 1), 0) << time;
        ::close(server);
    }
}

TEST(HeldPort, IsGivenToNoOther) {
    const HeldPort one;
    const HeldPort another;
    EXPECT_NE(one.number(), another.number());
}

}  // namespace
}  // namespace onggi::test
