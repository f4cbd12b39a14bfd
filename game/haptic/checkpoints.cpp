#include "game/haptic/checkpoints.h"

#include <algorithm>
#include <cassert>
#include <span>
#include <utility>

namespace onggi::haptic {

void Checkpoints::clear() {
    kept_.clear();
    newest_ = {};
    packed_bytes_ = 0;
}

void Checkpoints::keep(std::uint64_t tick, std::vector<std::byte> bytes) {
    assert(kept_.empty() || kept_.back().tick < tick);
    const std::size_t step = kept_.empty() ? 0 : (kept_.back().step + 1) % kLongestRow;
    const auto like = step == 0 ? std::span<const std::byte>() : std::span<const std::byte>(newest_);
    kept_.push_back({tick, {}, step});
    put_packed(kept_.size() - 1, record::pack(bytes, like));
    newest_ = std::move(bytes);
    thin_out();
}

void Checkpoints::put_packed(std::size_t which, record::PackedBytes packed) {
    packed_bytes_ -= kept_[which].packed.deflated.size();
    kept_[which].packed = std::move(packed);
    packed_bytes_ += kept_[which].packed.deflated.size();
}

void Checkpoints::forget_after(std::uint64_t tick) {
    assert(!kept_.empty() && kept_.front().tick <= tick);
    if (newest_tick() <= tick) return;
    while (newest_tick() > tick) {
        put_packed(kept_.size() - 1, {});
        kept_.pop_back();
    }
    newest_ = unpacked(kept_.size() - 1);
}

std::size_t Checkpoints::before(std::uint64_t tick) const {
    const auto after = std::upper_bound(kept_.begin(), kept_.end(), tick,
                                        [](std::uint64_t t, const Kept& kept) { return t < kept.tick; });
    assert(after != kept_.begin());
    return static_cast<std::size_t>(after - kept_.begin()) - 1;
}

std::vector<std::byte> Checkpoints::bytes_of(std::size_t which) const {
    return which + 1 == kept_.size() ? newest_ : unpacked(which);
}

std::vector<std::byte> Checkpoints::unpacked(std::size_t which) const {
    std::vector<std::byte> bytes;
    for (std::size_t at = first_of_row(which); at <= which; ++at)
        bytes = record::unpack(kept_[at].packed, bytes);
    return bytes;
}

// Removes the checkpoint between its two closest neighbours, until all fit. The first and the last stay.
void Checkpoints::thin_out() {
    while (bytes() > most_bytes_ && kept_.size() > 2) {
        std::size_t least_missed = 1;
        const auto gap = [&](std::size_t i) { return kept_[i + 1].tick - kept_[i - 1].tick; };
        for (std::size_t i = 2; i + 1 < kept_.size(); ++i) {
            if (gap(i) < gap(least_missed)) least_missed = i;
        }
        take_away(least_missed);
    }
}

// If the next checkpoint is a difference from this one, packs it again as a difference from the one before.
void Checkpoints::take_away(std::size_t which) {
    const std::size_t next = which + 1;
    if (kept_[next].step != 0) {
        const std::size_t step = kept_[which].step;
        const auto like = step == 0 ? std::vector<std::byte>() : unpacked(which - 1);
        const auto bytes = record::unpack(kept_[next].packed, record::unpack(kept_[which].packed, like));
        put_packed(next, record::pack(bytes, like));
        for (std::size_t at = next; at < kept_.size() && kept_[at].step != 0; ++at)
            --kept_[at].step;
    }
    put_packed(which, {});
    kept_.erase(kept_.begin() + static_cast<std::ptrdiff_t>(which));
    join_rows(which);
}

// A checkpoint that stands alone takes several times the space of a difference, so two neighbouring rows are
// merged once they fit kLongestRow.
void Checkpoints::join_rows(std::size_t which) {
    while (which < kept_.size() && kept_[which].step != 0)
        ++which;
    if (which == kept_.size()) return;
    std::size_t end = which + 1;
    while (end < kept_.size() && kept_[end].step != 0)
        ++end;
    const std::size_t first = first_of_row(which - 1);
    if (end - first > kLongestRow) return;
    put_packed(which, record::pack(unpacked(which), unpacked(which - 1)));
    for (std::size_t at = which; at < end; ++at)
        kept_[at].step = at - first;
}

}  // namespace onggi::haptic
