// `onggi share` as a program: refusals, access to files, and its end.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/landlock.h>
#include <sys/syscall.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>

#include "game/app/sharing/confinement.h"
#include "game/app/sharing/listen_place.h"
#include "tests/sharing/http_client.h"
#include "tests/sharing/served_outbox.h"
#include "tests/support/held_port.h"
#include "tests/support/hostile_system.h"

namespace onggi::test {
namespace {

TEST(ShareProgram, RefusesInvalidOptionsInOneLine) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "box");
    const std::string box = (folder / "box").string();
    const auto taken = app::listen_at("127.0.0.1", 0);
    ASSERT_TRUE(taken);
    const std::string port = std::to_string(app::port_of(*taken));
    put_file(folder / "off.toml", "[sharing]\nport = 8080\n");
    put_file(folder / "wrong.toml", "[sharing]\nport = 0\n");
    const struct {
        std::vector<std::string> words;
        int exit_code;
        std::string line;
    } kCases[] = {
        {{}, 2, "onggi: onggi share: expected --config, or --outbox and --listen, found neither\n"},
        {{"--outbox", folder / "off.toml", "--listen", "127.0.0.1"},
         2,
         "onggi: " + (folder / "off.toml").string() +
             ": expected a folder of shared pots, found something else\n"},
        {{"--outbox", box, "--listen", "127.0.0.1", "--port", port},
         3,
         "onggi: sharing: expected to listen at 127.0.0.1, port " + port +
             ", found: Address already in use\n"},
        {{"--outbox", box, "--listen", "192.0.2.7"},
         3,
         "onggi: sharing: expected to listen at 192.0.2.7, port 8080, found: Cannot assign requested "
         "address\n"},
        {{"--outbox", box, "--listen", "wlan77"},
         2,
         "onggi: sharing: expected an address or an interface of this machine, found 'wlan77'\n"},
        {{"--config", folder / "off.toml"},
         0,
         "onggi: sharing is off: " + (folder / "off.toml").string() + " names no address to listen at\n"},
        {{"--config", folder / "wrong.toml"},
         2,
         "onggi: " + (folder / "wrong.toml").string() +
             ", line 2: expected a whole number, 1 to 65535 for port, found 0\n"},
    };
    for (const auto& one : kCases) {
        std::vector<std::string> words{"share"};
        words.insert(words.end(), one.words.begin(), one.words.end());
        const ProgramRun run = run_onggi(words);
        EXPECT_EQ(run.exit_code, one.exit_code) << run.err;
        EXPECT_EQ(run.err, one.line);
        EXPECT_EQ(run.out, "");
    }
}

TEST(ShareProgram, WaitsForTheFolderThatTheKioskMakes) {
    const TemporaryFolder folder;
    const std::string box = (folder / "box").string();
    RunningOnggi server({"share", "--outbox", box, "--listen", "127.0.0.1", "--port", "0"});
    EXPECT_TRUE(
        comes_true([&] { return server.printed().find("waiting for the folder") != std::string::npos; }));
    std::filesystem::create_directory(box);
    EXPECT_EQ(get(port_said_by(server), "/").status, 200);
    RunningOnggi impatient({"share", "--outbox", box + "2", "--listen", "127.0.0.1", "--port", "0"});
    EXPECT_TRUE(
        comes_true([&] { return impatient.printed().find("waiting for the folder") != std::string::npos; }));
    impatient.signal(SIGTERM);
    EXPECT_EQ(impatient.exit_code(), 0);
}

// A server that waited for its clients would never end here.
TEST(ShareProgram, EndsWhenAskedAlthoughAClientGoesOnAsking) {
    ServedOutbox served;
    const HttpClient waiting(served.port());
    HttpClient asking(served.port());
    served.server().signal(SIGTERM);
    EXPECT_TRUE(comes_true([&] {
        if (asking.say("GET / HTTP/1.1\r\nHost: pots\r\n\r\n")) static_cast<void>(asking.answer());
        return !served.server().at_work();
    }));
    EXPECT_EQ(served.server().exit_code(), 0);
}

