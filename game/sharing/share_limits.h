// How much one address may ask for: a bucket of tokens each, in memory only and forgotten when it is full
// again. No clock: time is handed in. Any one thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>

namespace onggi::sharing {

// An address as the buckets know it: IPv4 whole, of IPv6 the network of a house (64 bits), because a machine
// may take any address within.
using AddressKey = std::array<std::uint8_t, 9>;
[[nodiscard]] AddressKey key_of_ipv4(const std::uint8_t (&address)[4]);
[[nodiscard]] AddressKey key_of_ipv6(const std::uint8_t (&address)[16]);

struct RateRules {
    // A page and what it loads are some ten requests; behind one address may stand a whole museum's Wi-Fi.
    double most_tokens = 400.0;
    double tokens_per_s = 60.0;
    // A code that is none costs more: who guesses gets four a second, and finds one of 200 pots among 2^40
    // codes after some twenty years. Codes last a day.
    double miss_costs = 15.0;
    std::size_t most_addresses = 4096;
};

class ShareLimits {
  public:
    explicit ShareLimits(const RateRules& rules = {}) : rules_(rules) {}

    // Whether this one may ask once more; takes a token if so. now_s never goes back.
    [[nodiscard]] bool allows(const AddressKey& address, double now_s);
    // It asked for a code that is none.
    void missed(const AddressKey& address, double now_s);

    [[nodiscard]] std::size_t addresses() const { return buckets_.size(); }

  private:
    struct Bucket {
        double tokens = 0.0;
        double at_s = 0.0;
    };
    Bucket& bucket_of(const AddressKey& address, double now_s);
    void make_room(double now_s);

    RateRules rules_;
    std::map<AddressKey, Bucket> buckets_;
};

}  // namespace onggi::sharing
