// The messages to a service manager, on a real datagram socket and a virtual clock.
#include "game/app/system/service.h"

#include <gtest/gtest.h>
#include <stdlib.h>  // NOLINT: setenv is POSIX
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <string>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace onggi::app {
namespace {

TEST(Pulse, BeatsFourTimesInTheTimeThatTheManagerWaits) {
    Pulse pulse(10.0);
    int beats = 0;
    for (std::uint64_t frame = 1; frame <= 600; ++frame)
        beats += pulse.is_due(static_cast<double>(frame) / 60.0, {frame, 4 * frame}) ? 1 : 0;
    EXPECT_EQ(beats, 4) << "in ten seconds";
}

TEST(Pulse, StopsWithThePictureAndGoesOnWithIt) {
    Pulse pulse(10.0);
    EXPECT_TRUE(pulse.is_due(0.0, {1, 1}));
    for (int second = 3; second < 60; ++second)
        EXPECT_FALSE(pulse.is_due(second, {1, static_cast<std::uint64_t>(100 * second)})) << "no frame came";
    EXPECT_TRUE(pulse.is_due(60.0, {2, 7000}));
}

TEST(Pulse, StopsWithTheHandsLoopAndGoesOnWithIt) {
    Pulse pulse(10.0);
    EXPECT_TRUE(pulse.is_due(0.0, {1, 1}));
    for (int second = 3; second < 60; ++second)
        EXPECT_FALSE(pulse.is_due(second, {static_cast<std::uint64_t>(60 * second), 1})) << "no tick came";
    EXPECT_TRUE(pulse.is_due(60.0, {7000, 2}));
}

// A manager that listens where $NOTIFY_SOCKET says: at that place, or, where it is empty, at an abstract name
// that the kernel chooses, which begins with @ in the variable.
class Manager {
  public:
    explicit Manager(std::string name) {
        socket_ = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        std::memcpy(address.sun_path, name.data(), std::min(name.size(), sizeof address.sun_path - 1));
        constexpr std::size_t kHead = offsetof(sockaddr_un, sun_path);
        auto size = static_cast<socklen_t>(kHead + name.size());
        EXPECT_EQ(::bind(socket_, reinterpret_cast<const sockaddr*>(&address), size), 0) << name;
        if (name.empty()) {
            size = sizeof address;
            EXPECT_EQ(::getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size), 0);
            name = "@" + std::string(address.sun_path + 1, size - kHead - 1);
        }
        ::setenv("NOTIFY_SOCKET", name.c_str(), 1);
    }
    ~Manager() {
        ::close(socket_);
        ::unsetenv("NOTIFY_SOCKET");
        ::unsetenv("WATCHDOG_USEC");
    }
    Manager(const Manager&) = delete;
    Manager& operator=(const Manager&) = delete;

    // A local datagram arrives as soon as it is sent.
    std::vector<std::string> heard() {
        std::vector<std::string> all;
        std::array<char, 512> text{};
        for (ssize_t size = 0; (size = ::recv(socket_, text.data(), text.size(), 0)) > 0;)
            all.emplace_back(text.data(), static_cast<std::size_t>(size));
        return all;
    }

  private:
    int socket_ = -1;
};

using Words = std::vector<std::string>;

TEST(Service, NotifiesItsManager) {
    const test::TemporaryFolder folder;
    for (const std::string& name : {folder.path().string() + "/notify", std::string()}) {
        Manager manager(name);
        ::setenv("WATCHDOG_USEC", "10000000", 1);
        Service service;
        service.say("attract");
        service.say("attract");
        EXPECT_EQ(manager.heard(), Words{"STATUS=attract"});
        service.live(0.0, {0, 7});
        service.live(0.1, {1, 0});
        EXPECT_EQ(manager.heard(), Words{}) << "neither a picture nor a loop alone is ready";
        service.live(0.2, {1, 8});
        EXPECT_EQ(manager.heard(), (Words{"READY=1", "WATCHDOG=1"}));
        service.live(0.3, {2, 9});
        EXPECT_EQ(manager.heard(), Words{});
        service.live(2.8, {3, 10});
        EXPECT_EQ(manager.heard(), Words{"WATCHDOG=1"});
        service.ends();
        EXPECT_EQ(manager.heard(), Words{"STOPPING=1"});
    }
}

TEST(Service, SendsNoPingWithoutAWatchdog) {
    const test::TemporaryFolder folder;
    Manager manager(folder.path().string() + "/notify");
    for (const char* broken : {"", "soon", "-1", "10s"}) {
        ::setenv("WATCHDOG_USEC", broken, 1);
        Service service;
        service.live(0.0, {1, 1});
        service.live(60.0, {2, 2});
        EXPECT_EQ(manager.heard(), Words{"READY=1"}) << broken;
    }
}

TEST(Service, NeedsNoManager) {
    ::unsetenv("NOTIFY_SOCKET");
    Service service;
    service.live(0.0, {1, 1});
    service.say("attract");
    service.ends();
}

}  // namespace
}  // namespace onggi::app
