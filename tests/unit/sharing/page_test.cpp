#include "game/sharing/phone_page.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "tests/support/shared_pot_samples.h"

namespace onggi::sharing {
namespace {

std::string page_of(const SharedPot& pot, std::size_t language,
                    const std::string& url = "http://10.0.0.5/K73FQ9TX/") {
    const auto languages = support::three_languages();
    const ShareCode code = *ShareCode::read("K73FQ9TX");
    return phone_page({.pot = pot,
                       .languages = *languages,
                       .language = language,
                       .code = code,
                       .links = {.poster = "poster.png",
                                 .picture = pot.picture.is_given() ? "pot.png" : "",
                                 .surface = "surface.png",
                                 .film_still = "still.png"},
                       .gone_at = "18:00",
                       .is_gone_today = true,
                       .page_url = url});
}

bool has(const std::string& page, std::string_view text) {
    return page.find(text) != std::string::npos;
}

TEST(PhonePage, HasALinkForEachFileThatIsThere) {
    const std::string page = page_of(support::full_pot("x"), 0);
    EXPECT_TRUE(has(page, "<html lang=\"en\" dir=\"ltr\">"));
    for (const char* link :
         {"href=\"pot.png\" download=\"onggi-K73FQ9TX.png\"",
          "href=\"pot.glb\" download=\"onggi-K73FQ9TX.glb\"",
          "href=\"pot.stl\" download=\"onggi-K73FQ9TX.stl\"",
          "href=\"pot.3mf\" download=\"onggi-K73FQ9TX.3mf\"",
          "href=\"film.mp4\" download=\"onggi-K73FQ9TX.mp4\"",
          "<img src=\"poster.png\" alt=\"Your pot, Celadon\">", "href=\"ko.html\" hreflang=\"ko\"",
          "Film, 8 s", "<bdi>160</bdi>", "<bdi>1.9</bdi>", "This page is gone after today, 18:00.",
          "Moon jar", "<svg viewBox"})
        EXPECT_TRUE(has(page, link)) << link;
    EXPECT_FALSE(has(page, "id=\"ar\"")) << "no augmented reality without https";
    EXPECT_FALSE(has(page, "id=\"share\"")) << "browsers share no files without https";
    EXPECT_TRUE(has(page, "id=\"iphone\" hidden>On an iPhone, what you save goes to Files"));
}

TEST(PhonePage, PlaysTheMp4WithTheAnimatedPictureInsteadWhereItCannot) {
    const std::string page = page_of(support::full_pot("x"), 0);
    const std::size_t video = page.find("<video class=\"film\" id=\"video\" playsinline muted loop controls");
    const std::size_t source = page.find("<source src=\"film.mp4\" type=\"video/mp4\">", video);
    const std::size_t instead = page.find("<a class=\"film\" id=\"film\" href=\"film.webp\"", source);
    EXPECT_NE(instead, std::string::npos);
    EXPECT_LT(instead, page.find("</video>", video));
    EXPECT_TRUE(has(page, "poster=\"still.png\" aria-label=\"How it was made\""));
    EXPECT_TRUE(has(page, "media-src 'self'"));

    SharedPot without = support::full_pot("x");
    without.film_mp4 = {};
    const std::string older = page_of(without, 0);
    EXPECT_FALSE(has(older, "<video"));
    EXPECT_FALSE(has(older, "film.mp4"));
    EXPECT_TRUE(has(older, "href=\"film.webp\" download=\"onggi-K73FQ9TX.webp\""));
    EXPECT_TRUE(has(older, "<a class=\"film\" id=\"film\" href=\"film.webp\""));
}

TEST(PhonePage, HoldsDrawingAndMeasuresBehindAFold) {
    const std::string page = page_of(support::full_pot("x"), 0);
    const std::size_t fold = page.find("<details>\n<summary>For researchers</summary>");
    ASSERT_NE(fold, std::string::npos);
    for (const char* link : {"href=\"pot.pdf\" download=\"onggi-K73FQ9TX.pdf\"",
                             "href=\"pot.svg\" download=\"onggi-K73FQ9TX.svg\"",
                             "href=\"pot.json\" download=\"onggi-K73FQ9TX.json\""})
        EXPECT_GT(page.find(link), fold) << link;
    EXPECT_FALSE(has(page_of(SharedPot(), 0), "<details>"));
}

TEST(PhonePage, OmitsMissingFiles) {
    const SharedPot empty;
    const std::string page = page_of(empty, 0);
    for (const char* text :
         {"pot.glb", "pot.stl", "pot.3mf", "film", "<dl", "near", "data-outside", "<svg", "glaze"})
        EXPECT_FALSE(has(page, text)) << text;
    EXPECT_TRUE(has(page, "<h1>Your pot</h1>"));
}

TEST(PhonePage, SpeaksKoreanAndArabic) {
    const std::string korean = page_of(support::full_pot("x"), 1);
    EXPECT_TRUE(has(korean, "<html lang=\"ko\" dir=\"ltr\">"));
    EXPECT_TRUE(has(korean, "이 페이지는 오늘 18:00에 지워져요."));
    EXPECT_TRUE(has(korean, "청자"));
    const std::string arabic = page_of(support::full_pot("x"), 2);
    EXPECT_TRUE(has(arabic, "<html lang=\"ar\" dir=\"rtl\">"));
    EXPECT_TRUE(has(arabic, "<bdi>١٦٠</bdi>")) << "with the digits of its own";
    EXPECT_TRUE(has(arabic, "١٨:٠٠"));
}

TEST(PhonePage, OffersAugmentedRealityByHttpsOnly) {
    const std::string page = page_of(support::full_pot("x"), 0, "https://museum.org/pots/K73FQ9TX/");
    EXPECT_TRUE(
        has(page, "intent://arvr.google.com/scene-viewer/1.0?file=https://museum.org/pots/K73FQ9TX/pot.glb"));
    EXPECT_TRUE(has(page, "id=\"ar\" hidden")) << "the script shows it where there is a viewer";
    EXPECT_TRUE(has(page, "id=\"share\" type=\"button\" hidden"))
        << "the script shows it where files are shared";
    EXPECT_FALSE(has(page, "pot.usdz")) << "there is none";
    sharing::SharedPot for_iphones = support::full_pot("x");
    for_iphones.model_usdz.bytes = support::bytes_of("PK usdz");
    EXPECT_TRUE(has(page_of(for_iphones, 0, "https://museum.org/pots/K73FQ9TX/"),
                    "id=\"room\" hidden rel=\"ar\" href=\"pot.usdz\""));
    EXPECT_FALSE(has(page_of(for_iphones, 0, "http://museum.org/pots/K73FQ9TX/"), "pot.usdz"));
}

TEST(PhonePage, LoadsOnlyFilesOfItsFolder) {
    for (const std::string& page :
         {page_of(support::full_pot("x"), 0), lost_page(*support::three_languages(), 0),
          ask_page(*support::three_languages(), 1)}) {
        for (const char* text :
             {"http://", "https://", "src=\"//", "url(", "@import", "onclick", "<script>", "<iframe"})
            EXPECT_FALSE(has(page, text)) << text;
    }
}

TEST(PhonePage, TakesWordsAsWords) {
    SharedPot pot = support::full_pot("x");
    pot.words[0] = {"<script>alert(1)</script>", "\" onload=\"x", "a & b\xff\x01 it's"};
    const std::string page = page_of(pot, 0);
    EXPECT_FALSE(has(page, "<script>alert"));
    EXPECT_FALSE(has(page, "\" onload"));
    EXPECT_TRUE(has(page, "a &amp; b\ufffd\ufffd it&#39;s"));
    EXPECT_EQ(html("\u00a0한\u00e9 · \u0085"), "\u00a0한\u00e9 · \ufffd\ufffd");
    EXPECT_EQ(html(std::string_view("a\0b", 3)), "a\ufffdb");
}

TEST(PhonePage, DrawsOutlinesOfAnyNumbers) {
    EXPECT_EQ(outline_numbers({}), "");
    const std::vector<OutlinePoint> plain{{50.0, 0.0}, {54.24, 5.0}};
    EXPECT_EQ(outline_numbers(plain), "50,0 54.2,5");
    const double nothing = std::numeric_limits<double>::quiet_NaN();
    const std::vector<OutlinePoint> broken{{50.0, 0.0}, {nothing, 5.0}, {60.0, 10.0}};
    EXPECT_EQ(outline_numbers(broken), "50,0");
    EXPECT_EQ(two_pots(broken, plain).svg, "");
    std::vector<OutlinePoint> fine;
    for (int i = 0; i < 5000; ++i)
        fine.push_back({50.0, i * 0.05});
    const std::string numbers = outline_numbers(fine);
    EXPECT_LT(numbers.size(), 2000U);
    EXPECT_TRUE(numbers.ends_with("50,250")) << "the rim is kept";
}

TEST(PhonePage, DrawsAVatNoLargerThanTheVisitorsPotAndSaysHowTallItIs) {
    const auto tube = [](double radius_mm, double height_mm) {
        return std::vector<OutlinePoint>{{radius_mm, 0.0}, {radius_mm, height_mm}};
    };
    const TwoPots with_vat = two_pots(tube(40.0, 100.0), tube(400.0, 1000.0));
    EXPECT_EQ(with_vat.times_as_tall, 10.0);
    const TwoPots alike = two_pots(tube(40.0, 100.0), tube(40.0, 100.0));
    EXPECT_EQ(alike.times_as_tall, 0.0) << "at one scale";
    EXPECT_EQ(with_vat.svg, alike.svg) << "as large as the visitor's";
    EXPECT_EQ(two_pots(tube(40.0, 100.0), tube(20.0, 50.0)).times_as_tall, 0.0);
    SharedPot pot = support::full_pot("x");
    pot.outside = tube(40.0, 100.0);
    pot.nearest_outside = tube(400.0, 1000.0);
    EXPECT_TRUE(has(page_of(pot, 0), "10.0"));
    pot.nearest_outside = tube(20.0, 50.0);
    EXPECT_FALSE(has(page_of(pot, 0), "10.0"));
}

TEST(PhonePage, KeepsALedgeOfAnOutline) {
    std::vector<OutlinePoint> ledge;
    for (int i = 0; i < 513; ++i)
        ledge.push_back({i < 40 ? 40.0 : 48.0, i * 0.3});
    EXPECT_EQ(outline_numbers(ledge), "40,0 40,11.7 48,12 48,153.6");
}

TEST(PhonePage, TellsAxisAndDentsOfAPotThatIsNotRound) {
    EXPECT_EQ(axis_numbers(std::vector<AxisPoint>{{0.0, 1.5, -0.2}, {10.0, 0.0, 1e9}}),
              "0,30,-4 200,0,40000");
    EXPECT_EQ(dent_numbers(std::vector<std::vector<double>>{{0.0, -2.34}, {1e9, 0.0}}), "0,-47 40000,0");
    EXPECT_EQ(axis_numbers({}), "");
    SharedPot pot = support::full_pot("x");
    EXPECT_FALSE(has(page_of(pot, 0), "data-axis"));
    pot.axis = {{0.0, 1.0, 0.0}, {50.0, 2.0, 0.0}};
    pot.dents_mm = {{0.5}, {-0.5}};
    pot.reach_mm = 61.25;
    EXPECT_TRUE(
        has(page_of(pot, 0), "data-reach=\"61.25\" data-axis=\"0,20,0 1000,40,0\" data-dents=\"10 -10\""));
}

TEST(PhonePage, KeepsAJumpOfAnAxisAndNoPointOfALine) {
    std::vector<AxisPoint> jump;
    for (int i = 0; i < 256; ++i)
        jump.push_back({i * 0.5, i < 40 ? 6.0 : i * 0.01, i * 0.02});
    EXPECT_EQ(axis_numbers(jump), "0,120,0 390,120,16 400,8,16 2550,51,102");
}

TEST(PhonePage, SaysHowViewersShowAnStl) {
    EXPECT_TRUE(has(page_of(support::full_pot("x"), 0), "<p class=\"note\">Files for printing stand on Z."));
    SharedPot without = support::full_pot("x");
    without.print_stl = {};
    EXPECT_FALSE(has(page_of(without, 0), "<p class=\"note\">"));
}

TEST(PlainPages, SayItInEveryLanguageTheLikedOneFirst) {
    const std::string page = lost_page(*support::three_languages(), 2);
    EXPECT_TRUE(has(page, "<html lang=\"ar\" dir=\"rtl\">"));
    EXPECT_LT(page.find("لا يوجد إناء هنا"), page.find("There is no pot here"));
    EXPECT_TRUE(has(page, "여기에는 그릇이 없어요"));
    const std::string ask = ask_page(*support::three_languages(), 0);
    EXPECT_TRUE(has(ask, "<label for=\"code\">"));
    EXPECT_TRUE(has(ask, "name=\"code\" type=\"text\""));
    EXPECT_FALSE(ask_script().empty());
}

}  // namespace
}  // namespace onggi::sharing
