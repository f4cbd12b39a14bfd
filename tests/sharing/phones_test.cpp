// Two hundred phones fetch everything from a pot's folder, all at once and again and again, while a pot is
// thrown at 4 kHz and drawn beside the server on the same machine: alternating with periods without phones,
// in one run. In a museum the phones are other machines, so here they run with idle priority.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sched.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "tests/sharing/http_client.h"
#include "tests/sharing/served_outbox.h"
#include "tests/support/places.h"

namespace onggi::test {
namespace {

constexpr int kPhones = 200;
constexpr int kRateHz = 4000;
constexpr int kTurns = 3;
constexpr int kMostTurns = 8;  // where other load has made all turns beside phones slow

// Sizes of a real pot's files; incompressible bytes.
std::vector<std::byte> any_bytes(std::size_t count, std::uint32_t seed) {
    std::vector<std::byte> bytes;
    bytes.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        seed = seed * 1664525U + 1013904223U;
        bytes.push_back(static_cast<std::byte>(seed >> 24U));
    }
    return bytes;
}

sharing::SharedPot pot_of_real_size() {
    constexpr std::size_t kKilobyte = 1000;
    sharing::SharedPot pot = support::full_pot("one");
    pot.model_glb.bytes = any_bytes(700 * kKilobyte, 1);
    pot.print_stl.bytes = any_bytes(1500 * kKilobyte, 2);
    pot.print_3mf.bytes = any_bytes(600 * kKilobyte, 3);
    pot.film.bytes = any_bytes(450 * kKilobyte, 4);
    return pot;
}

// All paths that a phone can request, and the expected content.
std::map<std::string, std::string> everything_in(const std::filesystem::path& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (name.front() != '.' && entry.path().extension() != ".gz") files[name] = content_of(entry.path());
    }
    return files;
}

class Phones {
  public:
    Phones(int port, const std::string& code, const std::map<std::string, std::string>& files)
        : files_(files),
          thread_([this, port, code] { fetch(port, code); }) {}
    Phones(const Phones&) = delete;
    Phones& operator=(const Phones&) = delete;
    ~Phones() { leave(); }

    // Leaves when everything requested has arrived.
    void leave() {
        leaving_ = true;
        if (thread_.joinable()) thread_.join();
    }
    [[nodiscard]] long files() const { return fetched_; }
    [[nodiscard]] long asked_again() const { return asked_again_; }
    [[nodiscard]] const std::string& trouble() const { return trouble_; }

  private:
    void fetch(int port, const std::string& code) {
        const sched_param none{};
        if (::sched_setscheduler(0, SCHED_IDLE, &none) != 0) trouble_ = "phones would take what frames need";
        while (!leaving_ && trouble_.empty())
            wave(port, code);
    }

    // Every phone from an address of its own; all have asked before the first is listened to.
    void wave(int port, const std::string& code) {
        constexpr std::uint32_t kFirstAddress = 0x7f010001;
        constexpr int kWaitMs = 30'000;
        std::vector<std::unique_ptr<HttpClient>> phones;
        const auto connect = [&](std::size_t phone) {
            return std::make_unique<HttpClient>(port, kWaitMs,
                                                kFirstAddress + static_cast<std::uint32_t>(phone));
        };
        for (std::size_t i = 0; i < kPhones; ++i)
            phones.push_back(connect(i));
        for (const auto& [name, bytes] : files_) {
            const std::string request = "GET /" + code + "/" + name + " HTTP/1.1\r\nHost: pots\r\n\r\n";
            for (const auto& phone : phones)
                phone->say(request);
            for (std::size_t i = 0; i < phones.size(); ++i) {
                HttpAnswer answer = phones[i]->answer();
                // In a crowd the server closes connections that are silent for a second, as phones of idle
                // priority may be; a browser then asks again on a new one (RFC 9112, 9.3.1).
                if (answer.status == 0) {
                    phones[i] = connect(i);
                    phones[i]->say(request);
                    answer = phones[i]->answer();
                    ++asked_again_;
                }
                if (answer.status != 200 || answer.body != bytes) {
                    trouble_ = fmt::format("{}: expected {} bytes, found status {} with {}", name,
                                           bytes.size(), answer.status, answer.body.size());
                    return;
                }
                ++fetched_;
            }
        }
    }

    const std::map<std::string, std::string>& files_;
    std::atomic<bool> leaving_ = false;
    std::atomic<long> fetched_ = 0;
    std::atomic<long> asked_again_ = 0;
    std::string trouble_;  // belongs to the thread until it is joined
    std::thread thread_;
};

