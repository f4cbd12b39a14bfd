#include "game/app/kiosk/presentation/kiosk_voice.h"

#include <fmt/format.h>

#include <utility>

#include "engine/files/read_file.h"

namespace onggi::app {
namespace {

constexpr std::int64_t kReadEveryNs = 20'000'000;
constexpr std::size_t kMostSpokenBytes = std::size_t{64} << 20U;

}  // namespace

Result<void> KioskVoice::start() {
    if (folder_.empty()) return {};
    return thread_.start(*this, "voice");
}

bool KioskVoice::ask(std::string_view language, std::string_view key) {
    std::string name = key.empty() ? std::string() : fmt::format("{}/{}.wav", language, key);
    if (name == asked_) return false;
    asked_ = std::move(name);
    requests_.put(std::make_shared<const std::string>(asked_));
    return true;
}

std::shared_ptr<const sound::SpokenLine> KioskVoice::line() noexcept {
    const auto& found = found_.latest();
    return found && found->name == asked_ ? found->line : nullptr;
}

std::string KioskVoice::news() {
    const auto& found = found_.latest();
    if (!found || found->trouble.empty() || !told_.insert(found->name).second) return {};
    return found->trouble;
}

std::shared_ptr<const sound::SpokenLine> KioskVoice::read(const std::filesystem::path& folder,
                                                          const std::string& name, std::string& trouble) {
    const std::filesystem::path file = folder / name;
    std::error_code error;
    if (name.empty() || !std::filesystem::exists(file, error)) return nullptr;
    const auto bytes = files::read_file(file, kMostSpokenBytes);
    auto line = bytes ? sound::read_wave(*bytes, file.string()) : Result<sound::SpokenLine>(bytes.error());
    if (line) return std::make_shared<const sound::SpokenLine>(std::move(*line));
    trouble = line.error().message;
    return nullptr;
}

std::int64_t KioskVoice::round(std::int64_t) noexcept {
    const auto request = requests_.latest();
    if (!request || *request == read_) return kReadEveryNs;
    read_ = *request;
    Found found{.name = read_, .line = nullptr, .trouble = {}};
    found.line = read(folder_, read_, found.trouble);
    found_.put(std::make_shared<const Found>(std::move(found)));
    return 0;
}

}  // namespace onggi::app
