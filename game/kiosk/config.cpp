#include "game/kiosk/config.h"

#include <fmt/format.h>
#include <idn2.h>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>

#include "engine/core/number_in.h"
#include "engine/core/quote.h"
#include "game/kiosk/state.h"

// Compiled header-only, because the packaged library throws exceptions. toml++'s assertions fail on malformed
// input ("[!]"), and with NDEBUG clang takes them as optimiser hints. With both disabled, malformed input is
// a parse error.
#define TOML_HEADER_ONLY 1
#define TOML_EXCEPTIONS 0
#define TOML_ASSERT(claim) static_assert(true)
#pragma push_macro("NDEBUG")
#undef NDEBUG
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")

namespace onggi::kiosk {
namespace {

struct Setting {
    std::string_view allowed;
    // Returns false if the value has another type or is out of bounds.
    std::function<bool(const toml::node&)> take;
};

Setting number(double& into, double least, double most, std::string_view allowed) {
    return {allowed, [&into, least, most](const toml::node& node) {
                const auto value = node.is_number() ? node.value<double>() : std::nullopt;
                if (!value || !(*value >= least && *value <= most)) return false;
                into = *value;
                return true;
            }};
}

Setting whole(int& into, int least, int most, std::string_view allowed) {
    return {allowed, [&into, least, most](const toml::node& node) {
                const auto value = node.is_integer() ? node.value<std::int64_t>() : std::nullopt;
                if (!value || *value < least || *value > most) return false;
                into = static_cast<int>(*value);
                return true;
            }};
}

Setting yes_or_no(bool& into) {
    return {"true or false", [&into](const toml::node& node) {
                const auto value = node.is_boolean() ? node.value<bool>() : std::nullopt;
                if (value) into = *value;
                return value.has_value();
            }};
}

Setting words(std::string& into, std::string_view allowed, std::function<bool(const std::string&)> is_good) {
    return {allowed, [&into, is_good = std::move(is_good)](const toml::node& node) {
                const auto value = node.is_string() ? node.value<std::string>() : std::nullopt;
                if (!value || !is_good(*value)) return false;
                into = *value;
                return true;
            }};
}

bool is_language_code(const std::string& code) {
    return code.size() >= 2 && code.size() <= 12 && std::all_of(code.begin(), code.end(), [](char letter) {
               return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || letter == '-';
           });
}

bool is_pin(const std::string& pin) {
    const bool digits = std::all_of(pin.begin(), pin.end(), [](char c) { return c >= '0' && c <= '9'; });
    return digits && (pin.empty() || (pin.size() >= 4 && pin.size() <= 8));
}

// Whether a port stands behind an address or interface: "10.0.0.5:80", "wlan0:8080". An interface may have
// aliases ("eth0:1"), numbered from 0 on.
bool has_port(const std::string& text) {
    constexpr int kMostAliases = 79;
    const std::size_t colon = text.find(':');
    if (colon == std::string::npos || colon != text.rfind(':')) return false;
    return text.find('.') < colon || number_in<int>(text.substr(colon + 1)).value_or(0) > kMostAliases;
}

// "10.0.0.5", "fd00::5", "wlan0"; only the machine that listens can resolve it.
bool is_address_or_interface(const std::string& text) {
    return text.size() <= 45 && !has_port(text) && std::all_of(text.begin(), text.end(), [](char letter) {
               return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
                      (letter >= '0' && letter <= '9') ||
                      std::string_view(".:-_@").find(letter) != std::string_view::npos;
           });
}

bool is_unreserved(char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
           (letter >= '0' && letter <= '9') ||
           std::string_view(":/.-_~[]").find(letter) != std::string_view::npos;
}

// An address as phones need it: http:// or https://, in small letters, the host in ASCII (IDNA 2008), and
// characters that need no percent-encoding (RFC 3986). Empty: it is none.
std::optional<std::string> web_address(const std::string& text) {
    constexpr std::size_t kMostBytes = 200;
    const std::size_t scheme_end = text.find("://");
    if (scheme_end == std::string::npos || text.size() > kMostBytes) return std::nullopt;
    std::string scheme = text.substr(0, scheme_end);
    std::transform(scheme.begin(), scheme.end(), scheme.begin(),
                   [](char letter) { return letter >= 'A' && letter <= 'Z' ? letter - 'A' + 'a' : letter; });
    const std::string rest = text.substr(scheme_end + 3);
    const bool is_ipv6 = rest.starts_with('[');
    const std::size_t host_end = is_ipv6 ? 0 : std::min(rest.find_first_of(":/"), rest.size());
    std::string host = rest.substr(0, host_end);
    if ((scheme != "http" && scheme != "https") || (host.empty() && !is_ipv6)) return std::nullopt;
    if (!std::all_of(host.begin(), host.end(), is_unreserved)) {
        char* ascii = nullptr;
        if (::idn2_to_ascii_8z(host.c_str(), &ascii, IDN2_NFC_INPUT | IDN2_NONTRANSITIONAL) != IDN2_OK)
            return std::nullopt;
        host = ascii;
        ::idn2_free(ascii);
    }
    std::string address = scheme + "://" + host + rest.substr(host_end);
    if (!std::all_of(address.begin(), address.end(), is_unreserved)) return std::nullopt;
    return address;
}

Setting web_address_or_nothing(std::string& into) {
    return {"an address such as \"https://museum.org/pots\"", [&into](const toml::node& node) {
                const auto value = node.is_string() ? node.value<std::string>() : std::nullopt;
                const auto address = value && !value->empty() ? web_address(*value) : value;
                if (address) into = *address;
                return address.has_value();
            }};
}

Setting codes(std::vector<std::string>& into) {
    return {"1 to 8 language codes such as [\"ko\", \"en\"], each once", [&into](const toml::node& node) {
                const toml::array* array = node.as_array();
                if (array == nullptr || array->empty() || array->size() > 8) return false;
                std::vector<std::string> read;
                for (const toml::node& item : *array) {
                    const auto code = item.is_string() ? item.value<std::string>() : std::nullopt;
                    if (!code || !is_language_code(*code)) return false;
                    if (std::find(read.begin(), read.end(), *code) != read.end()) return false;
                    read.push_back(*code);
                }
                into = std::move(read);
                return true;
            }};
}

// "CC BY 4.0", or { en = "CC BY 4.0", ko = "..." }.
Setting house_text(HouseText& into) {
    return {"a text of 500 letters at most, or one a language such as { en = \"...\", ko = \"...\" }",
            [&into](const toml::node& node) {
                constexpr std::size_t kMostBytes = 500;
                HouseText read;
                const auto take = [&](const std::string& code, const toml::node& one) {
                    const auto text = one.is_string() ? one.value<std::string>() : std::nullopt;
                    if (!text || text->size() > kMostBytes) return false;
                    if (!text->empty()) read.emplace_back(code, *text);
                    return true;
                };
                if (const toml::table* table = node.as_table()) {
                    for (const auto& [code, one] : *table)
                        if (!is_language_code(std::string(code.str())) || !take(std::string(code.str()), one))
                            return false;
                } else if (!take("", node)) {
                    return false;
                }
                into = std::move(read);
                return true;
            }};
}

// "HH:MM" as minutes after midnight.
Setting time_of_day(int& into) {
    return {"a time as \"HH:MM\"", [&into](const toml::node& node) {
                const auto text = node.is_string() ? node.value<std::string>() : std::nullopt;
                if (!text || text->size() != 5 || (*text)[2] != ':') return false;
                const int hours = number_in<int>(text->substr(0, 2)).value_or(-1);
                const int minutes = number_in<int>(text->substr(3)).value_or(-1);
                if (hours < 0 || minutes < 0 || minutes > 59 || hours * 60 + minutes > 24 * 60) return false;
                into = hours * 60 + minutes;
                return true;
            }};
}

std::map<std::string, Setting> settings_of(Config& config) {
    const auto anything = [](const std::string&) { return true; };
    const auto something = [](const std::string& text) { return !text.empty() && text.size() <= 255; };
    return {
        {"screen.backend",
         words(config.screen.backend, "auto, gpu or cpu",
               [](const std::string& text) { return text == "auto" || text == "gpu" || text == "cpu"; })},
        {"screen.diagonal_inch", number(config.screen.diagonal_inch, 7.0, 120.0, "7 to 120")},
        {"screen.distance_mm", number(config.screen.distance_mm, 200.0, 5000.0, "200 to 5000")},
        {"screen.full_screen", yes_or_no(config.screen.full_screen)},
        {"screen.room", words(config.screen.room, "a folder or a .glb file", anything)},
        {"screen.text_always_large", yes_or_no(config.screen.text_always_large)},
        {"languages.order", codes(config.languages.order)},
        {"languages.first",
         words(config.languages.first, "a language code such as \"ko\"", is_language_code)},
        {"languages.folder", words(config.languages.folder, "a folder", anything)},
        {"languages.own_digits", yes_or_no(config.languages.own_digits)},
        {"visit.idle_s", number(config.visit.idle_s, 10.0, 600.0, "10 to 600")},
        // WCAG 2.1, 2.2.1: at least 20 s to continue with one simple action.
        {"visit.countdown_s", number(config.visit.countdown_s, 20.0, 120.0, "20 to 120")},
        {"visit.forgiving", yes_or_no(config.visit.forgiving)},
        {"visit.shows_by_itself", yes_or_no(config.visit.shows_by_itself)},
        {"haptics.rate_hz", number(config.haptics.rate_hz, 100.0, 10000.0, "100 to 10000")},
        {"haptics.devices", yes_or_no(config.haptics.devices)},
        {"gallery.folder", words(config.gallery.folder, "a folder", something)},
        {"gallery.most_pots", whole(config.gallery.most_pots, 1, 100000, "a whole number, 1 to 100000")},
        {"gallery.least_free_mb", number(config.gallery.least_free_mb, 1.0, 1e6, "1 to 1000000")},
        {"gallery.wall", yes_or_no(config.gallery.wall)},
        {"sound.volume", whole(config.sound.volume, 0, kMostVolume, "a whole number, 0 to 5")},
        {"sound.remember_staff", yes_or_no(config.sound.remember_staff)},
        {"sound.captions", yes_or_no(config.sound.captions)},
        {"sound.spoken_folder", words(config.sound.spoken_folder, "a folder", anything)},
        {"sound.speech", words(config.sound.speech, "headphones, on or off",
                               [](const std::string& text) {
                                   return text == "headphones" || text == "on" || text == "off";
                               })},
        {"sound.speech_rate", whole(config.sound.speech_rate, 80, 450, "a whole number, 80 to 450")},
        {"sound.speech_volume", whole(config.sound.speech_volume, 0, 200, "a whole number, 0 to 200")},
        {"hours.opens", time_of_day(config.hours.opens_min)},
        {"hours.closes", time_of_day(config.hours.closes_min)},
        {"sharing.listen",
         words(config.sharing.listen,
               "an address such as \"10.0.0.5\" or an interface such as \"wlan0\", without a port",
               is_address_or_interface)},
        {"sharing.port", whole(config.sharing.port, 1, 65535, "a whole number, 1 to 65535")},
        {"sharing.public_url", web_address_or_nothing(config.sharing.public_url)},
        {"sharing.outbox", words(config.sharing.outbox, "a folder", something)},
        {"sharing.wifi_name", words(config.sharing.wifi_name, "a name of 32 letters at most",
                                    [](const std::string& text) { return text.size() <= 32; })},
        {"sharing.wifi_key", words(config.sharing.wifi_key, "8 to 63 letters between quotes, or nothing",
                                   [](const std::string& text) {
                                       return text.empty() || (text.size() >= 8 && text.size() <= 63);
                                   })},
        {"sharing.hours", whole(config.sharing.hours, 0, 168, "a whole number, 0 to 168")},
        {"sharing.most_pots", whole(config.sharing.most_pots, 1, 10000, "a whole number, 1 to 10000")},
        {"sharing.most_mb", number(config.sharing.most_mb, 10.0, 1e6, "10 to 1000000")},
        {"sharing.counter", words(config.sharing.counter, "a file", anything)},
        {"sharing.licence", house_text(config.sharing.licence)},
        {"sharing.publisher", house_text(config.sharing.publisher)},
        {"staff.pin", words(config.staff.pin, "4 to 8 digits between quotes, or nothing", is_pin)},
        {"staff.locked", yes_or_no(config.staff.locked)},
        {"staff.closes_after_s", number(config.staff.closes_after_s, 10.0, 600.0, "10 to 600")},
        {"staff.name", words(config.staff.name, "a name", something)},
        {"staff.statistics_folder", words(config.staff.statistics_folder, "a folder", anything)},
        {"staff.metrics_folder", words(config.staff.metrics_folder, "a folder", anything)},
    };
}

// The value approximately as the file wrote it.
std::string shown_value(const toml::node& node) {
    if (const auto text = node.value<std::string>(); node.is_string() && text) return in_quotes(*text);
    if (node.is_table()) return "a table";
    if (node.is_array()) return "a list";
    if (node.is_boolean()) return *node.value<bool>() ? "true" : "false";
    if (const auto value = node.value<double>(); node.is_number() && value) return fmt::format("{}", *value);
    return "a date or a time";
}

Error at(const std::string& file, const toml::source_region& where, std::string_view text) {
    return bad_input(fmt::format("{}, line {}: {}", file, where.begin.line, text));
}

std::string keys_under(const std::map<std::string, Setting>& settings, std::string_view table) {
    std::string list;
    for (const auto& [name, setting] : settings) {
        const std::string_view whole_name = name;
        if (!whole_name.starts_with(table)) continue;
        if (!list.empty()) list += ", ";
        list += whole_name.substr(table.size());
    }
    return list;
}

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

// Finds a non-ASCII character outside strings and comments, where TOML allows none. toml++ 3.2 looks such
// characters up in a table of spaces, and some of them, such as U+FCFF, read beyond its end. Multi-line
// strings are not supported; no setting has one. Returns the line, counted from 1, or nothing if there is
// none.
std::optional<std::pair<int, std::string_view>> out_of_place(std::string_view text) {
    int line = 1;
    char quote = '\0';  // the quote of the current string, or # in a comment
    for (std::size_t i = text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0; i < text.size(); ++i) {
        const char letter = text[i];
        if (letter == '\n') {
            ++line;
            quote = '\0';
        } else if (quote == '\0') {
            if (static_cast<unsigned char>(letter) >= 0x80)
                return std::pair(line, "a letter of another alphabet");
            const std::string_view rest = text.substr(i);
            if (rest.starts_with("\"\"\"") || rest.starts_with("'''")) return std::pair(line, "three quotes");
            if (letter == '"' || letter == '\'' || letter == '#') quote = letter;
        } else if (letter == '\\' && quote == '"') {
            ++i;
        } else if (letter == quote && quote != '#') {
            quote = '\0';
        }
    }
    return std::nullopt;
}

// Replaces each non-ASCII byte by an ASCII letter. If the result is valid TOML, its strings are where
// out_of_place() assumed them, and non-ASCII characters in strings are harmless.
std::string in_plain_letters(std::string_view text) {
    if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
    std::string plain(text);
    for (char& letter : plain)
        if (static_cast<unsigned char>(letter) >= 0x80) letter = '?';
    return plain;
}

}  // namespace

Result<Config> read_config(std::string_view toml_text, const std::string& file) {
    if (const auto found = out_of_place(toml_text)) {
        return bad_input(fmt::format(
            "{}, line {}: expected plain letters outside of quotes, each string on one line, found {}", file,
            found->first, found->second));
    }
    toml::parse_result parsed = toml::parse(in_plain_letters(toml_text));
    if (parsed) parsed = toml::parse(toml_text);
    if (!parsed) {
        const toml::parse_error& error = parsed.error();
        return at(file, error.source(),
                  fmt::format("expected TOML, found {}", shown_path(error.description())));
    }
    Config config;
    const std::map<std::string, Setting> settings = settings_of(config);
    for (const auto& [section, content] : parsed.table()) {
        const std::string section_name(section.str());
        const std::string prefix = section_name + ".";
        const toml::table* table = content.as_table();
        const std::string known = keys_under(settings, prefix);
        if (table == nullptr || known.empty()) {
            return at(file, section.source(),
                      fmt::format("expected a section [screen], [languages], [visit], [haptics], [gallery], "
                                  "[sound], [hours], [sharing] or [staff], found {}",
                                  in_quotes(section_name)));
        }
        for (const auto& [key, value] : *table) {
            const auto found = settings.find(prefix + std::string(key.str()));
            if (found == settings.end()) {
                return at(file, key.source(),
                          fmt::format("expected one of {} in [{}], found {}", known, section_name,
                                      in_quotes(key.str())));
            }
            if (!found->second.take(value)) {
                return at(file, value.source(),
                          fmt::format("expected {} for {}, found {}", found->second.allowed, key.str(),
                                      shown_value(value)));
            }
        }
    }
    const auto& order = config.languages.order;
    if (std::find(order.begin(), order.end(), config.languages.first) == order.end()) {
        // An error only if the file sets languages.first; it may list languages without the default, English.
        if (const toml::node* first = parsed.table().at_path("languages.first").node()) {
            return at(file, first->source(),
                      fmt::format("expected one of languages.order for first, found {}",
                                  in_quotes(config.languages.first)));
        }
        config.languages.first = order.front();
    }
    const auto& sharing = config.sharing;
    const bool listens_everywhere = sharing.listen == "0.0.0.0" || sharing.listen == "::";
    if (listens_everywhere && sharing.public_url.empty()) {
        return at(
            file, parsed.table().at_path("sharing.listen").node()->source(),
            fmt::format("expected public_url beside {} for listen, so that phones learn where, found none",
                        in_quotes(sharing.listen)));
    }
    return config;
}

bool is_open(const Config& config, int minute_of_day) {
    const int opens = config.hours.opens_min;
    const int closes = config.hours.closes_min;
    if (opens == closes) return true;
    if (opens < closes) return minute_of_day >= opens && minute_of_day < closes;
    return minute_of_day >= opens || minute_of_day < closes;
}

bool shares(const Config& config) {
    return !config.sharing.listen.empty() || !config.sharing.public_url.empty();
}

Rules rules_of(const Config& config) {
    Rules rules;
    rules.idle_s = config.visit.idle_s;
    rules.countdown_s = config.visit.countdown_s;
    rules.shows_by_itself = config.visit.shows_by_itself;
    rules.shares = shares(config);
    rules.has_wall = config.gallery.wall;
    rules.has_wifi = !config.sharing.wifi_name.empty();
    rules.default_volume = config.sound.volume;
    rules.offers_speech = config.sound.speech != "off";
    rules.speaks = config.sound.speech == "on";
    rules.default_text_size = config.screen.text_always_large ? 2 : 1;
    rules.locked = config.staff.locked;
    rules.staff_locks_s = config.staff.closes_after_s;
    rules.pin_digits = static_cast<int>(config.staff.pin.size());
    rules.pin = number_in<decltype(rules.pin)>(config.staff.pin).value_or(rules.pin);
    return rules;
}

}  // namespace onggi::kiosk
