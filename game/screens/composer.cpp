#include "game/screens/composer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "engine/core/language_tag.h"
#include "engine/jobs/thread_setup.h"
#include "game/screens/page/fonts.h"

namespace onggi::screens {
namespace {

constexpr std::int64_t kRestNs = 1'000'000'000;    // until somebody asks
constexpr std::int64_t kTurnEveryNs = 40'000'000;  // 25 pictures a second of a turning pot
constexpr double kTurnS = 9.0;
constexpr double kViewS = 4.0;
constexpr int kViews = 4;

}  // namespace

Result<void> Composer::start() {
    return thread_.start(*this, "screens");
}

void Composer::ask(std::shared_ptr<const View> view) {
    requests_.put(view);
    thread_.wake();
}

double TurnTable::pass(double dt_s, bool still, bool held) {
    if (!held) turned_s_ += dt_s;
    const double turn = still ? std::floor(turned_s_ / kViewS) / kViews : turned_s_ / kTurnS;
    return turn - std::floor(turn);
}

std::int64_t Composer::turn_pots(std::int64_t now_ns) {
    const std::int64_t passed_ns = now_ns - turned_ns_;
    if (turning_.empty()) return kRestNs;
    if (passed_ns < kTurnEveryNs) return kTurnEveryNs - passed_ns;
    turned_ns_ = now_ns;
    const double dt_s = std::min(0.1, static_cast<double>(passed_ns) * 1e-9);
    const double turn = table_.pass(dt_s, shown_->state.comfort.still, held_.load(std::memory_order_relaxed));
    if (turn == shown_turn_) return kTurnEveryNs;
    shown_turn_ = turn;
    auto pots = std::make_shared<TurnedPots>();
    for (const auto& [key, pot] : turning_)
        pots->push_back({key, pot->at(turn)});
    turned_.put(std::move(pots));
    return kTurnEveryNs;
}

std::int64_t Composer::round(std::int64_t now_ns) noexcept {
    const std::shared_ptr<const View> request = requests_.latest();
    if (!request || request == shown_) return turn_pots(now_ns);
    if (!painter_) {
        painter_ = std::make_unique<ui::Painter>();
        store_ = std::make_unique<PaintingStore>(*painter_);
    }
    const bool is_other_screen = !shown_ || shown_->state.screen != request->state.screen;
    shown_ = request;
    const auto composed =
        std::make_shared<const Composed>(Composed{request, compose_(*request, *painter_, *store_)});
    turning_.clear();
    for (const Item& item : composed->composition.items) {
        if (item.turning) turning_.emplace_back(item.key, item.turning);
    }
    shown_turn_ = -1.0;
    done_.put(composed);
    // Returns the memory of the painting and of the previous screen to the system.
    if (is_other_screen) jobs::give_back_freed_memory();
    return 0;
}

void Composer::finish() noexcept {
    turning_.clear();
    store_.reset();
    painter_.reset();
}

std::string missing_fonts(std::span<const std::string> codes) {
    std::vector<std::string> families;
    for (const FontFamily& family : needed_families(codes))
        families.emplace_back(family.name);
    ui::Painter painter;
    const std::vector<std::string> missing = painter.missing_families(families);
    if (missing.empty()) return {};
    std::vector<std::string_view> packages;
    for (const FontFamily& family : needed_families(codes)) {
        const bool is_missing = std::find(missing.begin(), missing.end(), family.name) != missing.end();
        if (is_missing && std::find(packages.begin(), packages.end(), family.package) == packages.end())
            packages.push_back(family.package);
    }
    struct Script {
        const char* name;
        const char* letter;
        std::string_view primary;  // empty: always needed
    };
    constexpr std::array<Script, 5> kScripts{{{"Latin", "A", ""},
                                              {"Korean", "\uac00", ""},
                                              {"Arabic", "\u0639", ""},
                                              {"Japanese", "\u3042", "ja"},
                                              {"Chinese", "\u8fd9", "zh"}}};
    std::vector<const char*> without;
    for (const Script& script : kScripts) {
        const bool is_needed = std::any_of(codes.begin(), codes.end(), [&](const std::string& code) {
            return primary_language(code) == script.primary;
        });
        if (!script.primary.empty() && !is_needed) continue;
        if (painter.measure({.words = script.letter, .style = {}}).unknown_glyphs > 0)
            without.push_back(script.name);
    }
    const std::string others =
        without.empty() ? "; others stand in for them"
                        : fmt::format(", nor any other font with {} letters; boxes stand in for those words",
                                      fmt::join(without, ", "));
    return fmt::format("fonts: expected {}, found none{} until {} {} installed", fmt::join(missing, ", "),
                       others, fmt::join(packages, " and "), packages.size() > 1 ? "are" : "is");
}

}  // namespace onggi::screens
