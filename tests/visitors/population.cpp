#include "tests/visitors/population.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <limits>

#include "engine/asset/image.h"
#include "tests/visitors/kiosk_rig.h"

namespace onggi::visitors {
namespace {

constexpr double kSheetPxPerMm = 0.7;
constexpr int kCellWidthPx = 180;
constexpr int kCellHeightPx = 170;

double median(std::vector<double> values) {
    if (values.empty()) return std::numeric_limits<double>::infinity();
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double fraction(const std::vector<Left>& all, const std::function<bool(const Left&)>& holds) {
    return static_cast<double>(std::count_if(all.begin(), all.end(), holds)) /
           static_cast<double>(std::max<std::size_t>(all.size(), 1));
}

struct Colour {
    std::uint8_t red;
    std::uint8_t green;
    std::uint8_t blue;
};

void put(asset::Image& image, int x, int y, const Colour& colour) {
    if (x < 0 || y < 0 || x >= image.width || y >= image.height) return;
    std::uint8_t* px =
        image.rgba.data() + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                 static_cast<std::size_t>(x));
    px[0] = colour.red;
    px[1] = colour.green;
    px[2] = colour.blue;
    px[3] = 255;
}

int px_of(double mm) {
    return static_cast<int>(std::lround(mm * kSheetPxPerMm));
}

void draw_pot(asset::Image& image, const Left& left, int axis_px, int foot_px) {
    constexpr Colour kOutside{190, 140, 105};
    constexpr Colour kCut{226, 178, 128};
    constexpr Colour kInside{60, 42, 34};
    constexpr Colour kMeant{255, 255, 255};
    for (std::size_t i = 0; i < left.outer_mm.size(); ++i) {
        const int y = foot_px - px_of(left.outer_mm[i].y);
        const int outer = px_of(left.outer_mm[i].x);
        const int inner = px_of(left.inner_mm[i].x);
        for (int x = -outer; x <= outer; ++x)
            put(image, axis_px + x, y, x < 0 ? kOutside : x >= inner ? kCut : kInside);
    }
    for (const dvec2& point : left.visit.drawn_mm) {
        for (const double side : {-1.0, 1.0})
            put(image, axis_px + px_of(side * point.x), foot_px - px_of(point.y), kMeant);
    }
    const Colour verdict = left.verdict.is_pot ? Colour{50, 170, 70} : Colour{210, 40, 50};
    for (int x = 4; x < kCellWidthPx - 4; ++x)
        put(image, axis_px - kCellWidthPx / 2 + x, foot_px + 4, verdict);
}

}  // namespace

std::vector<Left> throw_pots(const Crowd& crowd) {
    std::vector<Left> all;
    for (int i = 0; i < crowd.count; ++i) {
        KioskRig rig(crowd.mass_g);
        rig.show_outline(crowd.shown_mm);
        Left left;
        left.seed = crowd.first_seed + static_cast<std::uint64_t>(i);
        left.visit = throw_a_pot(crowd.kind, left.seed, crowd.skill, rig, crowd.shown_mm);
        left.verdict = judge(rig.clay_at_done(), left.visit.drawn_mm);
        left.after_advice = judge(rig.clay(), left.visit.drawn_mm);
        left.is_untouched = rig.faces_mm() == rig.released_mm();
        left.ledger_error_mm3 = rig.clay().ledger_error_mm3();
        for (double y = 0.5; y < rig.height_mm(); y += 1.0) {
            left.outer_mm.emplace_back(rig.outer_mm(y), y);
            left.inner_mm.emplace_back(rig.inner_mm(y), y);
        }
        all.push_back(std::move(left));
    }
    return all;
}

double fraction_of_pots(const std::vector<Left>& all) {
    return fraction(all, [](const Left& left) { return left.verdict.is_pot; });
}

double fraction_of_good_pots(const std::vector<Left>& all) {
    return fraction(all, [](const Left& left) { return left.verdict.is_good; });
}

double fraction_of_good_pots_after_advice(const std::vector<Left>& all) {
    return fraction(all, [](const Left& left) { return left.after_advice.is_good; });
}

std::string row_for(Kind kind, const std::vector<Left>& all) {
    const auto of = [&](const std::function<double(const Left&)>& value) {
        std::vector<double> values;
        for (const Left& left : all)
            values.push_back(value(left));
        return median(std::move(values));
    };
    return fmt::format(
        "{:14} {:4} {:5.0f} % {:5.0f} % {:5.0f} % {:6.1f} {:6.1f} {:6.0f} {:6.0f} {:6.0f} {:6.1f}",
        kKindNames[static_cast<std::size_t>(kind)], all.size(), 100.0 * fraction_of_pots(all),
        100.0 * fraction_of_good_pots(all), 100.0 * fraction_of_good_pots_after_advice(all),
        of([](const Left& left) { return left.verdict.mean_wall_mm; }),
        of([](const Left& left) { return left.verdict.thickest_up_mm; }),
        of([](const Left& left) { return left.verdict.capacity_ml; }),
        of([](const Left& left) { return left.verdict.height_mm; }),
        of([](const Left& left) { return left.visit.seconds; }), median_rms_mm(all));
}

double fraction_within_mm(const std::vector<Left>& all, double rms_mm) {
    return fraction(all, [&](const Left& left) { return left.verdict.drawn_rms_mm <= rms_mm; });
}

bool all_untouched(const std::vector<Left>& all) {
    return std::all_of(all.begin(), all.end(), [](const Left& left) { return left.is_untouched; });
}

double median_rms_mm(const std::vector<Left>& all) {
    std::vector<double> values;
    for (const Left& left : all)
        values.push_back(left.verdict.drawn_rms_mm);
    return median(std::move(values));
}

double median_made_s(const std::vector<Left>& all) {
    std::vector<double> values;
    for (const Left& left : all)
        values.push_back(left.visit.made_s >= 0.0 ? left.visit.made_s
                                                  : std::numeric_limits<double>::infinity());
    return median(std::move(values));
}

std::string words_for(const std::vector<Left>& all) {
    std::string words;
    for (const Left& left : all) {
        if (left.verdict.is_pot && left.is_untouched) continue;
        words += fmt::format("seed {}: {}{}; {:.0f} mm high, {:.0f} ml\n", left.seed, left.verdict.why_not,
                             left.is_untouched ? "" : " moved after the last release", left.verdict.height_mm,
                             left.verdict.capacity_ml);
    }
    return words;
}

void write_sheet(const std::string& path, const std::vector<std::vector<Left>>& rows) {
    std::size_t most = 1;
    for (const auto& row : rows)
        most = std::max(most, row.size());
    asset::Image image{.width = std::min(kCellWidthPx * static_cast<int>(most), asset::kMaxImageSide),
                       .height = kCellHeightPx * static_cast<int>(rows.size()),
                       .rgba = {}};
    image.rgba.assign(4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height), 0);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x)
            put(image, x, y, {20, 20, 20});
    }
    for (std::size_t row = 0; row < rows.size(); ++row) {
        for (std::size_t i = 0; i < rows[row].size(); ++i)
            draw_pot(image, rows[row][i], kCellWidthPx * static_cast<int>(i) + kCellWidthPx / 2,
                     kCellHeightPx * static_cast<int>(row + 1) - 10);
    }
    const auto png = asset::encode_png(image);
    if (!png) return;
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(png->data()), static_cast<std::streamsize>(png->size()));
}

}  // namespace onggi::visitors
