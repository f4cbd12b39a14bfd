#include "game/sharing/share_request.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace onggi::sharing {
namespace {

using Kind = ShareAnswer::Kind;

ShareAnswer get(std::string_view target) {
    return answer_to({.method = "GET", .target = target});
}

TEST(ShareRequest, FindsAPotByItsCodeAlone) {
    const ShareAnswer page = get("/K73FQ9TX/");
    ASSERT_EQ(page.kind, Kind::kFile);
    EXPECT_EQ(page.code->text(), "K73FQ9TX");
    EXPECT_EQ(page.file.name, "index.html");
    EXPECT_EQ(get("/K73FQ9TX/pot.glb").file.media_type, "model/gltf-binary");
    EXPECT_EQ(get("/K73FQ9TX/pot.usdz").file.media_type, "model/vnd.usdz+zip");
    EXPECT_EQ(get("/K73FQ9TX/pot.glb?from=qr").file.name, "pot.glb");
    EXPECT_EQ(get("/K73FQ9TX/ko.html").file.name, "ko.html");
    EXPECT_EQ(get("/K73FQ9TX/zh-Hant.html").file.name, "zh-Hant.html");
    EXPECT_EQ(answer_to({.method = "HEAD", .target = "/K73FQ9TX/pot.stl"}).kind, Kind::kFile);
}

TEST(ShareRequest, RedirectsATypedCodeToItsPot) {
    const struct {
        const char* target;
        const char* location;
    } kCases[] = {{"/K73FQ9TX", "K73FQ9TX/"},
                  {"/k73f-q9tx", "K73FQ9TX/"},
                  {"/k73fq9tx/", "../K73FQ9TX/"},
                  {"/?code=k73f-q9tx", "K73FQ9TX/"},
                  {"/?code=K73F%C2%B7Q9TX", "K73FQ9TX/"},
                  {"/?other=1&code=k73f+q9tx", "K73FQ9TX/"},
                  {"/?code=%4b73fq9tx", "K73FQ9TX/"}};
    for (const auto& one : kCases) {
        EXPECT_EQ(get(one.target).kind, Kind::kMoved) << one.target;
        EXPECT_EQ(get(one.target).location, one.location) << one.target;
    }
}

TEST(ShareRequest, LeadsFromALinkThatAMessengerMadeTooLong) {
    const struct {
        const char* target;
        const char* location;
    } kCases[] = {{"/K73FQ9TX)", "K73FQ9TX/"},
                  {"/K73FQ9TX/)", "../K73FQ9TX/"},
                  {"/K73FQ9TX/,", "../K73FQ9TX/"},
                  {"/K73FQ9TX/%20", "../K73FQ9TX/"},
                  {"/K73FQ9TX//", "../../K73FQ9TX/"},
                  {"/K73FQ9TX/).", "../K73FQ9TX/"},
                  {"/k73f-q9tx,", "K73FQ9TX/"},
                  {"/K73FQ9TX/en.html)", "../K73FQ9TX/en.html"},
                  {"/K73FQ9TX/pot.glb,", "../K73FQ9TX/pot.glb"}};
    for (const auto& one : kCases) {
        EXPECT_EQ(get(one.target).kind, Kind::kMoved) << one.target;
        EXPECT_EQ(get(one.target).location, one.location) << one.target;
    }
    for (const char* target : {"/)", "//", "/..", "/K73FQ9TX/..", "/K73FQ9TX/.kept,", "/nothing)", "/%20"})
        EXPECT_EQ(get(target).kind, Kind::kNotFound) << target;
}

TEST(ShareRequest, TakesATargetInAbsoluteForm) {
    EXPECT_EQ(get("http://10.0.0.5:8080/K73FQ9TX/pot.glb").file.name, "pot.glb");
    EXPECT_EQ(get("HTTP://pots/K73FQ9TX/").kind, Kind::kFile);
    EXPECT_EQ(get("https://pots").kind, Kind::kAskForCode);
    EXPECT_EQ(get("http://[fd00::5]:8080/K73FQ9TX/").kind, Kind::kFile);
    for (const char* target :
         {"http://pots?code=K73FQ9TX", "ftp://pots/K73FQ9TX/", "http:///K73FQ9TX/", "http://:80/K73FQ9TX/",
          "http://user@pots/K73FQ9TX/", "http://pots:x/K73FQ9TX/", "http://[fd00::5/K73FQ9TX/"})
        EXPECT_EQ(get(target).kind, Kind::kBadRequest) << target;
    EXPECT_EQ(get("http://pots/../etc/passwd").kind, Kind::kNotFound);
}

TEST(ShareRequest, RejectsOtherPaths) {
    for (const char* target : {"/K73FQ9TX/../K73FQ9TX/pot.glb",
                               "/K73FQ9TX/..",
                               "/../etc/passwd",
                               "/%2e%2e/etc/passwd",
                               "/K73FQ9TX//pot.glb",
                               "//K73FQ9TX/pot.glb",
                               "/K73FQ9TX/pot.glb/",
                               "/K73FQ9TX/pot.glb%00",
                               "/K73FQ9TX/.kept",
                               "/K73FQ9TX/pot.glb.gz",
                               "/K73FQ9TX/%70ot.glb",
                               "/K73FQ9TX/POT.GLB",
                               "/K73FQ9TX/x.html.gz",
                               "/K73FQ9TX/..html",
                               "/K73FQ9TX/a/b.html",
                               "/K73FQ9TX.part/pot.glb",
                               "/K73FQ9TX;/pot.glb",
                               "/K73FQ9TX\\pot.glb",
                               "/k73fq9tx/pot.glb",
                               "/.",
                               "/..",
                               "/*",
                               "/index.html",
                               "/?code=",
                               "/?code=../..",
                               "/?code=K73FQ9T%",
                               "/404.html"}) {
        EXPECT_EQ(get(target).kind, Kind::kNotFound) << target;
    }
    EXPECT_EQ(get("/?").kind, Kind::kAskForCode);
    for (const char* target : {"", "*", "K73FQ9TX/", "/K73FQ9TX/\x01", "/\xff", "/a b"})
        EXPECT_EQ(get(target).kind, Kind::kBadRequest) << target;
    EXPECT_EQ(get("/" + std::string(600, 'a')).kind, Kind::kTooLong);
    for (const char* method : {"POST", "PUT", "DELETE", "get", "", "OPTIONS", "TRACE", "CONNECT", "PROPFIND"})
        EXPECT_EQ(answer_to({.method = method, .target = "/K73FQ9TX/"}).kind, Kind::kNotAllowed) << method;
}

TEST(ShareRequest, TakesThePackedTwinWhereThePhoneUnderstandsIt) {
    const auto takes = [](std::string_view accept, std::string_view target = "/K73FQ9TX/pot.glb",
                          std::string_view range = {}) {
        return answer_to({.method = "GET", .target = target, .range = range, .accept_encoding = accept})
            .takes_gzip;
    };
    EXPECT_TRUE(takes("gzip"));
    EXPECT_TRUE(takes("deflate, GZIP;q=0.5, br"));
    EXPECT_TRUE(takes("*"));
    EXPECT_FALSE(takes(""));
    EXPECT_FALSE(takes("br, deflate"));
    EXPECT_FALSE(takes("gzip;q=0"));
    EXPECT_FALSE(takes("gzip;q=0.000, *"));
    EXPECT_FALSE(takes("identity, *;q=0"));
    EXPECT_FALSE(takes("gzip", "/K73FQ9TX/pot.png")) << "a picture is packed already";
    EXPECT_FALSE(takes("gzip", "/K73FQ9TX/pot.glb", "bytes=0-1")) << "a range is of the file itself";
}

TEST(ShareRequest, GivesOneRangeOrAll) {
    using Part = ByteRange::Kind;
    const struct {
        const char* range;
        Part kind;
        std::uint64_t first;
        std::uint64_t count;
    } kCases[] = {{"bytes=0-9", Part::kPart, 0, 10},
                  {"bytes=90-", Part::kPart, 90, 10},
                  {"bytes=-1", Part::kPart, 99, 1},
                  {"bytes=-500", Part::kPart, 0, 100},
                  {"bytes=50-5000", Part::kPart, 50, 50},
                  {"bytes=100-", Part::kBeyond, 0, 0},
                  {"bytes=-0", Part::kBeyond, 0, 0},
                  {"bytes=9-8", Part::kWhole, 0, 100},
                  {"bytes=0-1,5-6", Part::kWhole, 0, 100},
                  {"bytes=-", Part::kWhole, 0, 100},
                  {"bytes=a-b", Part::kWhole, 0, 100},
                  {"lines=0-1", Part::kWhole, 0, 100},
                  {"bytes=0--1", Part::kWhole, 0, 100},
                  {"bytes=0x1-5", Part::kWhole, 0, 100},
                  {"", Part::kWhole, 0, 100},
                  {"bytes=18446744073709551616-", Part::kWhole, 0, 100},
                  {"bytes=18446744073709551615-", Part::kBeyond, 0, 0}};
    for (const auto& one : kCases) {
        const ByteRange part = resolve_range(one.range, 100);
        EXPECT_EQ(part.kind, one.kind) << one.range;
        EXPECT_EQ(part.first, one.first) << one.range;
        EXPECT_EQ(part.count, one.count) << one.range;
    }
    EXPECT_EQ(resolve_range("bytes=-5", 0).kind, Part::kBeyond);
    const ShareAnswer conditional = answer_to(
        {.method = "GET", .target = "/K73FQ9TX/pot.glb", .range = "bytes=0-9", .if_range = "\"tag\""});
    EXPECT_TRUE(conditional.range.empty()) << "nothing here has a tag";
}

TEST(ShareRequest, AnswersInTheLanguageThatIsLikedBest) {
    const std::array<std::string_view, 3> codes{"en", "ko", "ar"};
    const auto liked = [&](std::string_view accept) { return liked_language(accept, codes); };
    EXPECT_EQ(liked("ko-KR,ko;q=0.9,en-US;q=0.8"), 1U);
    EXPECT_EQ(liked("de, AR-eg;q=0.7, en;q=0.3"), 2U);
    EXPECT_EQ(liked("en;q=0.2, ko;q=0.9"), 1U);
    EXPECT_EQ(liked("de, fr"), std::nullopt);
    EXPECT_EQ(liked("en;q=0"), std::nullopt);
    EXPECT_EQ(liked(""), std::nullopt);
    EXPECT_EQ(liked(";;;,,,q=;q=1;"), std::nullopt);
}

TEST(ShareRequest, TakesTheScriptOfALanguageForTheWholeOfIt) {
    const std::array<std::string_view, 3> codes{"en", "zh-Hans", "zh-Hant"};
    const auto liked = [&](std::string_view accept) { return liked_language(accept, codes); };
    EXPECT_EQ(liked("zh-CN,zh;q=0.9,en;q=0.8"), 1U);
    EXPECT_EQ(liked("zh"), 1U);
    EXPECT_EQ(liked("zh-Hant-TW, en;q=0.9"), 2U);
    EXPECT_EQ(liked("en, zh-CN"), 0U);
    EXPECT_EQ(liked("zh;q=0"), std::nullopt);
}

}  // namespace
}  // namespace onggi::sharing
