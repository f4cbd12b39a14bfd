#include "game/app/kiosk/staff/staff_desk.h"

#include <fmt/format.h>

#include <algorithm>

#include "game/screens/page/legibility.h"

namespace onggi::app {

void StaffDesk::see_frame(double now_s, double frame_ms, const haptic::Snapshot& snapshot) {
    now_s_ = now_s;
    if (!started_s_) {
        started_s_ = now_s;
        return;  // there is no previous frame
    }
    meter_.see(now_s, frame_ms, parts_.view.frame_stats().device_ms, snapshot.periods);
}

int StaffDesk::number_of(const std::string& pot) {
    const auto [known, is_new] = numbers_.try_emplace(pot, static_cast<int>(pots_.size()));
    if (is_new) pots_.push_back(pot);
    return known->second;
}

void StaffDesk::take(const KeeperAnswer::Survey& survey) {
    survey_ = survey;
    page_.reset();  // forces new lines
}

void StaffDesk::take(const PhoneAnswer::Survey& survey) {
    if (survey.shared == shared_) return;
    shared_ = survey.shared;
    page_.reset();
}

void StaffDesk::test_force() {
    test_ = Test::kForce;
    static_cast<void>(parts_.job.send(haptic::Command::kTestForce));
}

void StaffDesk::test_sound() {
    test_ = Test::kSound;
    parts_.sound.test();
}

const std::string* StaffDesk::name_of(int number) const {
    if (number < 0 || static_cast<std::size_t>(number) >= pots_.size()) return nullptr;
    return &pots_[static_cast<std::size_t>(number)];
}

void StaffDesk::delete_pot(int number) {
    if (const std::string* name = name_of(number)) parts_.keeper.remove(*name);
    withdraw_code(number);
}

void StaffDesk::withdraw_code(int number) {
    const std::string* name = name_of(number);
    if (name != nullptr && parts_.phone != nullptr) parts_.phone->withdraw(*name);
}

void StaffDesk::leave() {
    if (!is_open_) return;
    is_open_ = false;
    surveyed_s_ = -1e9;
    page_.reset();
    lines_.clear();
    plot_ = {};
    survey_.reset();
    shared_.clear();
    test_ = Test::kNone;
    parts_.view.measure_parts(false);
}

KioskPulse StaffDesk::pulse(const haptic::Snapshot& snapshot) const {
    const bool has_fault = snapshot.fault != haptics::Fault::kNone;
    return {.fault = has_fault ? std::string(haptics::words_for(snapshot.fault)) : std::string(),
            .faults = snapshot.safety.fault_count,
            .asked_hz = parts_.rate_hz,
            .achieved_hz = meter_.achieved_hz(),
            .skipped_periods = snapshot.skipped_periods,
            .late_periods = snapshot.safety.late_periods,
            .frame_ms = meter_.mean_frame_ms(),
            .worst_frame_ms = meter_.worst_frame_ms(),
            .haptic_ticks = snapshot.periods,
            .is_safe_mode = parts_.start.is_safe_mode};
}

Health StaffDesk::health(const screens::View& view, const haptic::Snapshot& snapshot) const {
    const render::FrameStats& stats = parts_.view.frame_stats();
    const bool has_fault = snapshot.fault != haptics::Fault::kNone;
    Health health{.asked_hz = parts_.rate_hz,
                  .achieved_hz = meter_.achieved_hz(),
                  .skipped_periods = snapshot.skipped_periods,
                  .late_periods = snapshot.safety.late_periods,
                  .fault = has_fault ? haptics::words_for(snapshot.fault) : std::string_view(),
                  .frame_ms = meter_.mean_frame_ms(),
                  .worst_frame_ms = meter_.worst_frame_ms(),
                  .device_ms = stats.device_ms,
                  .parts = stats.parts,
                  .quality = parts_.view.quality(),
                  .celsius = {},
                  .free_mb = 0.0,
                  .least_free_mb = parts_.config.gallery.least_free_mb,
                  .falls = parts_.start.falls,
                  .is_safe_mode = parts_.start.is_safe_mode,
                  .running_s = now_s_ - started_s_.value_or(now_s_),
                  .text_degrees = screens::smallest_text_degrees(view.width_px, view.height_px,
                                                                 view.px_per_mm, view.distance_mm),
                  .distance_mm = view.distance_mm,
                  .sound = parts_.sound.device(),
                  .sound_lack = parts_.sound.lack(),
                  .devices = parts_.devices.seen(),
                  .holder = parts_.devices.holder(),
                  .restless = restless_,
                  .use = {},
                  .pots = {},
                  .pots_beyond = 0,
                  .shared = {}};
    return health;
}

std::string StaffDesk::notice(const haptic::Snapshot& snapshot) const {
    switch (test_) {
        case Test::kNone:
            return {};
        case Test::kForce: {
            const std::string holder = parts_.devices.holder();
            return force_test_words(snapshot.force_test, holder.empty() ? "touch and mouse" : holder);
        }
        case Test::kSound:
            break;
    }
    if (parts_.sound.device().empty()) return "Sound: none; " + parts_.sound.lack();
    if (!parts_.sound.is_audible()) return "Sound: the volume is 0";
    return "Sound: left, right, both, by " + parts_.sound.device();
}

void StaffDesk::add_to(screens::View& view, const haptic::Snapshot& snapshot) {
    constexpr double kEveryS = 1.0;
    const kiosk::StaffPage page = view.state.staff.page;
    view.staff_title = parts_.config.staff.name;
    view.staff_notice = notice(snapshot);
    is_open_ = true;
    const bool is_due = now_s_ - surveyed_s_ >= kEveryS;
    if (page_ != page || is_due) {
        parts_.view.measure_parts(page == kiosk::StaffPage::kHealth);
        Health now = health(view, snapshot);
        if (survey_) {
            now.celsius = survey_->celsius;
            now.free_mb = survey_->free_mb;
            now.use = survey_->use;
            now.pots_beyond = survey_->pots_beyond;
            for (const std::string& pot : survey_->pots)
                now.pots.emplace_back(number_of(pot), pot);
            for (const SharedPotNote& pot : shared_)
                now.shared.emplace_back(number_of(pot.gallery_name), pot);
        }
        // Shows no lines before the first survey.
        lines_ = survey_ || page == kiosk::StaffPage::kDevices ? staff_lines(now, page)
                                                               : std::vector<screens::StaffLine>{};
        plot_ = page == kiosk::StaffPage::kHealth ? meter_.plot() : screens::FramePlot{};
        page_ = page;
    }
    if (is_due) {
        surveyed_s_ = now_s_;
        parts_.keeper.survey();
        if (parts_.phone != nullptr) parts_.phone->survey();
    }
    view.staff_lines = lines_;
    view.staff_plot = plot_;
    if (const std::string* pot = name_of(view.state.staff.pot)) view.staff_pot = *pot;
}

}  // namespace onggi::app
