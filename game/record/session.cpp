#include "game/record/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>

#include "engine/core/little_endian.h"
#include "engine/core/quote.h"
#include "game/record/layout.h"
#include "game/record/packed_block.h"

namespace onggi::record {

using little_endian::get;
using little_endian::get_double;

const std::byte* Session::at(std::size_t offset) const noexcept {
    return offset < bytes_.size() ? reinterpret_cast<const std::byte*>(bytes_.data()) + offset
                                  : unpacked_.data() + (offset - bytes_.size());
}

std::span<const std::byte> Session::supplement() const noexcept {
    if (supplement_bytes_ == 0) return {};
    return {at(supplement_at_), supplement_bytes_};
}

std::span<const std::byte> Session::start_state() const noexcept {
    return {at(start_state_at_), start_state_bytes_};
}

bool Session::has_force_at(std::uint64_t tick, const dvec3& force_n) const noexcept {
    assert(tick < tick_count_);
    // The reader has checked that every block but the last holds kHashInterval ticks.
    const Block& block = blocks_[static_cast<std::size_t>(tick / kHashInterval)];
    const std::uint32_t check = force_check(force_n);
    const auto in_block = static_cast<std::size_t>(tick - block.first_tick);
    if (!block.is_packed) return get<std::uint32_t>(at(block.checks_at + in_block * kCheckBytes)) == check;
    return get<std::uint16_t>(at(block.checks_at + in_block * kPackedCheckBytes)) == packed_check(check);
}

tool::ToolState SessionCursor::at(std::uint64_t tick) noexcept {
    if (session_->tick_count() == 0) return {};
    tick = std::min(tick, session_->tick_count() - 1);
    if (!entered_ || tick < tick_ || tick / kHashInterval != block_) {
        enter(static_cast<std::size_t>(tick / kHashInterval));
    }
    while (tick_ < tick)
        step();
    return tool_;
}

void SessionCursor::enter(std::size_t block) noexcept {
    block_ = block;
    record_at_ = session_->blocks_[block].records_at;
    held_ = 0;
    step();
    tick_ = session_->blocks_[block].first_tick;
    entered_ = true;
}

// Advances to the next tick of the same block.
void SessionCursor::step() noexcept {
    ++tick_;
    if (held_ > 0) {
        --held_;
        return;
    }
    const std::byte* record = session_->at(record_at_);
    const auto kind = static_cast<RecordKind>(get<std::uint8_t>(record));
    ++record;
    record_at_ += 1 + record_bytes(kind);
    if (kind == RecordKind::kRepeat) {
        held_ = get<std::uint16_t>(record) - 1U;
        return;
    }
    if (kind == RecordKind::kWholeTool) {
        tool_ = tool::get_whole_tool(record);
        return;
    }
    if (kind == RecordKind::kBothPositions) {
        tool::get_both_positions(record, tool_);
        return;
    }
    const dvec3 position_mm{get_double(record), get_double(record + 8), get_double(record + 16)};
    if (kind == RecordKind::kTool) tool_ = {};
    tool_.position_mm = position_mm;
    if (kind == RecordKind::kPosition) return;
    tool_.radius_mm = get_double(record + kPositionBytes);
    tool_.wheel_button = get<std::uint8_t>(record + kToolBytes - 1) == 1;
}

// Checks a whole session file, so that playing it needs no checks.
class SessionReader {
  public:
    SessionReader(std::string bytes, std::string_view name) : name_(name) {
        session_.bytes_ = std::move(bytes);
    }

    Result<Session> read(Damage damage) && {
        if (auto header = read_header(); !header) return header.error();
        if (auto state = read_start_state(); !state) return state.error();
        while (!session_.complete_ && !cut_) {
            auto block = read_block();
            if (block) continue;
            if (damage == Damage::kRefuse) return block.error();
            session_.damage_ = block.error().message;
            cut_ = true;
        }
        session_.usable_bytes_ = at_;
        return std::move(session_);
    }

