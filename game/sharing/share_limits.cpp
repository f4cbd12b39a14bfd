#include "game/sharing/share_limits.h"

#include <algorithm>

namespace onggi::sharing {
namespace {

constexpr std::uint8_t kIpv4 = 4;
constexpr std::uint8_t kIpv6 = 6;

}  // namespace

AddressKey key_of_ipv4(const std::uint8_t (&address)[4]) {
    AddressKey key{kIpv4};
    std::copy(std::begin(address), std::end(address), key.begin() + 1);
    return key;
}

AddressKey key_of_ipv6(const std::uint8_t (&address)[16]) {
    constexpr std::array<std::uint8_t, 12> kMapped{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xff, 0xff};
    if (std::equal(kMapped.begin(), kMapped.end(), std::begin(address)))
        return key_of_ipv4({address[12], address[13], address[14], address[15]});
    AddressKey key{kIpv6};
    std::copy_n(std::begin(address), 8, key.begin() + 1);
    return key;
}

ShareLimits::Bucket& ShareLimits::bucket_of(const AddressKey& address, double now_s) {
    auto found = buckets_.find(address);
    if (found == buckets_.end()) {
        if (buckets_.size() >= rules_.most_addresses) make_room(now_s);
        found = buckets_.emplace(address, Bucket{rules_.most_tokens, now_s}).first;
    }
    Bucket& bucket = found->second;
    bucket.tokens = std::min(rules_.most_tokens, bucket.tokens + (now_s - bucket.at_s) * rules_.tokens_per_s);
    bucket.at_s = now_s;
    return bucket;
}

// Drops full buckets, which equal new ones. If too many remain, drops half of them, so that a flood of
// addresses does not scan all buckets each time.
void ShareLimits::make_room(double now_s) {
    std::erase_if(buckets_, [&](const auto& entry) {
        const Bucket& bucket = entry.second;
        return bucket.tokens + (now_s - bucket.at_s) * rules_.tokens_per_s >= rules_.most_tokens;
    });
    if (buckets_.size() * 2 < rules_.most_addresses) return;
    for (auto entry = buckets_.begin(); entry != buckets_.end();) {
        entry = buckets_.erase(entry);
        if (entry != buckets_.end()) ++entry;
    }
}

bool ShareLimits::allows(const AddressKey& address, double now_s) {
    Bucket& bucket = bucket_of(address, now_s);
    if (bucket.tokens < 1.0) return false;
    bucket.tokens -= 1.0;
    return true;
}

void ShareLimits::missed(const AddressKey& address, double now_s) {
    Bucket& bucket = bucket_of(address, now_s);
    bucket.tokens = std::max(0.0, bucket.tokens - rules_.miss_costs);
}

}  // namespace onggi::sharing