struct Times {
    double tick_us = 0.0;   // the work of a tick, 99th of 100
    double wake_us = 0.0;   // how late one began
    double frame_ms = 0.0;  // the work of a frame
};

Times wheel_at_work(const TemporaryFolder& folder) {
    const std::string stats = (folder / "stats.json").string();
    const ProgramRun run = run_onggi({"live", in_checkout("assets/gestures/attract.csv"), "--headless",
                                      "--rate", std::to_string(kRateHz), "--seconds", "5", "--stats", stats});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    const auto found = nlohmann::json::parse(content_of(stats));
    EXPECT_EQ(found.at("rate_hz"), kRateHz);
    return {.tick_us = found.at("tick_ns").at("p99").get<double>() / 1000.0,
            .wake_us = found.at("wake_latency_us").at("p99").get<double>(),
            .frame_ms = found.at("frame_ms").at("p99").get<double>()};
}

// The process's peak memory, MB.
double most_memory_mb(int process) {
    std::ifstream status(fmt::format("/proc/{}/status", process));
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) / 1024.0;
    return 0.0;
}

// Other load makes a turn slower, never faster: take the least.
double least(const std::vector<Times>& turns, double Times::*time) {
    double found = turns.front().*time;
    for (const Times& turn : turns)
        found = std::min(found, turn.*time);
    return found;
}

// The phones' own copying shares caches and memory here, unlike in a museum: a quarter more time was measured
// on an idle machine.
constexpr double kMostRatio = 1.6;

bool are_not_delayed(const std::vector<Times>& alone, const std::vector<Times>& beside, double Times::*time,
                     double tolerated = 0.0) {
    return least(beside, time) <= kMostRatio * least(alone, time) + tolerated;
}

TEST(Phones, TwoHundredAtOnceDelayNeitherTheWheelNorThePicture) {
    ServedOutbox served;
    const std::string code = served.put(pot_of_real_size());
    const auto files = everything_in(served.box() / code);
    ASSERT_GE(files.size(), 10U);
    std::vector<Times> alone;
    std::vector<Times> beside;
    long fetched = 0;
    long asked_again = 0;
    // Short times on a machine that is shared by others are coarse, so a part of the period of 250 us is
    // tolerated beside the ratio. The phones' copying takes caches and units of a core that is one of two
    // threads, and the kernel finishes its own part of a phone's request before it wakes the wheel.
    constexpr double kPeriodUs = 1e6 / kRateHz;
    const auto checks = [&] {
        return std::map<std::string, bool>{
            {"frame", are_not_delayed(alone, beside, &Times::frame_ms)},
            {"tick", are_not_delayed(alone, beside, &Times::tick_us, 0.02 * kPeriodUs)},
            {"wake", are_not_delayed(alone, beside, &Times::wake_us, 0.25 * kPeriodUs)}};
    };
    const auto hold = [&] {
        const auto found = checks();
        return std::all_of(found.begin(), found.end(), [](const auto& check) { return check.second; });
    };
    for (int turn = 0; turn < kTurns || (turn < kMostTurns && !hold()); ++turn) {
        alone.push_back(wheel_at_work(served.folder()));
        Phones phones(served.port(), code, files);
        beside.push_back(wheel_at_work(served.folder()));
        phones.leave();
        EXPECT_EQ(phones.trouble(), "");
        fetched += phones.files();
        asked_again += phones.asked_again();
    }
    for (const auto& [name, turns] : {std::pair{"alone", &alone}, {"beside phones", &beside}})
        for (const Times& turn : *turns)
            fmt::print("{}: tick {:.2f} us, woken {:.1f} us late, frame {:.2f} ms (p99 each)\n", name,
                       turn.tick_us, turn.wake_us, turn.frame_ms);
    const double memory_mb = most_memory_mb(served.server().process());
    fmt::print("{} files to {} phones, {} asked for again; the server held {:.1f} MB at most\n", fetched,
               kPhones, asked_again, memory_mb);
    EXPECT_GE(fetched, static_cast<long>(kPhones * files.size())) << "less than everything to each";
    EXPECT_GT(memory_mb, 0.0);
    EXPECT_LE(memory_mb, 64.0);
    for (const auto& [name, holds] : checks())
        EXPECT_TRUE(holds) << name;
}

}  // namespace
}  // namespace onggi::test