  private:
    [[nodiscard]] std::size_t left() const { return session_.bytes_.size() - at_; }
    [[nodiscard]] std::span<const std::byte> span_at(std::size_t offset, std::size_t size) const {
        return {session_.at(offset), size};
    }
    template <typename T>
    [[nodiscard]] T number_at(std::size_t field) const {
        return get<T>(session_.at(at_ + field));
    }
    // An error in a field of the header or block that begins at at_.
    Error wrong(std::size_t field, std::string_view expected, std::string_view found) const {
        return wrong_at(at_ + field, expected, found);
    }
    Error wrong_at(std::size_t offset, std::string_view expected, std::string_view found) const {
        const std::string place = session_.unpacked_.empty() || offset < session_.bytes_.size()
                                      ? fmt::format("byte {}", offset)
                                      : fmt::format("block at byte {}: unpacked byte {}", at_,
                                                    offset - session_.bytes_.size() - unpacked_from_);
        return bad_input(
            fmt::format("{}: {}: expected {}, found {}", shown_path(name_), place, expected, found));
    }
    std::optional<Error> expect_checksum(std::string_view of, std::span<const std::byte> bytes,
                                         std::size_t stored_at) const {
        const auto stored = get<std::uint32_t>(session_.at(stored_at));
        const std::uint32_t found = checksum(bytes);
        if (stored == found) return std::nullopt;
        return wrong_at(stored_at, fmt::format("the checksum {:08x} of {}", found, of),
                        fmt::format("{:08x}: the file is damaged", stored));
    }
    template <typename T>
    std::optional<Error> expect_within(std::string_view what, std::size_t field, T least, T most) const {
        const T found = number_at<T>(field);
        if (found >= least && found <= most) return std::nullopt;
        return wrong(field, fmt::format("{} to {} {}", least, most, what), fmt::format("{}", found));
    }

    Result<void> read_header();
    std::optional<Error> check_version() const;
    Result<void> read_start_state();
    Result<void> read_block();
    std::optional<Error> check_block_head(std::uint32_t tick_count, bool is_packed) const;
    // Unpacks the body at body_at. Returns the offset of its records.
    Result<std::size_t> unpack_body(std::size_t body_at, std::size_t body_bytes, std::size_t records_bytes,
                                    std::uint32_t tick_count);
    Result<void> read_supplement();
    Result<void> read_end();
    Result<void> check_records(std::size_t from, std::size_t to, std::uint32_t tick_count) const;
    std::optional<Error> check_tool(RecordKind kind, std::size_t at) const;
    std::optional<Error> check_millimetres(std::size_t offset, std::string_view what, double least,
                                           double most) const;