TEST(ShareProgram, ReadsTheSettingsAndForgetsThem) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "box");
    const HeldPort port;
    put_file(folder / "kiosk.toml", "[sharing]\nlisten = \"lo\"\nport = " + std::to_string(port.number()) +
                                        "\noutbox = \"" + (folder / "box").string() +
                                        "\"\n[staff]\npin = \"48151623\"\n");
    RunningOnggi server({"share", "--config", (folder / "kiosk.toml").string()});
    ASSERT_EQ(port_said_by(server), port.number());
    ASSERT_EQ(get(port.number(), "/").status, 200) << server.printed();
    // No writable page of its memory contains them.
    const std::string process = "/proc/" + std::to_string(server.process());
    std::ifstream maps(process + "/maps");
    std::ifstream memory(process + "/mem", std::ios::binary);
    std::size_t looked = 0;
    for (std::string line; std::getline(maps, line);) {
        if (line.find(" rw") == std::string::npos) continue;
        const std::size_t from = std::stoull(line, nullptr, 16);
        const std::size_t to = std::stoull(line.substr(line.find('-') + 1), nullptr, 16);
        constexpr std::size_t kMostBytes = 1'000'000'000;  // beyond is what a sanitizer keeps for itself
        if (to - from > kMostBytes) continue;
        std::string bytes(to - from, '\0');
        memory.clear();
        memory.seekg(static_cast<std::streamoff>(from));
        memory.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        looked += static_cast<std::size_t>(memory.gcount());
        EXPECT_EQ(bytes.find("48151623"), std::string::npos) << line;
    }
    EXPECT_GT(looked, 100'000U);
}

TEST(ShareProgram, CanReachOnlyTheOutbox) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "box");
    std::filesystem::create_directory(folder / "box/inner");
    put_file(folder / "box/pot", "a pot");
    put_file(folder / "gallery", "private");
    put_file(folder / "counter", "");
    const auto listening = app::listen_at("127.0.0.1", 0);
    ASSERT_TRUE(listening);
    const int port = app::port_of(*listening);
    const std::string found = in_child([&]() -> std::string {
        const int version = static_cast<int>(
            ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION));
        const auto confined = app::confine_to(folder / "box", folder / "counter");
        if (!confined) return confined.error().message;
        if (!*confined) return "no Landlock";
        const auto opens = [](const std::filesystem::path& file, int how) {
            const int descriptor = ::open(file.c_str(), how, 0600);
            return descriptor >= 0 ? "yes" : errno == EACCES ? "no" : "?";
        };
        std::string said = std::string(opens(folder / "box/pot", O_RDONLY)) +
                           opens(folder / "gallery", O_RDONLY) + opens("/etc/passwd", O_RDONLY) +
                           opens(folder / "box/pot", O_WRONLY) +
                           opens(folder / "box/new", O_WRONLY | O_CREAT) +
                           opens(folder / "counter", O_WRONLY) + opens(folder / "counter", O_RDONLY);
        said += ::unlink((folder / "box/pot").c_str()) != 0 ? "no" : "yes";
        // From the versions on that know of it.
        const auto is_refused = [&](int since, bool fails, int error) {
            return version < since || (fails && errno == error) ? "no" : "yes";
        };
        said += is_refused(2, ::rename((folder / "box/pot").c_str(), (folder / "box/inner/pot").c_str()) != 0,
                           EACCES);
        said += is_refused(3, ::truncate((folder / "box/pot").c_str(), 0) != 0, EACCES);
        said += is_refused(4, !app::answers_at("127.0.0.1", port, 1000), EACCES);
        said += is_refused(4, !app::listen_at("127.0.0.1", 0), EACCES);
        said += is_refused(6, ::kill(::getppid(), 0) != 0, EPERM);
        ::execl("/bin/true", "true", nullptr);
        return said + (errno == EACCES ? "no" : "?");
    });
    if (found == "no Landlock")
        GTEST_SKIP() << "this kernel has no Landlock, as the program says when it starts";
    EXPECT_EQ(found, "yesnonononoyesnononononononono");
}

