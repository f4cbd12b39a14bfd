#include "game/app/kiosk/presentation/kiosk_voice.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "engine/files/asset_folder.h"
#include "engine/files/read_file.h"

namespace onggi::app {
namespace {

constexpr std::int64_t kListensEveryNs = 250'000'000;  // to the headphones; a line wakes the thread
constexpr std::int64_t kRestsNs = 60'000'000'000;      // after failures in a row
constexpr int kMostFailures = 3;
constexpr double kPauseS = 0.2;  // between two lines
constexpr std::size_t kMostWaiting = 6;
constexpr std::size_t kMostSpokenBytes = std::size_t{64} << 20U;

// The recording of a line; null if there is none. `trouble` receives the error if it cannot be read.
std::shared_ptr<const sound::SpokenLine> recording_of(const std::filesystem::path& file,
                                                      std::string& trouble) {
    std::error_code error;
    if (!std::filesystem::exists(file, error)) return nullptr;
    const auto bytes = files::read_file(file, kMostSpokenBytes);
    auto line = bytes ? sound::read_wave(*bytes, file.string()) : Result<sound::SpokenLine>(bytes.error());
    if (line) return std::make_shared<const sound::SpokenLine>(std::move(*line));
    trouble = line.error().message;
    return nullptr;
}

}  // namespace

std::unique_ptr<KioskVoice> make_voice(const kiosk::Config& config, std::string& lack) {
    const auto& sound = config.sound;
    std::filesystem::path folder = sound.spoken_folder;
    if (folder.empty()) {
        if (const auto found = files::find_asset("spoken")) folder = *found;
    }
    KioskVoice::Synthesise synthesise;
    if (sound.speech != "off" && sound::has_speech_program()) {
        synthesise = [rate = sound.speech_rate, volume = sound.speech_volume](
                         const std::string& language, const std::string& text,
                         const std::function<bool()>& is_wanted) {
            return sound::synthesise(
                text, {.language = language, .words_per_min = rate, .volume_percent = volume}, is_wanted);
        };
    } else if (sound.speech == "on") {
        lack = kNoSpeechProgram;
    }
    return std::make_unique<KioskVoice>(std::move(folder), std::move(synthesise),
                                        sound.speech == "headphones");
}

Result<void> KioskVoice::start() {
    if (folder_.empty() && !synthesise_) return {};
    return thread_.start(*this, "voice");
}

void KioskVoice::stop() noexcept {
    stops_ = true;
    thread_.stop();
}

void KioskVoice::say(SaidLine line) {
    if (!thread_.running()) return;
    if (line.is_urgent) hush();
    if (waiting_.size() >= kMostWaiting) waiting_.pop_front();
    waiting_.push_back(std::move(line));
}

void KioskVoice::hush() {
    waiting_.clear();
    said_.reset();
    line_.reset();
}

void KioskVoice::begin_next() {
    said_ = std::move(waiting_.front());
    waiting_.pop_front();
    requests_.put(std::make_shared<const Request>(Request{++number_, *said_}));
    thread_.wake();
}

void KioskVoice::pass_time(double now_s) {
    const auto& answer = answers_.latest();
    if (said_ && !line_ && answer && answer->number == number_) {
        line_ = answer->line;
        if (line_) {
            const double length_s = static_cast<double>(line_->samples.size()) / sound::kSampleRateHz;
            ends_s_ = now_s + length_s + kPauseS;
        } else {
            said_.reset();
        }
    }
    if (line_ && now_s >= ends_s_) {
        line_.reset();
        said_.reset();
    }
    if (!said_ && !waiting_.empty()) begin_next();
}

std::string KioskVoice::news() {
    const auto& answer = answers_.latest();
    if (!answer || answer->trouble.empty() || !told_.insert(answer->trouble).second) return {};
    return answer->trouble;
}

KioskVoice::Answer KioskVoice::answer(const Request& request, std::int64_t now_ns) {
    const SaidLine& said = request.line;
    Answer answer{.number = request.number, .line = nullptr, .trouble = {}};
    if (!folder_.empty() && !said.key.empty())
        answer.line = recording_of(folder_ / said.language / (said.key + ".wav"), answer.trouble);
    if (answer.line || said.text.empty() || !synthesise_ || now_ns < rests_until_ns_) return answer;
    const auto is_wanted = [&] { return !stops_ && requests_.latest()->number == request.number; };
    auto line = synthesise_(said.language, said.text, is_wanted);
    if (line) {
        failures_ = 0;
        answer.line = std::make_shared<const sound::SpokenLine>(std::move(*line));
    } else if (is_wanted()) {
        answer.trouble = line.error().message;
        if (++failures_ >= kMostFailures) rests_until_ns_ = now_ns + kRestsNs;
    }
    return answer;
}

std::int64_t KioskVoice::round(std::int64_t now_ns) noexcept {
    if (listens_ && now_ns >= listens_ns_) {
        listens_ns_ = now_ns + kListensEveryNs;
        headphones_in_.put(headphones_.are_in(now_ns));
    }
    const auto request = requests_.latest();
    if (!request || request->number == answered_) return kListensEveryNs;
    answered_ = request->number;
    answers_.put(std::make_shared<const Answer>(answer(*request, now_ns)));
    return 0;
}

}  // namespace onggi::app
