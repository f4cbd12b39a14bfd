// Rate limit per address: a token bucket each, kept only in memory and dropped when full again. No clock: the
// caller passes the time. Any one thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>

namespace onggi::sharing {

// The bucket key of an address: the whole of an IPv4 address; for IPv6 only the /64 network, because a
// machine may use any address within it.
using AddressKey = std::array<std::uint8_t, 9>;
[[nodiscard]] AddressKey key_of_ipv4(const std::uint8_t (&address)[4]);
[[nodiscard]] AddressKey key_of_ipv6(const std::uint8_t (&address)[16]);

struct RateRules {
    // A page and its files are some ten requests; a whole museum's Wi-Fi may share one address.
    double most_tokens = 400.0;
    double tokens_per_s = 60.0;
    // An unknown code costs more: an attacker who guesses gets four tries a second, and finds one of 200 pots
    // among 2^40 codes after some twenty years. Codes last a day.
    double miss_costs = 15.0;
    std::size_t most_addresses = 4096;
};

class ShareLimits {
  public:
    explicit ShareLimits(const RateRules& rules = {}) : rules_(rules) {}

    // Whether the address may make a request; takes a token if so. now_s never goes back.
    [[nodiscard]] bool allows(const AddressKey& address, double now_s);
    // Charges the address for an unknown code.
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
