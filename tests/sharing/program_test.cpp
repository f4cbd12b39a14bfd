// `onggi share` as a program: refusals, access to files, and its end.
#include <gtest/gtest.h>

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
    put_file(folder / "box/pot", "a pot");
    put_file(folder / "gallery", "private");
    put_file(folder / "counter", "");
    const std::string found = in_child([&]() -> std::string {
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
        ::execl("/bin/true", "true", nullptr);
        return said + (errno == EACCES ? "no" : "?");
    });
    if (found == "no Landlock")
        GTEST_SKIP() << "this kernel has no Landlock, as the program says when it starts";
    EXPECT_EQ(found, "yesnonononoyesnonono");
}

}  // namespace
}  // namespace onggi::test
