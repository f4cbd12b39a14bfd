// The museum's settings: one commented TOML file, every key optional. Any thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "game/kiosk/step.h"

namespace onggi::kiosk {

// A megabyte of the settings, and of what the staff reads.
constexpr double kBytesPerMb = 1e6;

struct Config {
    struct {
        double diagonal_inch = 24.0;
        double distance_mm = 600.0;  // from the eyes; text is sized for it
        bool full_screen = false;
        bool text_always_large = false;
        std::string room;              // a folder with its photographs, or a .glb; empty: the program's own
        std::string backend = "auto";  // who draws: "gpu", "cpu", or the GPU where there is one
    } screen;
    struct {
        std::vector<std::string> order{"ko", "en", "ar"};  // codes; also the order of the attract screen
        std::string first = "en";                          // what a visit begins in
        std::string folder;                                // with CODE.tsv files that replace or add
        bool own_digits = true;                            // Arabic-Indic digits in Arabic
    } languages;
    struct {
        double idle_s = 45.0;
        double countdown_s = 20.0;
        bool forgiving = true;        // the clay bears more than real clay
        bool shows_by_itself = true;  // a step of the lesson of which nothing comes
    } visit;
    struct {
        double rate_hz = 0.0;  // 0: 4000 where real time is granted, else 1000
        bool devices = true;   // look for hands on USB
    } haptics;
    struct {
        std::string folder = "out";
        int most_pots = 500;           // the oldest leave first
        double least_free_mb = 200.0;  // of disk; below it nothing is saved
        bool wall = false;             // of the day's pots: visitors may put theirs there
    } gallery;
    struct {
        int volume = 3;               // 0 to 5
        bool remember_staff = false;  // what the staff set counts after a restart too
        bool captions = false;
        std::string spoken_folder;  // of LANGUAGE/KEY.wav; empty: spoken/ beside the program's other assets
    } sound;
    struct {
        int opens_min = 0;  // minutes after midnight; equal: always open
        int closes_min = 0;
    } hours;
    struct {
        std::string listen;             // address or interface of the server; empty: none runs
        int port = 8080;                //
        std::string public_url;         // where phones find the outbox; empty: the server
        std::string outbox = "outbox";  // the folder that is served
        std::string wifi_name;          // to join before; empty: no first code
        std::string wifi_key;           //
        int hours = 0;                  // that a pot stays; 0: until the end of the day
        int most_pots = 200;            // the oldest leave first
        double most_mb = 1000.0;        // of all together
        std::string counter;            // the pipe that says how often pages are opened; empty: none
    } sharing;
    struct {
        std::string pin;  // 4 to 8 digits; empty: no staff panel
        bool locked = false;
        double closes_after_s = 120.0;  // without a touch
        std::string name = "wheel";     // of this unit, for the staff panel
        std::string statistics_folder;  // empty: statistics/ in the gallery
        std::string metrics_folder;     // of node_exporter's text files; empty: none
    } staff;
};

// `file` is what messages call it. Bad input: file, line, what is allowed, what was found; also for a key
// that is not known and for what is not TOML.
Result<Config> read_config(std::string_view toml, const std::string& file);

// Whether the museum is open then; hours may pass midnight.
[[nodiscard]] bool is_open(const Config& config, int minute_of_day);

// Whether pots are taken home by phone at all: over the server, or over the house's own.
[[nodiscard]] bool shares(const Config& config);

// The rules of the flow that follow from it. language_count and default_language are the program's to set:
// they depend on what could be read.
[[nodiscard]] Rules rules_of(const Config& config);

}  // namespace onggi::kiosk
