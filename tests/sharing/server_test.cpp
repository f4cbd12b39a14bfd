// The answers to an honest phone.
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <span>
#include <string>

#include "game/sharing/open_counter.h"
#include "tests/sharing/http_client.h"
#include "tests/sharing/served_outbox.h"
#include "tests/support/gunzip.h"
#include "tests/support/held_port.h"

namespace onggi::test {
namespace {

std::string unpacked(const std::string& packed) {
    constexpr std::size_t kMost = std::size_t{1} << 20U;
    return gunzipped(std::as_bytes(std::span(packed)), kMost);
}

TEST(ShareServer, ServesAPotByItsCode) {
    ServedOutbox served;
    const sharing::SharedPot pot = support::full_pot("one");
    const std::string code = served.put(pot);
    const HttpAnswer page = get(served.port(), "/" + code + "/");
    EXPECT_EQ(page.status, 200);
    EXPECT_EQ(page.headers.at("content-type"), "text/html; charset=utf-8");
    EXPECT_EQ(page.headers.at("cache-control"), "no-store");
    EXPECT_EQ(page.headers.at("referrer-policy"), "no-referrer");
    EXPECT_EQ(page.headers.at("x-content-type-options"), "nosniff");
    EXPECT_NE(page.headers.at("content-security-policy").find("default-src 'none'"), std::string::npos);
    EXPECT_FALSE(page.headers.contains("set-cookie"));
    EXPECT_FALSE(page.headers.contains("server"));
    EXPECT_EQ(page.body, content_of(served.box() / code / "en.html"));
    const HttpAnswer model = get(served.port(), "/" + code + "/pot.glb");
    EXPECT_EQ(model.body, content_of(served.box() / code / "pot.glb"));
    EXPECT_FALSE(model.headers.contains("content-encoding"));

    const HttpAnswer packed = get(served.port(), "/" + code + "/pot.glb", "Accept-Encoding: gzip, br\r\n");
    EXPECT_EQ(packed.headers.at("content-encoding"), "gzip");
    EXPECT_EQ(packed.headers.at("vary"), "Accept-Encoding");
    EXPECT_EQ(packed.body, content_of(served.box() / code / "pot.glb.gz"));
    EXPECT_EQ(unpacked(packed.body), model.body);
}

TEST(ShareServer, GivesRangesAndHeads) {
    ServedOutbox served;
    const std::string code = served.put(support::full_pot("one"));
    const std::string whole = content_of(served.box() / code / "pot.stl");
    const std::string target = "/" + code + "/pot.stl";
    const HttpAnswer part = get(served.port(), target, "Range: bytes=100-199\r\nAccept-Encoding: gzip\r\n");
    EXPECT_EQ(part.status, 206);
    EXPECT_EQ(part.body, whole.substr(100, 100));
    EXPECT_EQ(part.headers.at("content-range"), "bytes 100-199/" + std::to_string(whole.size()));
    EXPECT_EQ(get(served.port(), target, "Range: bytes=-7\r\n").body, whole.substr(whole.size() - 7));
    const HttpAnswer beyond = get(served.port(), target, "Range: bytes=9999999-\r\n");
    EXPECT_EQ(beyond.status, 416);
    EXPECT_EQ(beyond.headers.at("content-range"), "bytes */" + std::to_string(whole.size()));
    HttpClient client(served.port());
    client.say("HEAD " + target + " HTTP/1.1\r\nHost: pots\r\n\r\n");
    const HttpAnswer head = client.answer(false);
    EXPECT_EQ(head.status, 200);
    EXPECT_EQ(head.headers.at("content-length"), std::to_string(whole.size()));
    // On the same connection, and without a byte of a body in between.
    client.say("GET /" + code + "/pot.3mf HTTP/1.1\r\nHost: pots\r\n\r\n");
    EXPECT_EQ(client.answer().body, content_of(served.box() / code / "pot.3mf"));
}

TEST(ShareServer, HasAFriendlyPageForAMissingPot) {
    ServedOutbox served;
    const std::string withdrawn = served.put(support::full_pot("one"));
    const std::string expired = served.put(support::full_pot("two"), from_now(1));
    EXPECT_EQ(get(served.port(), "/" + withdrawn + "/").status, 200);
    ASSERT_TRUE(*served.outbox().withdraw(*sharing::ShareCode::read(withdrawn)));
    ::usleep(1'100'000);
    ASSERT_TRUE(std::filesystem::exists(served.box() / expired)) << "before any clean-up";
    std::string said;
    for (const std::string& target :
         {"/" + withdrawn + "/", "/" + expired + "/", std::string("/7777ZZZZ/")}) {
        const HttpAnswer lost = get(served.port(), target, "Accept-Language: ko\r\n");
        EXPECT_EQ(lost.status, 404) << target;
        EXPECT_NE(lost.body.find("<html lang=\"ko\""), std::string::npos);
        if (said.empty()) said = lost.body;
        EXPECT_EQ(lost.body, said) << "indistinguishable";
    }
    EXPECT_EQ(get(served.port(), "/" + expired + "/pot.glb").status, 404);
    EXPECT_EQ(get(served.port(), "/").status, 200);
    EXPECT_EQ(get(served.port(), "/").body.find(withdrawn), std::string::npos);
}

TEST(ShareServer, KeepsAllOverARestartOfTheProgram) {
    const HeldPort port;
    ServedOutbox served({}, port.number());
    const std::string code = served.put(support::full_pot("one"));
    EXPECT_EQ(get(port.number(), "/" + code + "/").status, 200);
    served.server().signal(SIGKILL);
    // Wait for its end before another may listen: on a busy machine the kernel takes a while to close it.
    EXPECT_EQ(served.server().exit_code(), -1) << "killed, not ended";
    ASSERT_FALSE(served.server().at_work());
    RunningOnggi again({"share", "--outbox", served.box().string(), "--listen", "127.0.0.1", "--port",
                        std::to_string(port.number())});
    EXPECT_EQ(port_said_by(again), port.number());
    EXPECT_EQ(get(port.number(), "/" + code + "/").status, 200) << again.printed();
}

TEST(ShareServer, CountsPagesThroughAPipe) {
    const TemporaryFolder folder;
    auto reader = sharing::CounterReader::open(folder / "counter");
    ASSERT_TRUE(reader) << reader.error().message;
    // As the package lays it: another user, which the server becomes where root runs the tests, may write.
    constexpr auto kAllWrite = std::filesystem::perms::group_write | std::filesystem::perms::others_write;
    constexpr auto kAllEnter = std::filesystem::perms::group_exec | std::filesystem::perms::others_exec;
    std::filesystem::permissions(folder.path(), kAllEnter, std::filesystem::perm_options::add);
    std::filesystem::permissions(folder / "counter", kAllWrite, std::filesystem::perm_options::add);
    ServedOutbox served({"--counter", (folder / "counter").string()});
    const std::string code = served.put(support::full_pot("one"));
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(get(served.port(), "/" + code + "/").status, 200);
    EXPECT_EQ(get(served.port(), "/" + code + "/", "", "HEAD").status, 200);
    EXPECT_EQ(get(served.port(), "/" + code + "/page.css").status, 200);
    EXPECT_EQ(get(served.port(), "/" + code + "/pot.glb").status, 200);
    EXPECT_EQ(get(served.port(), "/" + code + "/film.mp4").status, 200);
    EXPECT_EQ(get(served.port(), "/" + code + "/film.mp4", "Range: bytes=0-\r\n").status, 206) << "played";
    EXPECT_EQ(get(served.port(), "/7777ZZZZ/").status, 404);
    const auto counts = reader->take();
    EXPECT_EQ(counts, (std::map<sharing::ShareEvent, int>{{sharing::ShareEvent::kPageOpened, 3},
                                                          {sharing::ShareEvent::kModelTaken, 1},
                                                          {sharing::ShareEvent::kFilmTaken, 1}}));
}

TEST(ShareServer, ServesOnlyTheOutbox) {
    ServedOutbox served;
    const std::string code = served.put(support::full_pot("one"));
    // An intruder has written to the outbox: links and pipes are not followed.
    const auto place = served.box() / code;
    put_file(served.folder() / "secret", "staff's PIN");
    std::filesystem::remove(place / "pot.stl");
    std::filesystem::remove(place / "pot.stl.gz");
    std::filesystem::create_symlink(served.folder() / "secret", place / "pot.stl");
    std::filesystem::remove(place / "pot.3mf");
    ASSERT_EQ(::mkfifo((place / "pot.3mf").c_str(), 0600), 0);
    std::filesystem::create_directory_symlink(place, served.box() / "7777ZZZZ");
    EXPECT_EQ(get(served.port(), "/" + code + "/pot.stl").status, 404);
    EXPECT_EQ(get(served.port(), "/" + code + "/pot.3mf").status, 404);
    EXPECT_EQ(get(served.port(), "/7777ZZZZ/").status, 404);
    EXPECT_EQ(get(served.port(), "/" + code + "/").status, 200);
}

}  // namespace
}  // namespace onggi::test
