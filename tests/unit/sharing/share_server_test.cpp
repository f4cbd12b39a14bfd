// The server in the test's own process, on virtual time.
#include "game/app/sharing/share_server.h"

#include <gtest/gtest.h>

#include <csignal>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "game/app/sharing/listen_place.h"
#include "game/sharing/outbox.h"
#include "tests/sharing/http_client.h"
#include "tests/sharing/request_heads.h"
#include "tests/support/shared_pot_samples.h"
#include "tests/support/temporary_folder.h"

namespace onggi::app {
namespace {

class ShareServerAtWork : public testing::Test {
  protected:
    void SetUp() override {
        std::signal(SIGPIPE, SIG_IGN);
        auto outbox =
            sharing::Outbox::open({.folder = folder_ / "box", .languages = support::three_languages()});
        ASSERT_TRUE(outbox) << outbox.error().message;
        const auto code = outbox->put(support::full_pot("one"), {.now_s = 1000, .expires_s = 2000});
        ASSERT_TRUE(code) << code.error().message;
        code_ = code->text();
        const auto listening = listen_at("127.0.0.1", 0);
        ASSERT_TRUE(listening) << listening.error().message;
        port_ = port_of(*listening);
        auto server = ShareServer::start({.listening_socket = *listening,
                                          .outbox = folder_ / "box",
                                          .counter = {},
                                          .now_s = [this] { return now_s_; },
                                          .wall_s = [this] { return wall_s_; }});
        ASSERT_TRUE(server) << server.error().message;
        server_ = std::move(server).value();
    }

    // A round waits for at most 20 ms, and not at all where there is something to do.
    void turn(int rounds = 6) {
        for (int i = 0; i < rounds; ++i)
            server_->run(20);
    }
    int status_of(const std::string& request, int rounds = 6) {
        test::HttpClient client(port_, 500);
        client.say(request);
        turn(rounds);
        return client.answer().status;
    }
    std::string page() const { return "GET /" + code_ + "/ HTTP/1.1\r\nHost: pots\r\n\r\n"; }

