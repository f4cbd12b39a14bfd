// Measures a program's resources repeatedly: none may grow with every visit.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "engine/core/list_folder.h"
#include "tests/support/process_hold.h"

namespace onggi::stress {

struct Figures {
    double resident_kb = 0.0;
    double handles = 0.0;
    double threads = 0.0;
    double disk_kb = 0.0;  // of the kiosk's folder without its complete pots and unnamed files
    double pot_kb = 0.0;   // mean of a complete pot
};

struct DiskUse {
    double beside_pots = 0.0;  // bytes
    double in_pots = 0.0;
    int pots = 0;
};

// Adds a folder recursively. An incomplete pot's name has an extension.
inline void add_disk_use(const std::filesystem::path& folder, bool is_pot, DiskUse& use) {
    for (const std::filesystem::path& entry : list_folder(folder).entries) {
        std::error_code gone;  // the keeper works beside us
        if (std::filesystem::is_directory(std::filesystem::symlink_status(entry, gone))) {
            const bool begins_pot =
                !is_pot && !entry.has_extension() && entry.filename().string().starts_with("pot-");
            use.pots += begins_pot ? 1 : 0;
            add_disk_use(entry, is_pot || begins_pot, use);
        } else if (const auto size = std::filesystem::file_size(entry, gone); !gone) {
            (is_pot ? use.in_pots : use.beside_pots) += static_cast<double>(size);
        }
    }
}

inline Figures figures_of_this_process(const std::filesystem::path& folder) {
    constexpr double kKb = 1e3;
    DiskUse disk;
    add_disk_use(folder, false, disk);
    return {.resident_kb = test::resident_kb(),
            .handles = static_cast<double>(test::open_handles()),
            .threads = static_cast<double>(list_folder("/proc/self/task").entries.size()),
            .disk_kb = disk.beside_pots / kKb,
            .pot_kb = disk.in_pots / std::max(disk.pots, 1) / kKb};
}

// Least squares, of the value against the number of the visit.
inline double slope_of(const std::vector<Figures>& all, double Figures::*value) {
    const auto count = static_cast<double>(all.size());
    double sum_x = 0.0;
    double sum_y = 0.0;
    double sum_xx = 0.0;
    double sum_xy = 0.0;
    double x = 0.0;
    for (const Figures& one : all) {
        sum_x += x;
        sum_y += one.*value;
        sum_xx += x * x;
        sum_xy += x * one.*value;
        x += 1.0;
    }
    const double spread = count * sum_xx - sum_x * sum_x;
    return spread > 0.0 ? (count * sum_xy - sum_x * sum_y) / spread : 0.0;
}

// Prints a line per figure; with enough samples, checks that none grows.
inline void expect_flat(const std::vector<Figures>& all) {
    constexpr std::size_t kEnough = 50;
    constexpr double kMostMemoryKb = 40.0;  // a visit
    constexpr double kMostDiskKb = 40.0;    // likewise; a line in each table of visits is a hundredth of that
    constexpr double kMostPotKb = 5.0;  // likewise; eight times that is the allowed growth of a day's shelf
    constexpr double kMostOthers = 0.02;
    ASSERT_FALSE(all.empty());
    const auto judge = [&](const char* name, double Figures::*value, double most) {
        const double slope = slope_of(all, value);
        std::printf("%s: first %.0f, last %.0f, %+.3f a visit\n", name, all.front().*value, all.back().*value,
                    slope);
        if (all.size() >= kEnough) {
            EXPECT_LT(slope, most) << name << " grows";
        }
    };
    judge("resident kB", &Figures::resident_kb, kMostMemoryKb);
    judge("handles", &Figures::handles, kMostOthers);
    judge("threads", &Figures::threads, kMostOthers);
    judge("disk kB", &Figures::disk_kb, kMostDiskKb);
    judge("kB a pot", &Figures::pot_kb, kMostPotKb);
}

}  // namespace onggi::stress
