#include "game/kiosk/config.h"
#include "tests/support/places.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <utility>

namespace onggi::kiosk {
namespace {

TEST(Config, RunsWithoutAnyLine) {
    const auto config = read_config("", "kiosk.toml");
    ASSERT_TRUE(config) << config.error().message;
    const Rules rules = rules_of(*config);
    EXPECT_EQ(rules.idle_s, 45.0);
    EXPECT_EQ(rules.countdown_s, 20.0);
    EXPECT_FALSE(rules.locked);
    EXPECT_EQ(rules.pin_digits, 0);
}

TEST(Config, ReadsEverySetting) {
    const auto config = read_config(
        "[visit]\nidle_s = 60\n[languages]\norder = [\"en\", \"ko\"]\nfirst = \"ko\"\n[staff]\npin = "
        "\"0472\"\n"
        "locked = true\n[hours]\nopens = \"09:30\"\ncloses = \"18:00\"\n[gallery]\nfolder = \"/srv/pots\"\n"
        "[screen]\nroom = \"/srv/room\"\nbackend = \"cpu\"\n",
        "kiosk.toml");
    ASSERT_TRUE(config) << config.error().message;
    EXPECT_EQ(config->languages.order, (std::vector<std::string>{"en", "ko"}));
    EXPECT_EQ(config->hours.opens_min, 570);
    EXPECT_EQ(config->gallery.folder, "/srv/pots");
    EXPECT_EQ(config->screen.room, "/srv/room");
    EXPECT_EQ(config->screen.backend, "cpu");
    const Rules rules = rules_of(*config);
    EXPECT_EQ(rules.idle_s, 60.0);
    EXPECT_EQ(rules.pin, 472);
    EXPECT_EQ(rules.pin_digits, 4);
    EXPECT_TRUE(rules.locked);
}

TEST(Config, SharesThroughItsOwnAddressOrTheMuseumsServer) {
    const auto own = read_config("[sharing]\nlisten = \"wlan0\"\nport = 80\nhours = 3\n", "kiosk.toml");
    ASSERT_TRUE(own) << own.error().message;
    EXPECT_TRUE(shares(*own));
    EXPECT_EQ(own->sharing.port, 80);
    EXPECT_EQ(own->sharing.hours, 3);
    const auto house = read_config("[sharing]\npublic_url = \"https://museum.org/pots\"\n", "kiosk.toml");
    ASSERT_TRUE(house) << house.error().message;
    EXPECT_TRUE(shares(*house));
    EXPECT_TRUE(
        read_config("[sharing]\nlisten = \"::\"\npublic_url = \"http://pots.local\"\n", "kiosk.toml"));
}

TEST(Config, TakesOneTextOfTheHouseOrOneALanguage) {
    const auto one = read_config("[sharing]\nlicence = \"CC BY 4.0\"\npublisher = \"\"\n", "kiosk.toml");
    ASSERT_TRUE(one) << one.error().message;
    EXPECT_EQ(one->sharing.licence, (HouseText{{"", "CC BY 4.0"}}));
    EXPECT_TRUE(one->sharing.publisher.empty());
    const auto three = read_config(
        "[sharing]\npublisher = { en = \"House of Clay\", ko = \"흙의 집\", ar = \"\" }\n", "kiosk.toml");
    ASSERT_TRUE(three) << three.error().message;
    EXPECT_EQ(three->sharing.publisher, (HouseText{{"en", "House of Clay"}, {"ko", "흙의 집"}}));
}

TEST(Config, TakesAPublicAddressAsPeopleWriteIt) {
    const std::pair<const char*, const char*> kCases[] = {
        {"HTTPS://museum.org/pots", "https://museum.org/pots"},
        {"Http://Museum.org", "http://Museum.org"},
        {"https://m\u00fcseum.example/pots", "https://xn--mseum-kva.example/pots"},
        {"https://\ub3c4\uc790\uae30.example:8443/", "https://xn--ok0bu9hoqt.example:8443/"},
        {"http://[fd00::5]:8080/pots", "http://[fd00::5]:8080/pots"},
        {"", ""}};
    for (const auto& [written, meant] : kCases) {
        const auto config =
            read_config(fmt::format("[sharing]\npublic_url = \"{}\"\n", written), "kiosk.toml");
        ASSERT_TRUE(config) << config.error().message;
        EXPECT_EQ(config->sharing.public_url, meant);
    }
    for (const char* bad : {"ftp://museum.org", "https://", "https://:80/", "https://museum.org/t\u00f6pfe",
                            "https://a b.org", "https://xn--\u00fc.org"})
        EXPECT_FALSE(read_config(fmt::format("[sharing]\npublic_url = \"{}\"\n", bad), "kiosk.toml")) << bad;
}

TEST(Config, WantsThePortApartFromThePlaceToListenAt) {
    for (const char* good : {"10.0.0.5", "fd00::5", "::", "wlan0", "eth0:1", "br-lan.10"})
        EXPECT_TRUE(
            read_config(fmt::format("[sharing]\nlisten = \"{}\"\npublic_url = \"http://a\"\n", good), ""))
            << good;
    for (const char* bad : {"10.0.0.5:8080", "wlan0:8080", "museum.local:80", "[fd00::5]:8080", "eth0.10:80"})
        EXPECT_FALSE(read_config(fmt::format("[sharing]\nlisten = \"{}\"\n", bad), "")) << bad;
}

TEST(Config, ShipsAnExampleThatSaysTheDefaults) {
    std::ifstream file(test::in_checkout("assets/kiosk.toml"));
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    ASSERT_FALSE(text.empty());
    const auto config = read_config(text, "assets/kiosk.toml");
    ASSERT_TRUE(config) << config.error().message;
    const Config plain;
    EXPECT_EQ(config->visit.idle_s, plain.visit.idle_s);
    EXPECT_EQ(config->languages.order, plain.languages.order);
    EXPECT_EQ(config->languages.first, plain.languages.first);
    EXPECT_EQ(config->gallery.most_pots, plain.gallery.most_pots);
    EXPECT_EQ(config->hours.opens_min, plain.hours.opens_min);
    EXPECT_EQ(config->screen.room, plain.screen.room);
    EXPECT_EQ(config->staff.pin, plain.staff.pin);
    EXPECT_EQ(config->sound.volume, plain.sound.volume);
    EXPECT_EQ(config->sharing.listen, plain.sharing.listen);
    EXPECT_EQ(config->sharing.port, plain.sharing.port);
    EXPECT_EQ(config->sharing.outbox, plain.sharing.outbox);
    EXPECT_EQ(config->sharing.hours, plain.sharing.hours);
    EXPECT_EQ(config->sharing.most_pots, plain.sharing.most_pots);
    EXPECT_EQ(config->sharing.most_mb, plain.sharing.most_mb);
    EXPECT_FALSE(shares(*config)) << "off unless somebody says so";
}

const struct {
    const char* toml;
    const char* message;
} kMistakes[] = {
    {"# 가\n[visit]\n\xEF\xB3\xBFs = 5\n",
     "kiosk.toml, line 3: expected plain letters outside of quotes, each string on one line, found a "
     "letter of "
     "another alphabet"},
    {"[staff]\nname = \"\"\"Wheel\"\"\"\n",
     "kiosk.toml, line 2: expected plain letters outside of quotes, each string on one line, found three "
     "quotes"},
    {"[!]\nidle_s = 60\n", "kiosk.toml, line 1: expected TOML, found "},
    {"[\x0e\n", "kiosk.toml, line 1: expected TOML, found "},
    {"[sharing]\nport = 8-\"/\xC6\xB3\"\n", "kiosk.toml, line 2: expected TOML, found "},
    {"[visit]\nidle_s = 4.\x01t['i\xEF\xBE\xB7[v\n", "kiosk.toml, line 2: expected TOML, found "},
    {"[visit]\nidle_s = 5\n", "kiosk.toml, line 2: expected 10 to 600 for idle_s, found 5"},
    {"[visit]\nidle_s = nan\n", "kiosk.toml, line 2: expected 10 to 600 for idle_s, found nan"},
    {"[visit]\nidle_s = \"long\"\n", "kiosk.toml, line 2: expected 10 to 600 for idle_s, found 'long'"},
    {"[visit]\n\nidle = 60\n",
     "kiosk.toml, line 3: expected one of countdown_s, forgiving, idle_s, shows_by_itself in [visit], "
     "found 'idle'"},
    {"[vist]\nidle_s = 60\n",
     "kiosk.toml, line 1: expected a section [screen], [languages], [visit], [haptics], [gallery], "
     "[sound], "
     "[hours], [sharing] or [staff], found 'vist'"},
    {"visit = 3\n",
     "kiosk.toml, line 1: expected a section [screen], [languages], [visit], [haptics], [gallery], "
     "[sound], "
     "[hours], [sharing] or [staff], found 'visit'"},
    {"[sound]\nvolume = 2.5\n", "kiosk.toml, line 2: expected a whole number, 0 to 5 for volume, found 2.5"},
    {"[staff]\npin = \"12\"\n",
     "kiosk.toml, line 2: expected 4 to 8 digits between quotes, or nothing for pin, found '12'"},
    {"[staff]\nlocked = 1\n", "kiosk.toml, line 2: expected true or false for locked, found 1"},
    {"[hours]\nopens = \"25:00\"\n",
     "kiosk.toml, line 2: expected a time as \"HH:MM\" for opens, found '25:00'"},
    {"[languages]\norder = []\n",
     "kiosk.toml, line 2: expected 1 to 8 language codes such as [\"ko\", \"en\"], each once for order, "
     "found a list"},
    {"[languages]\norder = [\"ko\"]\nfirst = \"en\"\n",
     "kiosk.toml, line 3: expected one of languages.order for first, found 'en'"},
    {"[languages]\norder = [\"ko\", \"ko\"]\n",
     "kiosk.toml, line 2: expected 1 to 8 language codes such as [\"ko\", \"en\"], each once for order, "
     "found a list"},
    {"[languages]\nfirst = \"english language\"\n",
     "kiosk.toml, line 2: expected a language code such as \"ko\" for first, found 'english language'"},
    {"[screen]\ndistance_mm = 60\n", "kiosk.toml, line 2: expected 200 to 5000 for distance_mm, found 60"},
    {"[screen]\ndiagonal_inch = \"24\"\n",
     "kiosk.toml, line 2: expected 7 to 120 for diagonal_inch, found '24'"},
    {"[screen]\nbackend = \"vulkan\"\n",
     "kiosk.toml, line 2: expected auto, gpu or cpu for backend, found 'vulkan'"},
    {"[screen]\nfull_screen = yes\n", "kiosk.toml, line 2: expected TOML, found "},
    {"[staff]\nlocked = tru\n", "kiosk.toml, line 2: expected TOML, found "},
    {"[sound]\nvolume = 6\n", "kiosk.toml, line 2: expected a whole number, 0 to 5 for volume, found 6"},
    {"[sound]\nvolume = 99999999999999999999\n", "kiosk.toml, line 2: expected TOML, found "},
    {"[staff]\npin = 1234\n",
     "kiosk.toml, line 2: expected 4 to 8 digits between quotes, or nothing for pin, found 1234"},
    {"[staff]\npin = \"12a4\"\n",
     "kiosk.toml, line 2: expected 4 to 8 digits between quotes, or nothing for pin, found '12a4'"},
    {"[staff]\ncloses_after_s = 5\n", "kiosk.toml, line 2: expected 10 to 600 for closes_after_s, found 5"},
    {"[staff]\nname = \"\"\n", "kiosk.toml, line 2: expected a name for name, found ''"},
    {"[gallery]\nmost_pots = 0\n",
     "kiosk.toml, line 2: expected a whole number, 1 to 100000 for most_pots, found 0"},
    {"[gallery]\nfolder = [\"out\"]\n", "kiosk.toml, line 2: expected a folder for folder, found a list"},
    {"[sharing]\nlisten = \"10.0.0.5 or so\"\n",
     "kiosk.toml, line 2: expected an address such as \"10.0.0.5\" or an interface such as \"wlan0\", "
     "without a "
     "port for listen, found '10.0.0.5 or so'"},
    {"[sharing]\nport = 0\n", "kiosk.toml, line 2: expected a whole number, 1 to 65535 for port, found 0"},
    {"[sharing]\npublic_url = \"museum.org/pots\"\n",
     "kiosk.toml, line 2: expected an address such as \"https://museum.org/pots\" for public_url, found "
     "'museum.org/pots'"},
    {"[sharing]\npublic_url = \"https://museum.org/\\\"onload=\"\n",
     "kiosk.toml, line 2: expected an address such as \"https://museum.org/pots\" for public_url, found "
     "'https://museum.org/\"onload='"},
    {"[sharing]\npublic_url = \"https:///pots\"\n",
     "kiosk.toml, line 2: expected an address such as \"https://museum.org/pots\" for public_url, found "
     "'https:///pots'"},
    {"[sharing]\n\nlisten = \"0.0.0.0\"\n",
     "kiosk.toml, line 3: expected public_url beside '0.0.0.0' for listen, so that phones learn where, "
     "found "
     "none"},
    {"[sharing]\nlicence = 4.0\n",
     "kiosk.toml, line 2: expected a text of 500 letters at most, or one a language such as { en = \"...\", "
     "ko "
     "= \"...\" } for licence, found 4"},
    {"[sharing]\nlicence = { e = \"CC0\" }\n",
     "kiosk.toml, line 2: expected a text of 500 letters at most, or one a language such as { en = \"...\", "
     "ko "
     "= \"...\" } for licence, found a table"},
    {"[sharing]\noutbox = \"\"\n", "kiosk.toml, line 2: expected a folder for outbox, found ''"},
    {"[sharing]\nwifi_key = \"short\"\n",
     "kiosk.toml, line 2: expected 8 to 63 letters between quotes, or nothing for wifi_key, found "
     "'short'"},
    {"[sharing]\nwifi_name = \"123456789012345678901234567890123\"\n",
     "kiosk.toml, line 2: expected a name of 32 letters at most for wifi_name, found "
     "'123456789012345678901234567890123'"},
    {"[sharing]\nhours = 169\n",
     "kiosk.toml, line 2: expected a whole number, 0 to 168 for hours, found 169"},
    {"[sharing]\nmost_pots = 0\n",
     "kiosk.toml, line 2: expected a whole number, 1 to 10000 for most_pots, found 0"},
    {"[sharing]\nmost_mb = 1\n", "kiosk.toml, line 2: expected 10 to 1000000 for most_mb, found 1"},
    {"[sharing]\nadress = \"\"\n",
     "kiosk.toml, line 2: expected one of counter, hours, licence, listen, most_mb, most_pots, outbox, "
     "port, public_url, publisher, wifi_key, wifi_name in [sharing], found 'adress'"},
    {"[hours]\nopens = 09:30:00\n",
     "kiosk.toml, line 2: expected a time as \"HH:MM\" for opens, found a date or a time"},
    {"[haptics]\nrate_hz = 20000\n", "kiosk.toml, line 2: expected 100 to 10000 for rate_hz, found 20000"},
    {"[visit]\nidle_s = 60\nidle_s = 70\n", "kiosk.toml, line 3: expected TOML, found "},
    {"[visit]\nidle_s = 60\n[visit]\ncountdown_s = 30\n", "kiosk.toml, line 3: expected TOML, found "},
    {"[visit.idle_s]\nseconds = 60\n", "kiosk.toml, line 1: expected 10 to 600 for idle_s, found a table"},
    {"staff.lock = true\n",
     "kiosk.toml, line 1: expected one of closes_after_s, locked, metrics_folder, name, pin, "
     "statistics_folder in "
     "[staff], "
     "found 'lock'"},
    {"[staff]\nname = \"\xff\"\n", "kiosk.toml, line 2: expected TOML, found "},
};

TEST(Config, RejectsEachErrorWithItsLineAndTheAllowedValues) {
    for (const auto& one : kMistakes) {
        const auto refused = read_config(one.toml, "kiosk.toml");
        ASSERT_FALSE(refused) << one.toml;
        // The library chooses the message for invalid TOML, but it must have the location and be one line.
        const std::string_view message = refused.error().message;
        if (std::string_view(one.message).ends_with("found ")) {
            EXPECT_TRUE(message.starts_with(one.message)) << message;
        } else {
            EXPECT_EQ(message, one.message);
        }
        EXPECT_EQ(message.find('\n'), std::string_view::npos) << message;
        EXPECT_EQ(refused.error().kind, ErrorKind::kBadInput);
    }
}

TEST(Config, TakesOtherAlphabetsInStringsAndAMarkOfByteOrder) {
    const auto config = read_config("\xEF\xBB\xBF# 가마\n[staff]\nname = \"가마 \\\" 窯\"\n", "kiosk.toml");
    ASSERT_TRUE(config) << config.error().message;
    EXPECT_EQ(config->staff.name, "가마 \" 窯");
}

TEST(Config, RejectsInvalidToml) {
    const auto refused = read_config("[visit\nidle_s = 4\n", "kiosk.toml");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message.rfind("kiosk.toml, line 1: expected TOML, found ", 0), 0U)
        << refused.error().message;
    EXPECT_EQ(refused.error().message.find('\n'), std::string::npos);
}

TEST(Config, TakesTheFirstOfTheOrderWhenEnglishIsNotAmongThem) {
    const auto config = read_config("[languages]\norder = [\"ko\", \"ar\"]\n", "kiosk.toml");
    ASSERT_TRUE(config) << config.error().message;
    EXPECT_EQ(config->languages.first, "ko");
}

TEST(Config, KnowsWhenTheMuseumIsOpen) {
    Config config;
    EXPECT_TRUE(is_open(config, 3 * 60)) << "equal times: always";
    config.hours = {10 * 60, 18 * 60};
    EXPECT_FALSE(is_open(config, 10 * 60 - 1));
    EXPECT_TRUE(is_open(config, 10 * 60));
    EXPECT_FALSE(is_open(config, 18 * 60));
    config.hours = {18 * 60, 60};
    EXPECT_TRUE(is_open(config, 30)) << "a night at the museum";
    EXPECT_FALSE(is_open(config, 12 * 60));
}

}  // namespace
}  // namespace onggi::kiosk