    test::TemporaryFolder folder_;
    std::string code_;
    int port_ = 0;
    double now_s_ = 100.0;
    std::int64_t wall_s_ = 1500;
    std::unique_ptr<ShareServer> server_;
};

TEST_F(ShareServerAtWork, AnswersAndForgets) {
    EXPECT_EQ(status_of(page()), 200);
    EXPECT_EQ(status_of("POST / HTTP/1.1\r\nHost: pots\r\nContent-Length: 3\r\n\r\nabc"), 405);
    EXPECT_EQ(status_of("GET /?code=" + code_ + " HTTP/1.1\r\nHost: pots\r\n\r\n"), 303);
    EXPECT_EQ(status_of("GET /7777ZZZZ/ HTTP/1.1\r\nHost: pots\r\n\r\n"), 404);
    EXPECT_EQ(status_of("GET /" + std::string(3000, 'a') + " HTTP/1.1\r\nHost: pots\r\n\r\n"), 414);
    EXPECT_EQ(status_of("GET /" + std::string(20'000, 'a') + " HTTP/1.1\r\nHost: pots\r\n\r\n"), 414);
    wall_s_ = 2000;
    EXPECT_EQ(status_of(page()), 404) << "its time is over";
    now_s_ += 11.0;
    turn(20);
    EXPECT_EQ(server_->connections(), 0U);
}

TEST_F(ShareServerAtWork, ClosesSilentSlowAndGoneConnections) {
    test::HttpClient silent(port_, 200);
    silent.say("G");  // the kernel holds a connection back until its first byte
    test::HttpClient slow(port_, 200);
    slow.say("GET /" + code_ + "/ HT");
    {
        test::HttpClient away(port_, 200);
        away.say("GET /" + code_ + "/pot.glb HTTP/1.1\r\nHost: pots\r\n\r\n");
    }
    turn();
    now_s_ += 9.0;
    slow.say("TP/1.1\r\nX");
    turn();
    EXPECT_EQ(server_->connections(), 2U);
    now_s_ += 1.5;
    turn();
    EXPECT_EQ(server_->connections(), 0U) << "what it said in between gains it nothing";
    bool closed = false;
    EXPECT_EQ(silent.rest(&closed), "");
    EXPECT_TRUE(closed);
    EXPECT_EQ(status_of(page()), 200);
}

// Each from an address of its own: more than the server takes.
TEST_F(ShareServerAtWork, MakesRoomInACrowdAndCutsItOffAfterASecond) {
    std::vector<test::HttpClient> crowd;
    constexpr std::uint32_t kFirstAddress = 0x7f010101;
    for (std::uint32_t i = 0; i < 600; ++i) {
        crowd.emplace_back(port_, 500, kFirstAddress + 256 * i);
        ASSERT_TRUE(crowd.back().is_open()) << i;
        crowd.back().say("G");
        turn(2);
    }
    const std::size_t held = server_->connections();
    EXPECT_GE(held, 440U);
    EXPECT_LE(held, 450U) << "newcomers have replaced the oldest";
    EXPECT_EQ(status_of(page()), 200);
    now_s_ += 0.9;
    turn();
    EXPECT_GE(server_->connections(), 440U);
    now_s_ += 0.5;
    turn(20);
    EXPECT_EQ(server_->connections(), 0U) << "ten seconds of silence are for who has room";
    EXPECT_EQ(status_of(page()), 200);
}

TEST_F(ShareServerAtWork, TellsAGuessingClientToWait) {
    std::map<int, int> answers;
    for (int i = 0; i < 120; ++i)
        ++answers[status_of("GET /7777ZZZZ/ HTTP/1.1\r\nHost: pots\r\n\r\n", 2)];
    // A request takes one token and a miss fifteen more, of 400.
    EXPECT_EQ(answers, (std::map<int, int>{{404, 25}, {429, 95}}));
    now_s_ += 1.0;
    EXPECT_EQ(status_of(page()), 200);
}

TEST_F(ShareServerAtWork, RefusesInOneAnswerWhatTheStandardWantsRefused) {
    for (const test::HeadCase& one : test::refused_heads()) {
        now_s_ += 1.0;  // no limit of requests
        const std::string expected = "HTTP/1.1 " + std::to_string(one.status) + " ";
        const std::size_t middle = one.bytes.size() / 2;
        test::HttpClient whole(port_, 500);
        whole.say(one.bytes);
        test::HttpClient split(port_, 500);
        split.say(one.bytes.substr(0, middle));
        test::HttpClient second(port_, 500);
        second.say(page());
        turn(2);
        EXPECT_EQ(second.answer().status, 200);
        split.say(one.bytes.substr(middle));
        second.say(one.bytes);
        turn(2);
        for (test::HttpClient* const client : {&whole, &split, &second}) {
            bool closed = false;
            const std::string said = client->rest(&closed);
            EXPECT_TRUE(said.starts_with(expected)) << one.section << "\n" << said;
            EXPECT_NE(said.find("Connection: close\r\n"), std::string::npos) << one.section;
            EXPECT_EQ(said.find("HTTP/1.1", 1), std::string::npos) << one.section << "\n" << said;
            EXPECT_TRUE(closed) << one.section;
        }
    }
    turn(20);
    EXPECT_EQ(server_->connections(), 0U);
}

// The gate lets such a head pass; the library has no memory for the fields (RFC 9110, 5.4; RFC 6585, 5).
TEST_F(ShareServerAtWork, RefusesMoreShortFieldsThanItsMemoryHolds) {
    std::string head = "GET / HTTP/1.1\r\nHost: pots\r\n";
    while (head.size() < 2000)
        head += "X: y\r\n";
    test::HttpClient client(port_, 500);
    client.say(head + "\r\n");
    turn(2);
    bool closed = false;
    EXPECT_TRUE(client.rest(&closed).starts_with("HTTP/1.1 431 "));
    EXPECT_TRUE(closed);
}

TEST_F(ShareServerAtWork, AnswersWhatIsUnusualAndAllowed) {
    const std::string_view spaces = "3: two spaces before the target";
    for (const test::HeadCase& one : test::answered_heads()) {
        int status = status_of(one.bytes);
        // A server may answer such a line by sending the client to the right target (RFC 9112, 3);
        // libmicrohttpd 1.0 does.
        if (one.section == spaces && status == 301) status = one.status;
        EXPECT_EQ(status, one.status) << one.section;
    }
}

// Sent ahead: each is answered in its turn, and what follows a bad one is not.
TEST_F(ShareServerAtWork, AnswersRequestsThatAreSentAheadUpToABadOne) {
    test::HttpClient client(port_, 500);
    client.say(page() + page());
    turn();
    EXPECT_EQ(client.answer().status, 200);
    EXPECT_EQ(client.answer().status, 200);
    client.say(page() + "GET / HTTP/1.1\r\n\r\n" + page());
    turn();
    EXPECT_EQ(client.answer().status, 200);
    bool closed = false;
    EXPECT_EQ(client.rest(&closed).find("200"), std::string::npos);
    EXPECT_TRUE(closed);
}

TEST_F(ShareServerAtWork, HearsARefusedClientUntilItCloses) {
    test::HttpClient client(port_, 500);
    client.say("GET / HTTP/1.1\r\n\r\n");
    turn();
    EXPECT_EQ(server_->connections(), 1U);
    EXPECT_TRUE(client.say(std::string(100'000, 'x'))) << "no reset that would lose the refusal";
    turn();
    EXPECT_EQ(client.answer().status, 400);
    now_s_ += 2.1;
    turn();
    EXPECT_EQ(server_->connections(), 0U);
}

TEST_F(ShareServerAtWork, GivesASecondAnswerOnTheSameConnection) {
    test::HttpClient client(port_, 500);
    for (int i = 0; i < 5; ++i) {
        client.say(page());
        turn(3);
        EXPECT_EQ(client.answer().status, 200);
        now_s_ += 8.0;
    }
}

TEST_F(ShareServerAtWork, EndsWhileClientsAreThere) {
    test::HttpClient waiting(port_, 500);
    waiting.say("G");
    test::HttpClient halfway(port_, 500);
    halfway.say("GET /" + code_);
    turn();
    server_.reset();
    bool closed = false;
    static_cast<void>(waiting.rest(&closed));
    EXPECT_TRUE(closed);
}

}  // namespace
}  // namespace onggi::app
