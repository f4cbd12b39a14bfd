// clay_peers ROUNDS PLOT.dat: a Markdown table on standard output, and the times for its plot.
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <string>
#include <vector>

#include "model.h"

namespace onggi::peers {
namespace {

constexpr int kRows[] = {200, 400, 800, 2000};
constexpr int kRowsOfErrors = 400;
constexpr double kDepthMm = 1.0;
constexpr double kDepthSwingMm = 0.2;
constexpr int kPeriodTicks = 64;
constexpr double kRoundS = 0.1;
constexpr double kHapticTickUs = 1000.0;

const Peer kPeers[] = {
    {"paper's cylindrical elements", paper_clay, 2000, Peer::Force::kOwnConstants, 1, 500},
    {"studio clay", studio_clay, 2000, Peer::Force::kOwnConstants, 2, 2000},
    {"Bullet, soft body", bullet_soft_body, 800, Peer::Force::kOwnConstants, 200, 300},
    {"OpenVDB, sculpting", openvdb_sculpting, 800, Peer::Force::kNone, 1, 500},
    {"finite elements, linear (GetFEM)", linear_finite_elements, 2000},
    {"finite elements, corotational (GetFEM)", corotational_finite_elements, 2000, Peer::Force::kOfModulus, 8,
     8},
    {"long elements", long_elements, 2000},
    {"boundary elements", boundary_elements, 2000},
};

double seconds_of(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// The median tick of a round, us: processor time, or the clock where a tick is shorter than reading processor
// time.
double median_tick_us(Model& model) {
    std::vector<double> ticks_us;
    double spent_s = 0.0;
    while (ticks_us.size() < 5 || (spent_s < kRoundS && ticks_us.size() < 5000)) {
        const double turn = 2.0 * kPi * static_cast<double>(ticks_us.size() % kPeriodTicks) / kPeriodTicks;
        model.restore();
        const double processor_s = seconds_of(CLOCK_THREAD_CPUTIME_ID);
        const double clock_s = seconds_of(CLOCK_MONOTONIC);
        model.tick(kDepthMm + kDepthSwingMm * std::sin(turn));
        const double by_clock_s = seconds_of(CLOCK_MONOTONIC) - clock_s;
        const double by_processor_s = seconds_of(CLOCK_THREAD_CPUTIME_ID) - processor_s;
        const double taken_s = by_processor_s > 1e-4 ? by_processor_s : by_clock_s;
        spent_s += taken_s;
        ticks_us.push_back(1e6 * taken_s);
    }
    std::nth_element(ticks_us.begin(), ticks_us.begin() + static_cast<std::ptrdiff_t>(ticks_us.size() / 2),
                     ticks_us.end());
    return ticks_us[ticks_us.size() / 2];
}

struct Indentation {
    std::vector<double> force_n;  // at depths of 0.5, 1, 1.5 and 2 mm, each on a fresh wall
    std::vector<double> wall_mm;  // at 1 mm, at rest, within 40 mm of the tool
};

Indentation indent(const Peer& peer) {
    Indentation found;
    for (int half = 1; half <= 4 && peer.force != Peer::Force::kNone; ++half) {
        const auto model = peer.make(kRowsOfErrors);
        double force_n = 0.0;
        for (int k = 0; k < peer.ticks_to_force; ++k)
            force_n = model->tick(0.5 * half);
        found.force_n.push_back(force_n);
    }
    const auto model = peer.make(kRowsOfErrors);
    for (int k = 0; k < peer.ticks_to_rest; ++k)
        model->tick(kDepthMm);
    for (double away_mm = -39.9; away_mm < 40.0; away_mm += 0.2)
        found.wall_mm.push_back(model->wall_mm(kToolHeightMm + away_mm));
    return found;
}

// The root of the mean square of scale a - b, as a part of b where `relative`.
double distance(const std::vector<double>& a, double scale, const std::vector<double>& b, bool relative) {
    double sum = 0.0;
    for (std::size_t i = 0; i < b.size(); ++i)
        sum += std::pow((scale * a[i] - b[i]) / (relative ? b[i] : 1.0), 2.0);
    return std::sqrt(sum / static_cast<double>(b.size()));
}

// The slope of the times over the rows, both as logarithms.
double exponent(const std::vector<double>& times_us) {
    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    const auto count = static_cast<double>(times_us.size());
    for (std::size_t i = 0; i < times_us.size(); ++i) {
        const double rows = std::log(kRows[i]);
        x += rows;
        y += std::log(times_us[i]);
        xx += rows * rows;
        xy += rows * std::log(times_us[i]);
    }
    return (count * xy - x * y) / (count * xx - x * x);
}

std::string times_of(const std::vector<double>& times_us) {
    std::string cells;
    for (std::size_t i = 0; i < std::size(kRows); ++i) {
        char cell[32] = "";
        if (i < times_us.size())
            std::snprintf(cell, sizeof cell, times_us[i] < 10.0 ? "%.2f" : "%.0f", times_us[i]);
        cells += std::string(cell) + " | ";
    }
    return cells;
}

void compare(int rounds, const char* plot_path) {
    const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    const Indentation fine = indent({"", [](int) { return fine_finite_elements(); }, 0});
    std::fprintf(stderr, "fine finite elements: %.3f N at 1 mm\n", fine.force_n[1]);

    std::vector<std::vector<std::unique_ptr<Model>>> models;
    std::vector<std::vector<double>> times_us;
    std::vector<double> built_ms;  // with kRowsOfErrors
    for (const Peer& peer : kPeers) {
        models.emplace_back();
        for (const int rows : kRows) {
            if (rows > peer.most_rows) continue;
            const double began_s = seconds_of(CLOCK_THREAD_CPUTIME_ID);
            models.back().push_back(peer.make(rows));
            if (rows == kRowsOfErrors)
                built_ms.push_back(1e3 * (seconds_of(CLOCK_THREAD_CPUTIME_ID) - began_s));
        }
        times_us.emplace_back(models.back().size(), std::numeric_limits<double>::infinity());
    }
    for (int round = 0; round < rounds; ++round)
        for (std::size_t size = 0; size < std::size(kRows); ++size)
            for (std::size_t peer = 0; peer < models.size(); ++peer)
                if (size < models[peer].size())
                    times_us[peer][size] =
                        std::min(times_us[peer][size], median_tick_us(*models[peer][size]));
    models.clear();

    std::printf(
        "| model | us a tick: 200 rows | 400 | 800 | 2000 | exponent | 1 ms up to | to build, ms | force at "
        "1 mm | curve of "
        "force | shape |\n|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (std::size_t i = 0; i < std::size(kPeers); ++i) {
        const Indentation found = indent(kPeers[i]);
        int most_rows = 0;
        for (std::size_t size = 0; size < times_us[i].size(); ++size)
            if (times_us[i][size] <= kHapticTickUs) most_rows = kRows[size];
        std::printf("| %s | %s%.1f | %s | %.0f | ", kPeers[i].name, times_of(times_us[i]).c_str(),
                    exponent(times_us[i]),
                    most_rows > 0 ? (std::to_string(most_rows) + " rows").c_str() : "none", built_ms[i]);
        if (kPeers[i].force == Peer::Force::kNone) {
            std::printf("none | | ");
        } else {
            const double scale = fine.force_n[1] / found.force_n[1];
            char force[16] = "own constants";
            if (kPeers[i].force == Peer::Force::kOfModulus)
                std::snprintf(force, sizeof force, "%.2f", 1.0 / scale);
            std::printf("%s | %.1f %% | ", force, 100.0 * distance(found.force_n, scale, fine.force_n, true));
        }
        std::printf("%.1f %% |\n", 100.0 * distance(found.wall_mm, 1.0, fine.wall_mm, false) / kDepthMm);
    }

    std::FILE* plot = std::fopen(plot_path, "w");
    if (plot == nullptr) {
        std::fprintf(stderr, "%s: expected a file to write, found none\n", plot_path);
        std::exit(3);
    }
    for (std::size_t i = 0; i < std::size(kPeers); ++i) {
        std::fprintf(plot, "\"%s\"\n", kPeers[i].name);
        for (std::size_t size = 0; size < times_us[i].size(); ++size)
            std::fprintf(plot, "%d %g\n", kRows[size], times_us[i][size]);
        std::fprintf(plot, "\n\n");
    }
    std::fclose(plot);
}

}  // namespace
}  // namespace onggi::peers

int main(int count, char** words) {
    const int rounds = count == 3 ? std::atoi(words[1]) : 0;
    if (rounds < 1) {
        std::fprintf(stderr, "clay_peers: expected ROUNDS PLOT.dat, found %d words\n", count - 1);
        return 2;
    }
    onggi::peers::compare(rounds, words[2]);
}
