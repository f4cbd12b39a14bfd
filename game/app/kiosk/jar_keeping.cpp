#include "game/app/kiosk/jar_keeping.h"

#include <fmt/format.h>

#include <cmath>
#include <system_error>
#include <utility>

#include "game/clay/studio/joining.h"

namespace onggi::app {

std::filesystem::path JarKeeping::session_place(int bowl) const {
    return folder_ / fmt::format("jar-{}.onggi", bowl);
}

Result<void> JarKeeping::save(const haptic::History& history, int bowl) const {
    std::error_code ignored;  // the session says what is wrong
    std::filesystem::create_directories(folder_, ignored);
    return history.is_whole() ? history.save(session_place(bowl)) : history.save_outcome(session_place(bowl));
}

Result<void> JarKeeping::set_aside(haptic::History&& bowl) {
    drop_second();
    first_ = std::make_unique<haptic::History>(std::move(bowl));
    first_->let_go_of_states();
    return save(*first_, 1);
}

Result<clay::StudioClay> JarKeeping::joined(const clay::StudioClay& second, const JarJoin& join) const {
    const clay::StudioClay& first = *first_->state().studio();
    return clay::join_pots(
        second, first, {.mouth_mm = clay::bore_at_width_mm(first, join.mouth_mm), .shift_mm = join.shift_mm});
}

Result<double> JarKeeping::rims_mm(const clay::StudioClay& second, double mouth_mm) const {
    const auto jar = joined(second, {.mouth_mm = mouth_mm});
    if (!jar) return jar.error();
    return std::fabs(clay::rim_step_mm(second, *first_->state().studio()));
}

Result<haptic::History> JarKeeping::join(haptic::History& second, const JarJoin& join) {
    auto jar = joined(*second.state().studio(), join);
    if (!jar) return jar.error();
    if (auto saved = save(second, 2); !saved) return saved.error();
    second_ = std::make_unique<haptic::History>(std::move(second));
    second_->let_go_of_states();
    return haptic::History(haptic::HapticState(std::move(*jar)), parameters_, {.aside = folder_});
}

std::optional<haptic::History> JarKeeping::take_back() {
    if (!first_ || second_) return std::nullopt;
    std::optional<haptic::History> back(std::move(*first_));
    forget();
    return back;
}

std::optional<haptic::History> JarKeeping::part() {
    if (!second_) return std::nullopt;
    std::optional<haptic::History> back(std::move(*second_));
    drop_second();
    return back;
}

void JarKeeping::drop_second() {
    second_.reset();
    std::error_code ignored;
    std::filesystem::remove(session_place(2), ignored);
}

void JarKeeping::forget() {
    drop_second();
    first_.reset();
    std::error_code ignored;
    std::filesystem::remove(session_place(1), ignored);
}

std::vector<std::filesystem::path> JarKeeping::sessions() const {
    if (!second_) return {};
    return {session_place(1), session_place(2)};
}

}  // namespace onggi::app
