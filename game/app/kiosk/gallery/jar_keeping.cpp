#include "game/app/kiosk/gallery/jar_keeping.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <span>
#include <system_error>
#include <utility>

#include "engine/files/atomic_file.h"
#include "engine/files/read_file.h"
#include "game/app/system/whole_number.h"
#include "game/clay/studio/joining.h"

namespace onggi::app {
namespace {

constexpr int kJarFormat = 1;
constexpr std::size_t kMostJarNoteBytes = 4096;
constexpr int kFirstBowl = 1;
constexpr int kSecondBowl = 2;

}  // namespace

std::filesystem::path JarKeeping::session_place(int bowl) const {
    return folder_ / fmt::format("jar-{}.onggi", bowl);
}

void JarKeeping::remove(const std::filesystem::path& file) const noexcept {
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
}

Result<void> JarKeeping::begin(std::string target) {
    forget();
    target_ = std::move(target);
    return note(JarStage::kFirstBowl);
}

Result<void> JarKeeping::note(JarStage stage) {
    stage_ = stage;
    const std::string text = nlohmann::json{
        {"format", kJarFormat},
        {"target", target_},
        {"stage", static_cast<int>(stage)},
        {"shift_mm", {join_.shift_mm.x, join_.shift_mm.y}},
        {"mouth_mm",
         join_.mouth_mm}}.dump();
    std::error_code ignored;  // write_file_atomically() reports the error
    std::filesystem::create_directories(folder_, ignored);
    return files::write_file_atomically(note_place(), std::as_bytes(std::span(text)));
}

Result<void> JarKeeping::save(const haptic::History& history, int bowl) const {
    std::error_code ignored;  // writing the session reports the error
    std::filesystem::create_directories(folder_, ignored);
    return history.is_whole() ? history.save(session_place(bowl)) : history.save_outcome(session_place(bowl));
}

Result<void> JarKeeping::set_aside(haptic::History&& bowl) {
    second_.reset();
    remove(session_place(kSecondBowl));
    first_ = std::make_unique<haptic::History>(std::move(bowl));
    first_->let_go_of_states();
    return save(*first_, kFirstBowl);
}

Result<clay::StudioClay> JarKeeping::joined(const clay::StudioClay& second, const JarJoin& join) const {
    const clay::StudioClay& first = *first_->state().studio();
    return clay::join_pots(
        second, first, {.bore_mm = clay::bore_at_width_mm(first, join.mouth_mm), .shift_mm = join.shift_mm});
}

Result<double> JarKeeping::rims_mm(const clay::StudioClay& second, double mouth_mm) const {
    const auto jar = joined(second, {.mouth_mm = mouth_mm});
    if (!jar) return jar.error();
    return std::fabs(clay::rim_step_mm(second, *first_->state().studio()));
}

Result<haptic::History> JarKeeping::join(haptic::History& second, const JarJoin& join) {
    auto jar = joined(*second.state().studio(), join);
    if (!jar) return jar.error();
    if (auto saved = save(second, kSecondBowl); !saved) return saved.error();
    join_ = join;
    second_ = std::make_unique<haptic::History>(std::move(second));
    second_->let_go_of_states();
    return haptic::History(haptic::HapticState(std::move(*jar)), parameters_, {.aside = folder_});
}

// Its session stays on the disk until the new journal has caught up or another session replaces it.
haptic::History JarKeeping::take_back() {
    std::unique_ptr<haptic::History>& newest = second_ ? second_ : first_;
    haptic::History back(std::move(*newest));
    newest.reset();
    return back;
}

Result<void> JarKeeping::drop_second() {
    second_.reset();
    jar_start_.reset();
    const Result<void> noted = note(JarStage::kSecondBowl);
    remove(session_place(kSecondBowl));
    return noted;
}

void JarKeeping::forget() {
    remove(note_place());
    remove(session_place(kFirstBowl));
    remove(session_place(kSecondBowl));
    first_.reset();
    second_.reset();
    restored_.reset();
    jar_start_.reset();
    join_ = {};
    target_.clear();
    stage_ = JarStage::kNone;
}

std::vector<std::filesystem::path> JarKeeping::sessions() const {
    if (!second_) return {};
    return {session_place(kFirstBowl), session_place(kSecondBowl)};
}

Result<void> JarKeeping::read_note() {
    const auto text = files::read_file(note_place(), kMostJarNoteBytes);
    if (!text) return text.error();
    try {
        const nlohmann::json note = nlohmann::json::parse(*text);
        const int format = whole_number<int>(note.at("format"));
        const int stage = whole_number<int>(note.at("stage"));
        if (format != kJarFormat || stage < static_cast<int>(JarStage::kFirstBowl) ||
            stage > static_cast<int>(JarStage::kJar)) {
            return bad_input(fmt::format("{}: expected a jar of format {} at stage 1 to 3, found {} at {}",
                                         note_place().string(), kJarFormat, format, stage));
        }
        target_ = note.at("target").get<std::string>();
        join_ = {
            .shift_mm = {note.at("shift_mm").at(0).get<double>(), note.at("shift_mm").at(1).get<double>()},
            .mouth_mm = note.at("mouth_mm").get<double>()};
        stage_ = static_cast<JarStage>(stage);
    } catch (const nlohmann::json::exception& error) {
        return bad_input(fmt::format("{}: expected how far a jar has come, found: {}", note_place().string(),
                                     error.what()));
    }
    return {};
}

Result<void> JarKeeping::look(std::vector<std::string>& remarks) {
    std::error_code ignored;
    if (!std::filesystem::exists(note_place(), ignored)) {
        forget();
    } else if (auto read = read_note(); !read) {
        if (read.error().kind != ErrorKind::kBadInput) return read;
        remarks.push_back("interrupted jar: dropped: " + read.error().message);
        forget();
    }
    return {};
}

Result<std::unique_ptr<InterruptedSession>> JarKeeping::left_over() const {
    const std::filesystem::path file =
        session_place(stage_ == JarStage::kFirstBowl ? kFirstBowl : kSecondBowl);
    std::error_code ignored;
    if (stage_ != JarStage::kJar && std::filesystem::exists(file, ignored)) {
        auto bowl = InterruptedSession::read(file, lump_, parameters_, folder_);
        if (bowl || bowl.error().kind != ErrorKind::kBadInput) return bowl;
    }
    return has_bowl() ? InterruptedSession::of_nothing(start(), parameters_, folder_) : nullptr;
}

Result<bool> JarKeeping::restore(int ticks) {
    if (stage_ == JarStage::kNone || stage_ == JarStage::kFirstBowl) return false;
    const bool is_second = first_ != nullptr;
    if (is_second && (stage_ != JarStage::kJar || second_)) return false;
    if (!restored_) {
        auto bowl = InterruptedSession::read(session_place(is_second ? kSecondBowl : kFirstBowl), lump_,
                                             parameters_, folder_);
        if (!bowl) {
            if (bowl.error().kind == ErrorKind::kBadInput) forget();
            return bowl.error();
        }
        restored_ = std::move(*bowl);
    }
    const auto more = restored_->work(ticks);
    if (!more) {
        const Error error = more.error();
        forget();
        return error;
    }
    if (*more) return true;
    auto history = std::make_unique<haptic::History>(std::move(restored_->history()));
    restored_.reset();
    if (!is_second) {
        first_ = std::move(history);
        return stage_ == JarStage::kJar;
    }
    auto jar = joined(*history->state().studio(), join_);
    if (!jar) {
        const Error error = jar.error();
        forget();
        return error;
    }
    second_ = std::move(history);
    jar_start_ = haptic::HapticState(std::move(*jar));
    return false;
}

}  // namespace onggi::app