    std::string_view name_;
    Session session_;
    bool may_have_supplement_ = false;
    bool may_be_packed_ = false;
    std::size_t unpacked_from_ = 0;  // where the last packed block begins in unpacked_
    std::size_t at_ = 0;
    bool cut_ = false;  // the file ends before its end marker
};

std::optional<Error> SessionReader::check_version() const {
    const auto major = number_at<std::uint16_t>(header_at::kMajor);
    const auto minor = number_at<std::uint16_t>(header_at::kMinor);
    if (major == kMajorVersion && minor <= kMinorVersion) return std::nullopt;
    const bool newer = major >= kMajorVersion;  // if the major versions are equal, the minor version is newer
    return wrong(header_at::kMajor, fmt::format("a session of version {}.{}", kMajorVersion, kMinorVersion),
                 fmt::format("{}.{}, {}", major, minor,
                             newer ? "written by a newer program"
                                   : "recorded before hands could let go: record it again"));
}

Result<void> SessionReader::read_header() {
    const std::string_view start = session_.bytes_;
    if (!opens_a_session(start)) {
        return wrong(0, "the first bytes of a session", in_quotes(start.substr(0, kMagic.size())));
    }
    if (left() < header_at::kSize) {
        return wrong(left(), fmt::format("a header of {} bytes", header_at::kSize), "the end of the file");
    }
    // The version comes first, because a newer version may have its checksum elsewhere.
    if (auto error = check_version()) return *error;
    if (auto error = expect_checksum("the header", span_at(0, header_at::kChecksum), header_at::kChecksum)) {
        return *error;
    }
    if (auto error = expect_within<std::uint32_t>("bytes of header", header_at::kHeaderBytes,
                                                  header_at::kSize, header_at::kSize)) {
        return *error;
    }
    may_have_supplement_ = number_at<std::uint16_t>(header_at::kMinor) >= 1;
    may_be_packed_ = number_at<std::uint16_t>(header_at::kMinor) >= 2;
    SessionHeader& header = session_.header_;
    header.rate_hz = get_double(session_.at(header_at::kRate));
    if (!(header.rate_hz >= kMinSessionRateHz && header.rate_hz <= kMaxSessionRateHz)) {
        return wrong(header_at::kRate, fmt::format("{} to {} Hz", kMinSessionRateHz, kMaxSessionRateHz),
                     fmt::format("{}", header.rate_hz));
    }
    if (auto error = expect_within<std::uint32_t>("elements", header_at::kElements, 1, kMaxElements)) {
        return *error;
    }
    header.element_count = number_at<std::uint32_t>(header_at::kElements);
    if (auto error = expect_within<std::uint32_t>("sectors", header_at::kSectors, 1, kMaxSectors))
        return *error;
    header.sector_count = number_at<std::uint32_t>(header_at::kSectors);
    if (auto error = expect_within<std::uint32_t>("as flags", header_at::kFlags, 0, 0)) return *error;
    if (auto error = expect_within("as the detail of its tools", header_at::kToolDetail,
                                   static_cast<std::uint32_t>(ToolDetail::kPlain),
                                   static_cast<std::uint32_t>(ToolDetail::kWhole))) {
        return *error;
    }
    header.tool_detail = static_cast<ToolDetail>(number_at<std::uint32_t>(header_at::kToolDetail));
    header.start_state_hash = number_at<std::uint64_t>(header_at::kStartStateHash);
    if (auto error = expect_within<std::uint64_t>("bytes of start state", header_at::kStartStateBytes, 0,
                                                  kMaxStartStateBytes)) {
        return *error;
    }
    if (auto error = expect_within<std::uint32_t>("ticks between hashes", header_at::kHashInterval,
                                                  kHashInterval, kHashInterval)) {
        return *error;
    }
    if (auto error = expect_within<std::uint32_t>("in the reserved field", header_at::kReserved, 0, 0)) {
        return *error;
    }
    return {};
}

Result<void> SessionReader::read_start_state() {
    session_.start_state_at_ = header_at::kSize;
    session_.start_state_bytes_ =
        static_cast<std::size_t>(get<std::uint64_t>(session_.at(header_at::kStartStateBytes)));
    at_ = header_at::kSize;
    if (left() < session_.start_state_bytes_) {
        return wrong(left(), fmt::format("{} bytes of start state", session_.start_state_bytes_),
                     fmt::format("the end of the file after {}", left()));
    }
    if (auto error =
            expect_checksum("the start state", session_.start_state(), header_at::kStartStateChecksum)) {
        return *error;
    }
    at_ += session_.start_state_bytes_;
    return {};
}

Result<void> SessionReader::read_block() {
    if (left() < block_at::kSize) {
        cut_ = true;
        return {};
    }
    if (auto error =
            expect_checksum("a block's head", span_at(at_, block_at::kChecksum), at_ + block_at::kChecksum)) {
        return *error;
    }
    const auto tag = number_at<std::uint32_t>(block_at::kTag);
    if (tag == kEndTag) return read_end();
    if (tag == kSupplementTag && may_have_supplement_ && session_.supplement_bytes_ == 0)
        return read_supplement();
    const bool is_packed = tag == kPackedTag && may_be_packed_;
    if ((tag != kTicksTag && !is_packed) || session_.supplement_bytes_ > 0)
        return wrong(block_at::kTag, "a block of ticks or the end", fmt::format("{:08x}", tag));

    const auto tick_count = number_at<std::uint32_t>(block_at::kTickCount);
    if (auto error = check_block_head(tick_count, is_packed)) return *error;
    const std::size_t records_bytes = number_at<std::uint32_t>(block_at::kRecordBytes);
    const std::size_t body_at = at_ + block_at::kSize;
    const std::size_t body_bytes = is_packed ? number_at<std::uint32_t>(block_at::kPackedBytes)
                                             : records_bytes + std::size_t{tick_count} * kCheckBytes;
    if (left() - block_at::kSize < body_bytes) {
        cut_ = true;
        return {};
    }
    if (auto error =
            expect_checksum("a block's body", span_at(body_at, body_bytes), at_ + block_at::kBodyChecksum)) {
        return *error;
    }
    std::size_t records_at = body_at;
    if (is_packed) {
        const auto unpacked = unpack_body(body_at, body_bytes, records_bytes, tick_count);
        if (!unpacked) return unpacked.error();
        records_at = *unpacked;
    }
    if (auto records = check_records(records_at, records_at + records_bytes, tick_count); !records) {
        session_.unpacked_.resize(is_packed ? unpacked_from_ : session_.unpacked_.size());
        return records;
    }
    session_.blocks_.push_back({.first_tick = session_.tick_count_,
                                .tick_count = tick_count,
                                .state_hash = number_at<std::uint64_t>(block_at::kStateHash),
                                .records_at = records_at,
                                .checks_at = records_at + records_bytes,
                                .is_packed = is_packed});
    session_.tick_count_ += tick_count;
    at_ = body_at + body_bytes;
    return {};
}

Result<std::size_t> SessionReader::unpack_body(std::size_t body_at, std::size_t body_bytes,
                                               std::size_t records_bytes, std::uint32_t tick_count) {
    const auto unpacked = unpack_block(span_at(body_at, body_bytes), records_bytes, tick_count);
    if (!unpacked)
        return wrong_at(body_at, fmt::format("{} bytes of packed records", records_bytes), "other bytes");
    unpacked_from_ = session_.unpacked_.size();
    session_.unpacked_.insert(session_.unpacked_.end(), unpacked->begin(), unpacked->end());
    return session_.bytes_.size() + unpacked_from_;
}

Result<void> SessionReader::read_supplement() {
    if (auto error = expect_within<std::uint32_t>("bytes of supplement", block_at::kRecordBytes, 1,
                                                  kMaxSupplementBytes)) {
        return *error;
    }
    if (auto error = expect_within("as the number of ticks", block_at::kFirstTick, session_.tick_count_,
                                   session_.tick_count_)) {
        return *error;
    }
    for (const std::size_t field : {block_at::kTickCount, block_at::kReserved}) {
        if (auto error = expect_within<std::uint32_t>("in a supplement's field", field, 0, 0)) return *error;
    }
    if (auto error = expect_within<std::uint64_t>("as the supplement's hash", block_at::kStateHash, 0, 0))
        return *error;
    const std::size_t body_at = at_ + block_at::kSize;
    const std::size_t body_bytes = number_at<std::uint32_t>(block_at::kRecordBytes);
    if (left() - block_at::kSize < body_bytes) {
        cut_ = true;
        return {};
    }
    if (auto error =
            expect_checksum("the supplement", span_at(body_at, body_bytes), at_ + block_at::kBodyChecksum)) {
        return *error;
    }
    session_.supplement_at_ = body_at;
    session_.supplement_bytes_ = body_bytes;
    at_ = body_at + body_bytes;
    return {};
}

std::optional<Error> SessionReader::check_block_head(std::uint32_t tick_count, bool is_packed) const {
    if (auto error =
            expect_within<std::uint32_t>("ticks in a block", block_at::kTickCount, 1, kHashInterval)) {
        return error;
    }
    if (auto error = expect_within<std::uint32_t>("bytes of records", block_at::kRecordBytes, 1 + kToolBytes,
                                                  tick_count * (1 + tool::kWholeToolBytes))) {
        return error;
    }
    if (auto error = expect_within("as the first tick", block_at::kFirstTick, session_.tick_count_,
                                   session_.tick_count_)) {
        return error;
    }
    // What zlib cannot make smaller becomes little larger.
    constexpr std::uint32_t kMostPackedBytes = 2 * kHashInterval * (1 + tool::kWholeToolBytes);
    const auto error =
        is_packed ? expect_within<std::uint32_t>("packed bytes", block_at::kPackedBytes, 1, kMostPackedBytes)
                  : expect_within<std::uint32_t>("in the reserved field", block_at::kReserved, 0, 0);
    if (error) return error;
    if (!session_.blocks_.empty() && session_.blocks_.back().tick_count < kHashInterval) {
        return wrong(block_at::kTag, "the end after a block that is not full", "another block");
    }
    const double most = kMaxSessionSeconds * session_.header_.rate_hz;
    if (static_cast<double>(session_.tick_count_ + tick_count) > most) {
        return wrong(block_at::kTickCount, fmt::format("at most {} s of ticks", kMaxSessionSeconds), "more");
    }
    return std::nullopt;
}

Result<void> SessionReader::read_end() {
    if (auto error = expect_within("as the number of ticks", block_at::kFirstTick, session_.tick_count_,
                                   session_.tick_count_)) {
        return *error;
    }
    const auto blocks = static_cast<std::uint32_t>(session_.blocks_.size());
    if (auto error = expect_within("as the number of blocks", block_at::kTickCount, blocks, blocks)) {
        return *error;
    }
    for (const std::size_t field : {block_at::kRecordBytes, block_at::kBodyChecksum, block_at::kReserved}) {
        if (auto error = expect_within<std::uint32_t>("in an end marker's field", field, 0, 0)) return *error;
    }
    if (auto error = expect_within<std::uint64_t>("as the end marker's hash", block_at::kStateHash, 0, 0)) {
        return *error;
    }
    if (left() > block_at::kSize) {
        return wrong(block_at::kSize, "the end of the file",
                     fmt::format("{} bytes more", left() - block_at::kSize));
    }
    at_ += block_at::kSize;
    session_.complete_ = true;
    return {};
}

std::optional<Error> SessionReader::check_millimetres(std::size_t offset, std::string_view what, double least,
                                                      double most) const {
    const double found = get_double(session_.at(offset));
    if (found >= least && found <= most) return std::nullopt;
    return wrong_at(offset, fmt::format("{} of {} to {} mm", what, least, most), fmt::format("{}", found));
}

std::optional<Error> SessionReader::check_tool(RecordKind kind, std::size_t at) const {
    if (kind == RecordKind::kWholeTool || kind == RecordKind::kBothPositions) {
        const auto fault = kind == RecordKind::kWholeTool ? tool::fault_of_whole_tool(session_.at(at))
                                                          : tool::fault_of_both_positions(session_.at(at));
        if (!fault) return std::nullopt;
        return wrong_at(at + fault->offset, fault->expected, fault->found);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (auto error = check_millimetres(at + axis * 8, "a coordinate", -haptics::kWorkspaceMm,
                                           haptics::kWorkspaceMm)) {
            return error;
        }
    }
    if (kind == RecordKind::kPosition) return std::nullopt;
    if (auto error = check_millimetres(at + kPositionBytes, "a tool radius", tool::kMinToolRadiusMm,
                                       tool::kMaxToolRadiusMm)) {
        return error;
    }
    const std::size_t button_at = at + kToolBytes - 1;
    const auto button = get<std::uint8_t>(session_.at(button_at));
    if (button <= 1) return std::nullopt;
    return wrong_at(button_at, "a button of 0 or 1", fmt::format("{}", button));
}

Result<void> SessionReader::check_records(std::size_t from, std::size_t to, std::uint32_t tick_count) const {
    const bool is_whole = session_.header_.tool_detail == ToolDetail::kWhole;
    std::uint32_t ticks = 0;
    for (std::size_t at = from; at < to;) {
        const auto kind = static_cast<RecordKind>(get<std::uint8_t>(session_.at(at)));
        const bool opens = kind == RecordKind::kTool || (kind == RecordKind::kWholeTool && is_whole);
        if (at == from && !opens) {
            return wrong_at(at, "a tool record to open the block",
                            fmt::format("kind {}", static_cast<int>(kind)));
        }
        const bool known = kind <= RecordKind::kRepeat || is_whole;
        const std::size_t size = known ? record_bytes(kind) : 0;
        if (size == 0) return wrong_at(at, "a record's kind", fmt::format("{}", static_cast<int>(kind)));
        ++at;
        if (to - at < size) {
            return wrong_at(at, fmt::format("{} bytes of a record", size), fmt::format("{}", to - at));
        }
        std::uint32_t more = 1;
        if (kind == RecordKind::kRepeat) {
            more = get<std::uint16_t>(session_.at(at));
            if (more == 0) return wrong_at(at, "at least one repeat", "none");
        } else if (auto error = check_tool(kind, at)) {
            return *error;
        }
        ticks += more;
        if (ticks > tick_count) break;  // stops before the sum can overflow
        at += size;
    }
    if (ticks == tick_count) return {};
    return wrong_at(from, fmt::format("records of {} ticks", tick_count), fmt::format("{}", ticks));
}

Result<Session> parse_session(std::string bytes, std::string_view name, Damage damage) {
    return SessionReader(std::move(bytes), name).read(damage);
}

}  // namespace onggi::record
