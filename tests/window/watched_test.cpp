// The program under a service manager's watchdog: a real window, a real datagram socket, and threads stopped
// by the kernel (ptrace), without help from the program. Runs under with_display.sh, which brings a display.
#include <gtest/gtest.h>
#include <signal.h>  // NOLINT: SIGTERM
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/cli/run_program.h"
#include "tests/support/patience.h"
#include "tests/support/temporary_folder.h"

namespace onggi {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr milliseconds kWatchdog{2000};

// Receives messages and stores them with their times.
class Manager {
  public:
    explicit Manager(const fs::path& place) : place_(place) {
        socket_ = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        std::strncpy(address.sun_path, place.c_str(), sizeof address.sun_path - 1);
        EXPECT_EQ(::bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    }
    ~Manager() { ::close(socket_); }
    Manager(const Manager&) = delete;
    Manager& operator=(const Manager&) = delete;

    [[nodiscard]] std::string variable() const { return "NOTIFY_SOCKET=" + place_.string(); }
    void listen() {
        std::array<char, 512> text{};
        for (ssize_t size = 0; (size = ::recv(socket_, text.data(), text.size(), 0)) > 0;)
            heard_.emplace_back(text.data(), static_cast<std::size_t>(size));
    }
    void listen_for(milliseconds time) {
        const auto until = Clock::now() + time;
        while (Clock::now() < until) {
            listen();
            std::this_thread::sleep_for(milliseconds(5));
        }
    }
    // Waits up to `most`, longer on a slow machine.
    bool hears(const std::string& words, long times, milliseconds most) {
        const auto until = Clock::now() + test::scaled(most);
        while (count(words) < times && Clock::now() < until)
            listen_for(milliseconds(10));
        return count(words) >= times;
    }
    [[nodiscard]] long count(const std::string& words) const {
        return std::count(heard_.begin(), heard_.end(), words);
    }
    [[nodiscard]] const std::vector<std::string>& heard() const { return heard_; }

  private:
    fs::path place_;
    int socket_ = -1;
    std::vector<std::string> heard_;
};

// Finds a thread of a process by its kernel name; the main thread's id is the process's.
int thread_named(int process, const std::string& name) {
    for (const auto& task : fs::directory_iterator("/proc/" + std::to_string(process) + "/task")) {
        std::string comm;
        std::getline(std::ifstream(task.path() / "comm"), comm);
        if (comm == name) return std::stoi(task.path().filename().string());
    }
    return -1;
}

// Stops one thread of a child, and resumes it at the end of the scope.
class Frozen {
  public:
    explicit Frozen(int thread) : thread_(thread) {
        if (::ptrace(PTRACE_SEIZE, thread_, nullptr, nullptr) != 0) return;
        if (::ptrace(PTRACE_INTERRUPT, thread_, nullptr, nullptr) != 0) return;
        int status = 0;
        holds_ = ::waitpid(thread_, &status, __WALL) == thread_ && WIFSTOPPED(status);
    }
    ~Frozen() {
        if (holds_) ::ptrace(PTRACE_DETACH, thread_, nullptr, nullptr);
    }
    Frozen(const Frozen&) = delete;
    Frozen& operator=(const Frozen&) = delete;
    [[nodiscard]] bool holds() const { return holds_; }

  private:
    int thread_;
    bool holds_ = false;
};

struct AWatchedKiosk : testing::Test {
    test::TemporaryFolder folder;
    Manager manager{folder / "notify"};
    test::RunningOnggi onggi{
        {"kiosk", "--size", "320x180", "--volume", "0", "--device", "mouse", "--gallery",
         (folder / "g").string()},
        {.folder = folder.path(), .environment = {manager.variable(), "WATCHDOG_USEC=2000000"}}};

    // A software driver under a sanitizer takes ten seconds to its first frame.
    void SetUp() override {
        ASSERT_TRUE(manager.hears("READY=1", 1, milliseconds(180'000))) << onggi.printed();
        ASSERT_TRUE(manager.hears("WATCHDOG=1", 2, milliseconds(20'000))) << onggi.printed();
    }
    void expect_silence_while(int thread) {
        ASSERT_GT(thread, 0);
        {
            const Frozen frozen(thread);
            if (!frozen.holds() && errno == EPERM)
                GTEST_SKIP() << "this system does not allow stopping a thread";
            ASSERT_TRUE(frozen.holds());
            // One ping from the previous run may still arrive.
            manager.listen_for(test::scaled(kWatchdog));
            const long before = manager.count("WATCHDOG=1");
            manager.listen_for(kWatchdog);
            EXPECT_EQ(manager.count("WATCHDOG=1"), before) << "it said that all is well";
        }
        const long before = manager.count("WATCHDOG=1");
        EXPECT_TRUE(manager.hears("WATCHDOG=1", before + 2, milliseconds(20'000))) << "it lives again";
    }
};

TEST_F(AWatchedKiosk, SaysThatItIsWellOnlyWhileThePictureMoves) {
    expect_silence_while(onggi.process());
}

TEST_F(AWatchedKiosk, SaysThatItIsWellOnlyWhileTheHandsLoopTurns) {
    expect_silence_while(thread_named(onggi.process(), "onggi-haptic"));
}

TEST_F(AWatchedKiosk, EndsWithinTwoSecondsWhenItIsAsked) {
    EXPECT_EQ(manager.count("READY=1"), 1);
    EXPECT_EQ(manager.count("STOPPING=1"), 0);
    EXPECT_EQ(manager.count("STATUS=attract; 0 pots kept since the start"), 1);
    const std::string& printed = onggi.printed();
    EXPECT_LT(std::count(printed.begin(), printed.end(), '\n'), 12) << "a flood: " << printed;
    const auto asked = Clock::now();
    onggi.signal(SIGTERM);
    onggi.signal(SIGTERM);  // as a manager that signals every process, including the supervisor
    EXPECT_EQ(onggi.exit_code(), 0) << onggi.printed();
    const std::chrono::duration<double> took = Clock::now() - asked;
    manager.listen();
    EXPECT_EQ(manager.heard().back(), "STOPPING=1");
    EXPECT_LT(took, test::scaled(milliseconds(2000)));
    EXPECT_EQ(test::content_of(folder / "g/state/starts"), "onggi starts 1\nended\n") << "no fall";
    std::printf("ended after %.2f s\n", took.count());
}

}  // namespace
}  // namespace onggi
