// The museum's settings: one commented TOML file, every key optional. Any thread.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/core/result.h"
#include "game/kiosk/rules.h"

namespace onggi::kiosk {

// Bytes per megabyte, in the settings and on the staff panel.
constexpr double kBytesPerMb = 1e6;

// A text of the house: pairs of language code and text, or one text without a code; empty: none.
using HouseText = std::vector<std::pair<std::string, std::string>>;

struct Config {
    struct {
        double diagonal_inch = 24.0;
        double distance_mm = 600.0;  // from the eyes; text is sized for it
        bool full_screen = false;
        bool text_always_large = false;
        std::string room;              // folder of room photographs, or a .glb; empty: the built-in room
        std::string backend = "auto";  // renderer: "gpu", "cpu" or "auto" (the GPU if there is one)
    } screen;
    struct {
        std::vector<std::string> order{"ko", "en", "ar"};  // codes; also the order of the attract screen
        std::string first = "en";                          // language at the start of a visit
        std::string folder;                                // of CODE.tsv files that replace or add languages
        bool own_digits = true;                            // Arabic-Indic digits in Arabic
    } languages;
    struct {
        double idle_s = 45.0;
        double countdown_s = 20.0;
        bool forgiving = true;        // the clay tolerates more than real clay
        bool shows_by_itself = true;  // demonstrate a step when the visitor makes no progress
    } visit;
    struct {
        double rate_hz = 0.0;  // 0: 4000 with real-time scheduling, else 1000
        bool devices = true;   // look for haptic devices on USB
    } haptics;
    struct {
        std::string folder = "out";
        int most_pots = 500;           // beyond this the oldest are deleted
        double least_free_mb = 200.0;  // disk space; below this no pot is saved
        bool wall = false;             // visitors may put their pot on the wall of the day
    } gallery;
    struct {
        int volume = 3;               // 0 to 5
        bool remember_staff = false;  // staff settings survive a restart
        bool captions = false;
        std::string spoken_folder;          // holds LANGUAGE/KEY.wav; empty: spoken/ in the program's assets
        std::string speech = "headphones";  // synthetic speech: "on", "off", or with headphones plugged in
        int speech_rate = 160;              // words a minute
        int speech_volume = 100;            // percent, beside the wheel's sound
    } sound;
    struct {
        int opens_min = 0;  // minutes after midnight; equal: always open
        int closes_min = 0;
    } hours;
    struct {
        std::string listen;             // address or interface of the server; empty: no server
        int port = 8080;                //
        std::string public_url;         // address of the outbox for phones; empty: the server's own
        std::string outbox = "outbox";  // the folder that is served
        std::string wifi_name;          // network that phones join first; empty: no Wi-Fi code
        std::string wifi_key;           //
        int hours = 0;                  // how long a pot stays; 0: until the end of the day
        int most_pots = 200;            // beyond this the oldest are deleted
        double most_mb = 1000.0;        // total size of the outbox
        std::string counter;            // pipe that reports opened pages; empty: do not count
        HouseText licence;              // of the files that leave, written into them
        HouseText publisher;            // the museum, likewise
    } sharing;
    struct {
        std::string pin;  // 4 to 8 digits; empty: no staff panel
        bool locked = false;
        double closes_after_s = 120.0;  // without a touch
        std::string name = "wheel";     // name of this unit on the staff panel
        std::string statistics_folder;  // empty: statistics/ in the gallery
        std::string metrics_folder;     // for node_exporter's text files; empty: write none
    } staff;
};

// `file` is the name in messages. Invalid TOML, an unknown key or a bad value is an error that names the
// file, the line, the allowed values and the value found.
Result<Config> read_config(std::string_view toml, const std::string& file);

// Whether the museum is open at that minute; opening hours may pass midnight.
[[nodiscard]] bool is_open(const Config& config, int minute_of_day);

// Whether visitors can take pots home by phone, over this program's server or the museum's own.
[[nodiscard]] bool shares(const Config& config);

// The rules of the flow that follow from the configuration. The caller sets language_count and
// default_language, which depend on the languages that could be read.
[[nodiscard]] Rules rules_of(const Config& config);

}  // namespace onggi::kiosk
