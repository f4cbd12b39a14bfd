#include "game/haptic/history.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "game/record/session_writer.h"

namespace onggi::haptic {
namespace {

tool::ToolState without_places(tool::ToolState tool) {
    tool.position_mm = tool.second.position_mm = dvec3(0.0);
    return tool;
}

}  // namespace

History::History(const HapticState& start, const HapticParameters& parameters, const HistoryOptions& options)
    : start_{start, parameters},
      options_(options),
      inputs_(options.aside),
      checkpoints_(options.most_bytes) {
    begin_anew();
}

void History::begin_anew() {
    now_ = start_.state;
    inputs_.clear();
    settings_.clear();
    block_hashes_.clear();
    checkpoints_.clear();
    moves_.clear();
    ++lineage_;
    whole_ = true;
    keep_checkpoint();
}

void History::add(const TickRecord& record) {
    if ((record.flags & TickRecord::kFreshLump) != 0) begin_anew();
    if ((record.flags & TickRecord::kStatePut) != 0) go_back_to(record.tick);
    whole_ = whole_ && record.tick == now_.ticks;
    if (whole_) follow_tick(record.tool, &record.force_n);
}

void History::add_played(const tool::ToolState& tool) {
    if (whole_) follow_tick(tool, nullptr);
}

// Without a recorded force, the force computed here is bit-identical.
void History::follow_tick(const tool::ToolState& tool, const dvec3* force_n) {
    const TickResult result = tick(now_, tool, start_.parameters);
    keep_input(tool, force_n != nullptr ? *force_n : result.forces.total_n());
    follow_moves(result);
    if (inputs_.size() % record::kHashInterval == 0) block_hashes_.push_back(now_.hash());
    const auto ticks_a_checkpoint = std::clamp<std::uint64_t>(
        static_cast<std::uint64_t>(options_.checkpoint_s * start_.parameters.rate_hz()), 1,
        std::max<std::uint64_t>(options_.checkpoint_ticks, 1));
    if (now_.ticks - checkpoints_.newest_tick() >= ticks_a_checkpoint) keep_checkpoint();
}

void History::keep_input(const tool::ToolState& tool, const dvec3& force_n) {
    const tool::ToolState settings = without_places(tool);
    if (settings_.empty() || settings_.back() != settings) settings_.push_back(settings);
    inputs_.push_back({.position_mm = tool.position_mm,
                       .second_position_mm = tool.second.position_mm,
                       .settings = static_cast<std::uint32_t>(settings_.size() - 1),
                       .force_check = record::force_check(force_n)});
}

tool::ToolState History::tool_of(const LoggedInput& input) const {
    tool::ToolState tool = settings_[input.settings];
    tool.position_mm = input.position_mm;
    tool.second.position_mm = input.second_position_mm;
    return tool;
}

void History::keep_checkpoint() {
    checkpoints_.keep(now_.ticks, start_state_bytes(now_, start_.parameters));
}

void History::let_go_of_states() {
    checkpoints_.forget_after(first_tick());
    if (now_.ticks > first_tick()) keep_checkpoint();
}

void History::follow_moves(const TickResult& result) {
    const std::uint64_t tick = now_.ticks - 1;
    const tool::ToolState& tool = now_.tool;
    const bool cuts = tool.wire != tool::Wire::kNone;
    if (!cuts && result.forces.contacts == 0 && result.second_forces.contacts == 0) return;

    const auto pause = static_cast<std::uint64_t>(options_.pause_s * start_.parameters.rate_hz());
    const bool goes_on = !moves_.empty() && tick - moves_.back().end_tick <= pause &&
                         moves_.back().is_cut == cuts &&
                         (cuts || (moves_.back().tool == tool.tool && moves_.back().side == result.side));
    if (!goes_on)
        moves_.push_back({.first_tick = tick, .tool = tool.tool, .side = result.side, .is_cut = cuts});
    moves_.back().end_tick = now_.ticks;
}

std::optional<std::uint64_t> History::before_last_move() const {
    if (moves_.empty()) return std::nullopt;
    return moves_.back().first_tick;
}

Result<HapticState> History::state_at(std::uint64_t tick) const {
    assert(tick >= first_tick() && tick <= now_.ticks);
    auto start = start_from_bytes(checkpoints_.bytes_before(tick), start_.parameters.rate_hz());
    // If our own bytes are refused, that is a bug, not an input error.
    if (!start) throw std::runtime_error(start.error().message);
    HapticState state = std::move(start->state);
    InputLog::Reader inputs(inputs_, static_cast<std::size_t>(state.ticks - first_tick()));
    while (state.ticks < tick) {
        const auto input = inputs.next();
        if (!input) return input.error();
        haptic::tick(state, tool_of(**input), start_.parameters);
    }
    return state;
}

void History::go_back_to(std::uint64_t tick) {
    if (tick < first_tick() || tick > now_.ticks) {
        whole_ = false;
        return;
    }
    auto state = state_at(tick);
    if (!state || !inputs_.shrink(static_cast<std::size_t>(tick - first_tick()))) {
        whole_ = false;
        return;
    }
    now_ = std::move(*state);
    ++lineage_;
    settings_.resize(inputs_.empty() ? 0 : inputs_.back().settings + std::size_t{1});
    block_hashes_.resize(inputs_.size() / record::kHashInterval);
    checkpoints_.forget_after(tick);
    while (!moves_.empty() && moves_.back().first_tick >= tick)
        moves_.pop_back();
    if (!moves_.empty()) moves_.back().end_tick = std::min(moves_.back().end_tick, tick);
}

Result<record::SessionWriter> History::begin_session(const std::filesystem::path& place, files::Beside beside,
                                                     std::span<const std::byte> supplement) const {
    return record::SessionWriter::create(place, session_header(start_),
                                         start_state_bytes(start_.state, start_.parameters), beside,
                                         supplement);
}

Result<void> History::write_on(record::SessionWriter& writer, std::size_t most_ticks) const {
    const auto from = static_cast<std::size_t>(writer.tick_count());
    const std::size_t until = from + std::min(most_ticks, inputs_.size() - from);
    InputLog::Reader inputs(inputs_, from);
    for (std::size_t i = from; i < until; ++i) {
        const auto input = inputs.next();
        if (!input) return input.error();
        if (auto added = writer.add_tick(tool_of(**input), (*input)->force_check); !added) return added;
        if (!writer.block_is_full()) continue;
        if (auto ended = writer.end_block(block_hashes_[i / record::kHashInterval]); !ended) return ended;
    }
    return {};
}

Result<void> History::save_outcome(const std::filesystem::path& place,
                                   std::span<const std::byte> supplement) const {
    return History(now_, start_.parameters, options_).save(place, supplement);
}

Result<void> History::save(const std::filesystem::path& place, std::span<const std::byte> supplement) const {
    auto writer = begin_session(place, files::Beside::kNameless, supplement);
    if (!writer) return writer.error();
    if (auto written = write_on(*writer, inputs_.size()); !written) return written;
    if (auto ready = writer->prepare(now_.hash()); !ready) return ready;
    return writer->commit();
}

Result<std::optional<std::filesystem::path>> FaultReport::look(const TickRecord& record,
                                                               const History& history) {
    const bool is_fault = (record.flags & TickRecord::kFault) != 0;
    const bool begins = is_fault && !is_fault_;
    is_fault_ = is_fault;
    std::optional<std::filesystem::path> none;
    if (!begins || !history.is_whole()) return none;
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    for (int number = 1; number <= kMost; ++number) {
        const std::filesystem::path place = folder_ / fmt::format("fault-{}.onggi", number);
        if (std::filesystem::exists(place, error)) continue;
        if (auto saved = history.save(place); !saved) return saved.error();
        return std::optional(place);
    }
    return none;
}

}  // namespace onggi::haptic
