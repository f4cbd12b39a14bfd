// Hostile clients get a refusal or no answer, while an honest phone still gets its pot.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <list>
#include <random>
#include <string>

#include "tests/sharing/http_client.h"
#include "tests/sharing/served_outbox.h"

namespace onggi::test {
namespace {

double now_s() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(now).count();
}

long resident_kb(int process) {
    std::ifstream status("/proc/" + std::to_string(process) + "/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmRSS:")) return std::stol(line.substr(6));
    return 0;
}

// Checks that the server still answers. All clients have one address here, so a crowd that has just left may
// block it for a moment: the phone asks again.
void expect_honest(ServedOutbox& served, const std::string& code) {
    HttpAnswer page;
    comes_true([&] { return (page = get(served.port(), "/" + code + "/pot.3mf")).status == 200; });
    EXPECT_EQ(page.status, 200);
    EXPECT_EQ(page.body, content_of(served.box() / code / "pot.3mf"));
}

class HostileClients : public testing::Test {
  protected:
    ServedOutbox served_;
    const std::string code_ = served_.put(support::full_pot("one"));
};

TEST_F(HostileClients, GetRefusalsOrSilence) {
    const std::string head = " HTTP/1.1\r\nHost: pots\r\n";
    const std::vector<std::string> requests{
        "GET /../../../../etc/passwd" + head + "\r\n",
        "GET /%2e%2e/%2e%2e/etc/passwd" + head + "\r\n",
        "GET /..%2f..%2fetc%2fpasswd" + head + "\r\n",
        "GET /" + code_ + "/..%2f" + code_ + "%2fpot.glb" + head + "\r\n",
        "GET /" + code_ + "/%2e%2e%5cpot.glb" + head + "\r\n",
        "GET /" + code_ + "/pot.glb%00.png" + head + "\r\n",
        "GET /" + code_ + "/\xc0\xae\xc0\xae/pot.glb" + head + "\r\n",
        "GET /" + code_ + "/.kept" + head + "\r\n",
        "GET /" + code_ + "/pot.glb.gz" + head + "\r\n",
        "GET /" + code_ + ".part/" + head + "\r\n",
        "GET /" + std::string(5000, 'A') + head + "\r\n",
        "GET /" + std::string(100'000, 'A') + head + "\r\n",
        "GET * HTTP/1.1\r\nHost: pots\r\n\r\n",
        "POST /" + code_ + "/" + head + "Content-Length: 1000000000\r\n\r\nx",
        "PUT /" + code_ + "/pot.glb" + head + "Content-Length: 3\r\n\r\nbad",
        "DELETE /" + code_ + "/" + head + "\r\n",
        "CONNECT elsewhere:443" + head + "\r\n",
        "TRACE /" + head + "\r\n",
        "GET /" + code_ + "/nothing" + head + "Content-Length: 5\r\n\r\nhello",
        "GET /7777ZZZZ/" + head + "Transfer-Encoding: chunked\r\n\r\nffffffffffffffff\r\n",
        "GET /7777ZZZZ/" + head + "Content-Length: -1\r\n\r\n",
        "GET /7777ZZZZ/" + head + "Content-Length: 5\r\nContent-Length: 6\r\n\r\n",
        "GET /7777ZZZZ/" + head + "X: " + std::string(60'000, 'b') + "\r\n\r\n",
        "GET /7777ZZZZ/ HTTP/9.9\r\n\r\n",
        "GET /7777ZZZZ/\r\n\r\n",
        "GET  /7777ZZZZ/  HTTP/1.1\r\n\r\n",
        "\r\n\r\n\r\nGET /7777ZZZZ/" + head + "\r\n",
        std::string("GET /\0/ HTTP/1.1\r\n\r\n", 20),
        "\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03",  // somebody tries https
        "SSH-2.0-OpenSSH_9.2\r\n",
        "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n",
    };
    std::string bomb = "GET /7777ZZZZ/" + head;
    for (int i = 0; i < 3000; ++i)
        bomb += "X-" + std::to_string(i) + ": y\r\n";
    for (std::size_t i = 0; i <= requests.size(); ++i) {
        const std::string& request = i < requests.size() ? requests[i] : bomb;
        HttpClient client(served_.port(), 300);
        client.say(request);
        const std::string answer = client.rest();
        const bool is_refused = answer.starts_with("HTTP/1.1 4") || answer.starts_with("HTTP/1.0 4") ||
                                answer.starts_with("HTTP/1.1 505") || answer.empty();
        EXPECT_TRUE(is_refused) << request.substr(0, 60) << "\n" << answer.substr(0, 200);
        EXPECT_EQ(answer.find("root:"), std::string::npos);
        EXPECT_EQ(answer.find("expires "), std::string::npos);
    }
    expect_honest(served_, code_);
}

// A browser that tries https first asks again without it when it is turned away.
TEST_F(HostileClients, ThatSpeakTlsAreClosedAtOnce) {
    HttpClient client(served_.port(), 100);
    const double begun_s = now_s();
    client.say("\x16\x03\x01\x02");
    bool closed = false;
    EXPECT_TRUE(comes_true([&] {
        EXPECT_EQ(client.rest(&closed), "");
        return closed;
    }));
    EXPECT_LT(now_s() - begun_s, 5.0 * slowness()) << "a head may take ten seconds";
    expect_honest(served_, code_);
}

TEST_F(HostileClients, SendAnyBytes) {
    std::mt19937 chance(7);  // NOLINT: the same bytes each time
    for (int i = 0; i < 200; ++i) {
        std::string bytes(chance() % 3000, '\0');
        for (char& byte : bytes)
            byte = static_cast<char>(chance());
        // Half of them begin as a request does.
        if (i % 2 == 0) bytes = "GET /" + code_ + "/" + bytes;
        HttpClient client(served_.port(), 50);
        client.say(bytes + "\r\n\r\n");
        EXPECT_EQ(client.rest().find("HTTP/1.1 2"), std::string::npos);
    }
    ASSERT_TRUE(served_.server().at_work()) << served_.server().printed();
    ::usleep(1'500'000);  // misses cost many tokens
    expect_honest(served_, code_);
}

TEST_F(HostileClients, ThatAreSlowOrSilentAreCutOff) {
    const double begun = now_s();
    std::vector<HttpClient> silent;
    for (int i = 0; i < 20; ++i)
        silent.emplace_back(served_.port(), 100);
    HttpClient slow(served_.port(), 100);
    slow.say("GET /" + code_ + "/ HTTP/1.1\r\n");
    // One letter every quarter second, until the server closes the connection.
    EXPECT_TRUE(comes_true([&] {
        bool closed = false;
        slow.say("X");
        ::usleep(150'000);
        static_cast<void>(slow.rest(&closed));
        return closed;
    }));
    const double held_s = now_s() - begun;
    EXPECT_GT(held_s, 8.0);
    EXPECT_LT(held_s, 20.0 * slowness()) << "ten seconds are meant";
    for (HttpClient& client : silent) {
        EXPECT_TRUE(comes_true([&] {
            bool was_closed = false;
            EXPECT_EQ(client.rest(&was_closed), "");
            return was_closed;
        }));
    }
    expect_honest(served_, code_);
}

TEST_F(HostileClients, ThatAskTooOftenAreToldToWait) {
    std::map<int, int> answers;
    // All requests are sent before the server reads the first, so that they count as simultaneous on any
    // machine.
    served_.server().signal(SIGSTOP);
    std::vector<HttpClient> crowd;
    for (int i = 0; i < 120; ++i) {
        crowd.emplace_back(served_.port());
        ASSERT_TRUE(crowd.back().say("GET /7777ZZZZ/ HTTP/1.1\r\nHost: pots\r\n\r\n"));
    }
    served_.server().signal(SIGCONT);
    for (HttpClient& client : crowd)
        ++answers[client.answer().status];
    crowd.clear();
    EXPECT_GT(answers[429], 10) << "guesses are dear";
    EXPECT_GT(answers[404], 10);
    EXPECT_EQ(answers[404] + answers[429], 120);
    ::usleep(1'000'000);
    expect_honest(served_, code_);
}

// Each from an address of its own, so that no limit of an address holds them: more than the server takes.
// share_server_test.cpp tests how soon they are closed, on a virtual clock.
TEST_F(HostileClients, ThatAreManyAndSilentMakeRoomForAnHonestOne) {
    std::vector<HttpClient> crowd;
    for (std::uint32_t i = 0; i < 700; ++i)
        crowd.emplace_back(served_.port(), 100, 0x7f010101 + i * 256);
    expect_honest(served_, code_);
}

// The most connections of one address, each with a header that never ends, opened again when one is closed.
TEST_F(HostileClients, WithManyOpenHeadersDoNotShutOutOthersOfTheirAddress) {
    std::list<HttpClient> open_heads;
    const auto hold = [&] {
        open_heads.remove_if([](HttpClient& client) {
            bool closed = false;
            static_cast<void>(client.rest(&closed));
            return closed;
        });
        while (open_heads.size() < 128) {
            open_heads.emplace_back(served_.port(), 1);
            static_cast<void>(open_heads.back().say("GET /" + code_ + "/ HTTP/1.1\r\nX: y\r\n"));
        }
    };
    int served = 0;
    for (int phone = 0; phone < 18; ++phone) {
        hold();
        served += get(served_.port(), "/" + code_ + "/pot.3mf").status == 200 ? 1 : 0;
    }
    EXPECT_GE(served, 17);
}

// More connections than one address may have. When the server looks, each has sent part of a request and
// closed.
TEST_F(HostileClients, ThatLeaveBeforeTheyAreHeardAreNotInTheWay) {
    expect_honest(served_, code_);
    served_.server().signal(SIGSTOP);
    for (int i = 0; i < 200; ++i) {
        const HttpClient hasty(served_.port(), 1000);
        ASSERT_TRUE(hasty.is_open() && hasty.say("GET /" + code_ + "/ HTTP/1.1\r\n")) << i;
    }
    served_.server().signal(SIGCONT);
    expect_honest(served_, code_);
}

// As many as the system lets one process open; the report of the suite says how many that were.
TEST_F(HostileClients, ThatComeInThousandsTakeLittleMemoryAndGoAgain) {
    expect_honest(served_, code_);
    const long before_kb = resident_kb(served_.server().process());
    rlimit limit{};
    ::getrlimit(RLIMIT_NOFILE, &limit);
    limit.rlim_cur = limit.rlim_max;
    ::setrlimit(RLIMIT_NOFILE, &limit);
    const std::size_t wanted = std::min<std::size_t>(10'000, limit.rlim_cur - 100);
    long most_kb = 0;
    {
        std::vector<HttpClient> crowd;
        for (std::size_t i = 0; i < wanted; ++i) {
            crowd.emplace_back(served_.port(), 100);
            if (crowd.back().is_open()) crowd.back().say("GET /" + code_ + "/ HTTP/1.1\r\nX: y\r\n");
            if (i % 500 == 0) most_kb = std::max(most_kb, resident_kb(served_.server().process()));
        }
        most_kb = std::max(most_kb, resident_kb(served_.server().process()));
        ASSERT_TRUE(served_.server().at_work()) << served_.server().printed();
    }
    RecordProperty("connections", static_cast<int>(wanted));
    RecordProperty("most_memory_kb", static_cast<int>(most_kb));
    std::printf("%zu connections: %ld kB, %ld kB before\n", wanted, most_kb, before_kb);
    EXPECT_TRUE(is_sanitized() || most_kb - before_kb < 20'000) << most_kb;
    expect_honest(served_, code_);
}

}  // namespace
}  // namespace onggi::test
