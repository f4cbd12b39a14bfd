// Server and writer are killed at any moment: a phone gets a whole pot or none.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <csignal>
#include <filesystem>
#include <random>
#include <set>
#include <string>

#include "game/app/sharing/page_store.h"
#include "tests/sharing/http_client.h"
#include "tests/sharing/served_outbox.h"

namespace onggi::test {
namespace {

namespace fs = std::filesystem;

// Puts and withdraws pots until it is killed.
[[noreturn]] void keep_putting(const fs::path& box) {
    auto outbox =
        sharing::Outbox::open({.folder = box, .most_pots = 6, .languages = support::three_languages()});
    if (!outbox) ::_exit(1);
    for (int i = 0;; ++i) {
        const auto code = outbox->put(support::full_pot("pot"), from_now());
        if (!code) ::_exit(2);
        if (i % 3 == 0) static_cast<void>(outbox->withdraw(*code));
    }
}

// Microseconds from the start of a process to its kill. A busy machine does little in that time: then the
// test adds rounds, and `more_rounds` extends the time.
useconds_t moment_us(unsigned least, unsigned most, std::mt19937& chance, int more_rounds) {
    const unsigned any = least + static_cast<unsigned>(chance()) % (most - least);
    return static_cast<useconds_t>(slowness() * any * (1 + more_rounds));
}

// Checks that every folder with a code as its name is a whole pot.
void expect_whole_pots(const fs::path& box, const std::set<std::string>& names) {
    for (const auto& entry : fs::directory_iterator(box)) {
        if (!sharing::ShareCode::read_exactly(entry.path().filename().string())) continue;
        std::set<std::string> found;
        for (const auto& file : fs::directory_iterator(entry.path()))
            found.insert(file.path().filename().string());
        EXPECT_EQ(found, names) << entry.path();
        EXPECT_EQ(content_of(entry.path() / "pot.3mf"), "PK\x03\x04 3MF pot");
        EXPECT_NE(content_of(entry.path() / "index.html").find("</html>"), std::string::npos);
    }
}

TEST(KilledWriter, LeavesWholePotsOnly) {
    const TemporaryFolder folder;
    std::set<std::string> names;
    {
        auto outbox =
            sharing::Outbox::open({.folder = folder / "first", .languages = support::three_languages()});
        ASSERT_TRUE(outbox);
        const auto code = outbox->put(support::full_pot("pot"), from_now());
        ASSERT_TRUE(code);
        for (const auto& file : fs::directory_iterator(folder / "first" / code->text()))
            names.insert(file.path().filename().string());
    }
    std::mt19937 chance(11);  // NOLINT: the same moments each time, as far as a machine has any
    std::set<std::string> seen;
    for (int round = 0; round < 25 || (seen.size() < 25 && round < 200); ++round) {
        const pid_t writer = ::fork();
        if (writer == 0) keep_putting(folder / "box");
        ::usleep(moment_us(20'000, 200'000, chance, round / 25));
        ::kill(writer, SIGKILL);
        int status = 0;
        ::waitpid(writer, &status, 0);
        ASSERT_TRUE(WIFSIGNALED(status)) << "it ended by itself: " << WEXITSTATUS(status);
        if (!fs::exists(folder / "box")) continue;
        expect_whole_pots(folder / "box", names);
        for (const auto& entry : fs::directory_iterator(folder / "box"))
            seen.insert(entry.path().filename().string());
    }
    EXPECT_GE(seen.size(), 25U) << "pots were put at all";
    auto outbox = sharing::Outbox::open({.folder = folder / "box", .languages = support::three_languages()});
    ASSERT_TRUE(outbox);
    for (const auto& entry : fs::directory_iterator(folder / "box"))
        EXPECT_NE(entry.path().extension(), ".part");
    EXPECT_LE(outbox->list()->size(), 7U) << "a killed writer may have had no time to make room";
}

TEST(KilledServer, ServesWholePotsAfterEveryStart) {
    const TemporaryFolder folder;
    auto outbox = sharing::Outbox::open({.folder = folder / "box", .languages = support::three_languages()});
    ASSERT_TRUE(outbox);
    const auto code = outbox->put(support::full_pot("pot"), from_now());
    ASSERT_TRUE(code);
    const std::string target = "/" + code->text() + "/pot.stl";
    const std::string whole = content_of(folder / "box" / code->text() / "pot.stl");
    std::mt19937 chance(13);  // NOLINT
    int answers = 0;
    for (int round = 0; round < 12 || (answers <= 3 && round < 120); ++round) {
        RunningOnggi server(
            {"share", "--outbox", (folder / "box").string(), "--listen", "127.0.0.1", "--port", "0"});
        const int port = port_said_by(server);
        ASSERT_NE(port, 0);
        const pid_t killer = ::fork();
        if (killer == 0) {
            ::usleep(moment_us(20'000, 100'000, chance, round / 12));
            ::kill(server.process(), SIGKILL);
            ::_exit(0);
        }
        chance.discard(1);
        for (bool alive = true; alive;) {
            HttpClient client(port);
            alive = client.is_open() && client.say("GET " + target + " HTTP/1.1\r\nHost: pots\r\n\r\n");
            const HttpAnswer answer = alive ? client.answer() : HttpAnswer{};
            alive = answer.status != 0;
            // A fast machine may exceed the limit of requests per address, which yields no pot.
            if (answer.status == 429) continue;
            // A phone detects a truncated answer by its length; the received bytes must be the pot's.
            EXPECT_TRUE(!alive || answer.headers.at("content-length") == std::to_string(whole.size()));
            EXPECT_TRUE(whole.starts_with(answer.body));
            if (answer.body == whole) ++answers;
        }
        ::waitpid(killer, nullptr, 0);
    }
    EXPECT_GT(answers, 3);
}

// A pot that is withdrawn while it is fetched, and pots that come and go: whole, or 404.
TEST(BusyOutbox, NeverShowsHalfAPot) {
    ServedOutbox served;
    const std::string stays = served.put(support::full_pot("pot"));
    const pid_t writer = ::fork();
    if (writer == 0) keep_putting(served.box());
    std::map<int, int> answers;
    std::set<std::string> codes{stays};
    const std::string expected = "PK\x03\x04 3MF pot";
    // On a busy machine every pot may be gone by the time it is asked for; then there are more rounds.
    int rounds = 0;
    for (; rounds < 150 || (answers[200] == 0 && rounds < 1500); ++rounds) {
        std::string there = stays;
        for (const auto& entry : fs::directory_iterator(served.box())) {
            const std::string name = entry.path().filename().string();
            if (!sharing::ShareCode::read_exactly(name)) continue;
            if (codes.size() < 200) codes.insert(name);
            there = name;
        }
        const std::string code =
            rounds % 2 == 0 ? *std::next(codes.begin(), rounds % static_cast<std::ptrdiff_t>(codes.size()))
                            : there;
        const HttpAnswer answer = get(served.port(), "/" + code + "/pot.3mf");
        ++answers[answer.status];
        EXPECT_TRUE(answer.status != 200 || answer.body == expected);
        ::usleep(20'000);
    }
    ::kill(writer, SIGKILL);
    ::waitpid(writer, nullptr, 0);
    EXPECT_GT(answers[200], 0);
    EXPECT_EQ(answers[200] + answers[404] + answers[429], rounds);
}

}  // namespace
}  // namespace onggi::test
