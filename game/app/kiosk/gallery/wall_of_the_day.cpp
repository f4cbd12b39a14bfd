#include "game/app/kiosk/gallery/wall_of_the_day.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <span>
#include <system_error>
#include <utility>

#include "engine/files/atomic_file.h"
#include "engine/files/read_file.h"
#include "game/app/kiosk/gallery/kiosk_gallery.h"
#include "game/app/system/whole_number.h"
#include "game/finish/glaze.h"
#include "game/sharing/kept_note.h"

namespace onggi::app {
namespace {

using nlohmann::json;

constexpr int kFormat = 2;
constexpr std::size_t kMostBytes = 4'000'000;
constexpr std::size_t kMostPoints = 4096;  // of one side of a pot's wall
constexpr double kMostMm = 1000.0;

json json_of(const std::vector<vec2>& points) {
    json list = json::array();
    for (const vec2& point : points)
        list.push_back({point.x, point.y});
    return list;
}

// Throws json::exception, or out_of_range from at(), for anything but a list of points.
std::vector<vec2> points_of(const json& list) {
    std::vector<vec2> points;
    for (const json& pair : list) {
        const auto radius = pair.at(0).get<double>();
        const auto height = pair.at(1).get<double>();
        const bool is_sound = radius >= 0.0 && radius <= kMostMm && height >= -kMostMm && height <= kMostMm;
        if (!is_sound || points.size() == kMostPoints)
            throw json::other_error::create(501, "expected a pot's outline", nullptr);
        points.emplace_back(static_cast<float>(radius), static_cast<float>(height));
    }
    return points;
}

// In hundredths of a millimetre.
constexpr float kPerMm = 100.0F;

json json_of(const pot::OffRound& map) {
    const auto hundredths = [](float mm) { return std::lround(mm * kPerMm); };
    json centres = json::array();
    for (const vec2& centre : map.centre_mm)
        centres.push_back({hundredths(centre.x), hundredths(centre.y)});
    json dents = json::array();
    for (const float dent_mm : map.dents_mm)
        dents.push_back(hundredths(dent_mm));
    return {{"centres", std::move(centres)}, {"dents", std::move(dents)}};
}

// Throws as points_of().
std::shared_ptr<const pot::OffRound> off_round_of(const json& map) {
    const auto mm_of = [](const json& hundredths) {
        const auto mm = static_cast<float>(whole_number<int>(hundredths)) / kPerMm;
        if (std::abs(mm) > kMostMm) throw json::other_error::create(501, "expected millimetres", nullptr);
        return mm;
    };
    pot::OffRound read;
    for (const json& centre : map.at("centres"))
        read.centre_mm.emplace_back(mm_of(centre.at(0)), mm_of(centre.at(1)));
    for (const json& dent : map.at("dents"))
        read.dents_mm.push_back(mm_of(dent));
    const bool is_sound = !read.centre_mm.empty() && read.centre_mm.size() <= kMostPoints &&
                          read.dents_mm.size() % pot::OffRound::kCorners == 0 &&
                          read.dents_mm.size() <= kMostPoints * pot::OffRound::kCorners;
    if (!is_sound) throw json::other_error::create(501, "expected rows of dents", nullptr);
    return std::make_shared<const pot::OffRound>(std::move(read));
}

std::vector<WallPot> pots_of(const json& list) {
    std::vector<WallPot> pots;
    for (const json& one : list) {
        if (pots.size() == WallOfTheDay::kMostPots) break;
        WallPot pot{.gallery_name = one.at("pot").get<std::string>(),
                    .glaze = std::clamp(whole_number<int>(one.at("glaze")), 0, finish::kGlazeCount - 1),
                    .shape = {points_of(one.at("outside")), points_of(one.at("inside"))}};
        if (one.contains("off_round")) pot.shape.off_round = off_round_of(one.at("off_round"));
        if (pot.shape.outside.size() > 1) pots.push_back(std::move(pot));
    }
    return pots;
}

}  // namespace

Result<void> WallOfTheDay::turn_to(const std::string& today) {
    if (auto opened = open(today); !opened) return opened;
    return day_on_disk_ < today && !day_on_disk_.empty() ? write() : Result<void>{};
}

Result<void> WallOfTheDay::open(const std::string& today) {
    day_ = today;
    Result<void> done = read();
    is_unread_ = !done && done.error().kind == ErrorKind::kSystemLacks;
    return done;
}

// Those of day_.
Result<void> WallOfTheDay::read() {
    day_on_disk_.clear();
    pots_.clear();
    std::error_code ignored;
    if (!std::filesystem::exists(file_, ignored)) return {};
    const auto text = files::read_file(file_, kMostBytes);
    if (!text) return text.error();
    try {
        const json wall = json::parse(*text);
        // The first files have no format field.
        if (const int format = wall.contains("format") ? whole_number<int>(wall.at("format")) : 1;
            format < 1 || format > kFormat) {
            return bad_input(fmt::format("{}: expected a wall of format 1 to {}, found {}", file_.string(),
                                         kFormat, format));
        }
        day_on_disk_ = wall.at("day").get<std::string>();
        if (day_ < day_of(sharing::kClockIsSetS)) day_ = std::max(day_, day_on_disk_);
        if (day_on_disk_ == day_) pots_ = pots_of(wall.at("pots"));
    } catch (const json::exception& error) {
        return bad_input(
            fmt::format("{}: expected the pots of a wall, found: {}", file_.string(), error.what()));
    }
    return {};
}

Result<void> WallOfTheDay::put(WallPot pot, const std::string& today) {
    if (day_ != today || is_unread_) {
        if (auto opened = open(today); is_unread_) return opened;
    }
    std::erase_if(pots_, [&](const WallPot& other) { return other.gallery_name == pot.gallery_name; });
    pots_.push_back(std::move(pot));
    if (pots_.size() > kMostPots) pots_.erase(pots_.begin());
    return write();
}

Result<void> WallOfTheDay::take(const std::string& gallery_name) {
    if (is_unread_) {
        if (auto opened = open(day_); is_unread_) return opened;
    }
    const auto gone =
        std::erase_if(pots_, [&](const WallPot& pot) { return pot.gallery_name == gallery_name; });
    return gone == 0 ? Result<void>{} : write();
}

Result<void> WallOfTheDay::clear() {
    if (pots_.empty() && !std::exchange(is_unread_, false)) return {};
    pots_.clear();
    return write();
}

Result<void> WallOfTheDay::write() const {
    json pots = json::array();
    for (const WallPot& pot : pots_) {
        pots.push_back({{"pot", pot.gallery_name},
                        {"glaze", pot.glaze},
                        {"outside", json_of(pot.shape.outside)},
                        {"inside", json_of(pot.shape.inside)}});
        if (pot.shape.off_round) pots.back()["off_round"] = json_of(*pot.shape.off_round);
    }
    const std::string text = json{{"format", kFormat}, {"day", day_}, {"pots", std::move(pots)}}.dump();
    std::error_code ignored;  // write_file_atomically() reports the error
    std::filesystem::create_directories(file_.parent_path(), ignored);
    return files::write_file_atomically(file_, std::as_bytes(std::span(text)));
}

}  // namespace onggi::app
