#include "game/app/kiosk/presentation/demonstrations.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "engine/core/quote.h"
#include "engine/files/asset_folder.h"
#include "engine/files/read_file.h"
#include "game/app/replay/stored_session.h"
#include "game/haptic/start_state.h"
#include "game/tool/tool.h"

namespace onggi::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostListBytes = std::size_t{1} << 16U;
constexpr std::size_t kMostGestureBytes = std::size_t{16} << 20U;

Result<Recording> load_recording(const fs::path& file, const haptic::HapticState& lump,
                                 std::vector<std::string>& remarks) {
    auto loaded = load_session(file.string());
    if (!loaded) return loaded.error();
    const haptic::HapticState& start = loaded->start.state;
    const bool is_alike = start.clay.index() == lump.clay.index() &&
                          start.element_count() == lump.element_count() &&
                          start.sector_count() == lump.sector_count();
    if (!is_alike) {
        return bad_input(fmt::format(
            "{}: expected studio clay of {} rings and {} sectors, as the kiosk's, found {} clay of {} and {}",
            file.string(), lump.element_count(), lump.sector_count(),
            start.studio() != nullptr ? "studio" : "paper", start.element_count(), start.sector_count()));
    }
    if (loaded->session.tick_count() == 0)
        return bad_input(fmt::format("{}: expected at least one tick, found none", file.string()));
    if (auto cut = remark_on_cut(loaded->session, file.string())) remarks.push_back(std::move(*cut));
    return Recording{file.stem().string(), std::move(loaded->session)};
}

// Parses a line of the list; returns the name if the recording is to be shown.
Result<std::string> shown_name(const std::string& line, int number, const fs::path& list, bool forgiving) {
    constexpr std::string_view kUnforgiving = "unforgiving";
    std::istringstream words(line);
    std::string name;
    std::string only_on;
    words >> name >> only_on;
    if (!only_on.empty() && only_on != kUnforgiving)
        return bad_input(fmt::format("{}, line {}: expected a name, or a name and '{}', found {}",
                                     list.string(), number, kUnforgiving, in_quotes(line)));
    return forgiving && !only_on.empty() ? std::string() : name;
}

std::optional<tool::Gesture> load_gesture(const fs::path& file, std::vector<std::string>& remarks) {
    const auto text = files::read_file(file, kMostGestureBytes);
    const auto gesture =
        text ? tool::parse_gesture(*text, file.string()) : Result<tool::Gesture>(text.error());
    if (gesture) return *gesture;
    remarks.push_back(gesture.error().message);
    return std::nullopt;
}

}  // namespace

Show load_show(const fs::path& folder, const fs::path& gesture, const ShowClay& clay,
               std::vector<std::string>& remarks) {
    Show show;
    const fs::path file = folder / "shown.txt";
    const auto list = files::read_file(file, kMostListBytes);
    if (!list) remarks.push_back(list.error().message);
    std::istringstream lines(list ? *list : std::string());
    std::string line;
    for (int number = 1; show.recordings.size() < kMostRecordings && std::getline(lines, line); ++number) {
        const auto name = shown_name(line, number, file, clay.forgiving);
        if (!name) remarks.push_back(name.error().message);
        if (!name || name->empty()) continue;
        auto recording = load_recording(folder / (*name + ".onggi"), clay.lump, remarks);
        if (recording) {
            show.recordings.push_back(std::move(*recording));
        } else {
            remarks.push_back(recording.error().message);
        }
    }
    if (!show.recordings.empty()) return show;
    remarks.push_back(fmt::format("{}: expected a recorded session to show, found none; the wheel shows {}",
                                  folder.string(), gesture.string()));
    show.gesture = load_gesture(gesture, remarks);
    return show;
}

Show load_show(const ShowClay& clay, std::vector<std::string>& remarks) {
    const auto folder = files::find_asset("demonstrations");
    if (!folder) remarks.push_back(folder.error().message);
    const auto gesture = files::find_asset("gestures/attract.csv");
    if (!gesture) remarks.push_back(gesture.error().message);
    return load_show(folder ? *folder : fs::path("demonstrations"),
                     gesture ? *gesture : fs::path("gestures/attract.csv"), clay, remarks);
}

std::unique_ptr<haptic::HapticState> first_state_of(const Recording& recording, std::size_t place) {
    const record::Session& session = recording.session;
    // Valid, because loading the recording has parsed it.
    auto start = haptic::start_from_bytes(session.start_state(), session.header().rate_hz).value();
    start.state.ticks = kShownTicks + place * kTicksEach;
    return std::make_unique<haptic::HapticState>(std::move(start.state));
}

std::optional<double> played_s(std::uint64_t tick, std::size_t place, double rate_hz) {
    const std::uint64_t first = kShownTicks + place * kTicksEach;
    if (tick < first || tick >= first + kTicksEach) return std::nullopt;
    return static_cast<double>(tick - first) / rate_hz;
}

DemonstrationDevice::DemonstrationDevice(std::unique_ptr<haptic::SimulatedDevice> person,
                                         const std::vector<Recording>& recordings, double rate_hz)
    : person_(std::move(person)) {
    for (const Recording& recording : recordings) {
        const record::Session& session = recording.session;
        players_.push_back({record::SessionCursor(session), record::SessionCursor(session),
                            session.header().rate_hz / rate_hz});
    }
}

// Interpolates positions linearly between two ticks of the recording, except across a touch or release; other
// values hold until the next tick.
tool::ToolState DemonstrationDevice::at(Player& player, std::uint64_t tick) noexcept {
    const double recorded = static_cast<double>(tick) * player.ticks_a_tick;
    const auto before = static_cast<std::uint64_t>(recorded);
    const double fraction = recorded - static_cast<double>(before);
    tool::ToolState tool = player.now.at(before);
    const tool::ToolState next = player.next.at(before + 1);
    if (tool.pressing != next.pressing || tool.guided != next.guided) return tool;
    tool.position_mm = glm::mix(tool.position_mm, next.position_mm, fraction);
    if (tool.second.present && next.second.present)
        tool.second.position_mm = glm::mix(tool.second.position_mm, next.second.position_mm, fraction);
    return tool;
}

tool::ToolState DemonstrationDevice::read_tool(std::uint64_t tick, double dt_s) noexcept {
    const std::uint64_t shown = tick < kShownTicks ? 0 : tick - kShownTicks;
    const auto place = static_cast<std::size_t>(shown / kTicksEach);
    if (tick < kShownTicks || place >= players_.size()) {
        // The visitor's hand begins at the visitor's place, not at the recorded one.
        if (std::exchange(plays_, false)) person_->rest();
        const tool::ToolState tool = person_->read_tool(tick, dt_s);
        is_moving_ = person_->is_moving();
        return tool;
    }
    plays_ = true;
    const tool::ToolState tool = at(players_[place], shown % kTicksEach);
    is_moving_ = sense_.moved_to(tool.position_mm, dt_s);
    return tool;
}

}  // namespace onggi::app
