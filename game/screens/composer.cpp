#include "game/screens/composer.h"

#include <fmt/format.h>

#include <array>

#include "game/screens/screens.h"

namespace onggi::screens {
namespace {

constexpr std::int64_t kLookEveryNs = 4'000'000;

}  // namespace

Result<void> Composer::start() {
    return thread_.start(*this, "screens");
}

std::int64_t Composer::round(std::int64_t) noexcept {
    const std::shared_ptr<const View> wish = wishes_.latest();
    if (!wish || wish == shown_) return kLookEveryNs;
    if (!painter_) {
        painter_ = std::make_unique<ui::Painter>();
        store_ = std::make_unique<PaintingStore>(*painter_);
    }
    shown_ = wish;
    done_.put(std::make_shared<const Composed>(Composed{wish, compose(*wish, *painter_, *store_)}));
    return 0;
}

void Composer::finish() noexcept {
    store_.reset();
    painter_.reset();
}

std::string missing_fonts() {
    const std::array<std::string, 4> families{"NanumSquareRound", "NanumMyeongjo", "Noto Sans Arabic",
                                              "Noto Naskh Arabic"};
    const std::vector<std::string> missing = ui::Painter().missing_families(families);
    if (missing.empty()) return {};
    return fmt::format(
        "fonts: expected {}, found none; others stand in for them until fonts-nanum and "
        "fonts-noto-core are installed",
        fmt::join(missing, ", "));
}

}  // namespace onggi::screens