TEST(ShareProgram, HasNoCallsButThoseOfAServer) {
#ifdef __SANITIZE_THREAD__
    GTEST_SKIP() << "the thread sanitizer ends a process whose own calls are refused";
#endif
    const TemporaryFolder folder;
    put_file(folder / "pot", "a pot");
    const std::string found = in_child([&]() -> std::string {
        if (!app::confine_calls()) return "no filter";
        const auto is_refused = [](long result) { return result == -1 && errno == EPERM ? "no" : "yes"; };
        std::string said = ::open((folder / "pot").c_str(), O_RDONLY) >= 0 ? "yes" : "no";
        said += is_refused(::socket(AF_INET, SOCK_STREAM, 0));
        said += is_refused(::socket(AF_UNIX, SOCK_STREAM, 0));
        said += is_refused(::syscall(SYS_fork));
        said += is_refused(::unlink((folder / "pot").c_str()));
        said += is_refused(::kill(::getppid(), 0));
        said += is_refused(::setuid(::getuid()));
        said += is_refused(::execl("/bin/true", "true", nullptr));
        return said;
    });
    if (found == "no filter") GTEST_SKIP() << "this kernel has no filter, as the program says when it starts";
    EXPECT_EQ(found, "yesnonononononono");
}

// A line of /proc/PROCESS/status.
std::string status_line(int process, const std::string& name) {
    std::ifstream status("/proc/" + std::to_string(process) + "/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with(name + ":\t")) return line.substr(name.size() + 2);
    return "none";
}

TEST(ShareProgram, ServesConfinedAndNeverAsRoot) {
    ServedOutbox served;
    const std::string code = served.put(support::full_pot("one"));
    EXPECT_EQ(get(served.port(), "/" + code + "/").status, 200);
    const int process = served.server().process();
    EXPECT_FALSE(status_line(process, "Uid").starts_with("0\t"));
    EXPECT_EQ(status_line(process, "NoNewPrivs"), "1");
    EXPECT_EQ(status_line(process, "Seccomp"), "2") << "filtered";
    if (::geteuid() != 0) return;
    EXPECT_EQ(status_line(process, "CapPrm"), "0000000000000000");
    EXPECT_EQ(status_line(process, "CapEff"), "0000000000000000");
    EXPECT_EQ(status_line(process, "Groups").find_first_not_of(' '), std::string::npos);
    EXPECT_NE(served.server().printed().find(", as the user "), std::string::npos);
}

TEST(ShareProgram, StartedByRootRefusesAnOutboxThatItsUserMayNotOpen) {
    if (::geteuid() != 0) GTEST_SKIP() << "not root";
    const TemporaryFolder folder;
    ASSERT_EQ(::mkdir((folder / "box").c_str(), 0700), 0);
    const ProgramRun run =
        run_onggi({"share", "--outbox", folder / "box", "--listen", "127.0.0.1", "--port", "0"});
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_TRUE(
        run.err.starts_with("onggi: " + (folder / "box").string() + ": expected a folder that the user "))
        << run.err;
    EXPECT_TRUE(run.err.ends_with(" may open, found it closed\n")) << run.err;
}

// In a user namespace with nobody but root, as `unshare -r` makes one.
TEST(ShareProgram, StartedByRootWithoutAnotherUserIsRefused) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "box");
    const std::string found = in_child([&]() -> std::string {
        const uid_t user = ::getuid();
        const gid_t group = ::getgid();
        if (::unshare(CLONE_NEWUSER) != 0) return "no namespace";
        std::ofstream("/proc/self/setgroups") << "deny";
        std::ofstream("/proc/self/uid_map") << "0 " << user << " 1";
        std::ofstream("/proc/self/gid_map") << "0 " << group << " 1";
        const ProgramRun run =
            run_onggi({"share", "--outbox", folder / "box", "--listen", "127.0.0.1", "--port", "0"});
        return std::to_string(run.exit_code) + " " + run.err;
    });
    if (found == "no namespace") GTEST_SKIP() << "no user namespaces here";
    EXPECT_TRUE(
        found.starts_with("2 onggi: sharing: expected to leave root before phones are answered, "
                          "found that root cannot become "))
        << found;
    EXPECT_TRUE(found.ends_with(": Operation not permitted; start it as another user\n")) << found;
}

}  // namespace
}  // namespace onggi::test
