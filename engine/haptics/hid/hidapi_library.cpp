#include "engine/haptics/hid/hidapi_library.h"

#include <hidapi/hidapi.h>

#include <cstdint>

namespace onggi::haptics::hid {
namespace {

// A library of C with a state of its own has one lock for the whole program.
jobs::Turnstile& turnstile() {
    static jobs::Turnstile only;
    return only;
}

}  // namespace

HidapiTurn::HidapiTurn() : pass_(turnstile()) {}

Result<void> start_hidapi() {
    const HidapiTurn turn;
    if (hid_init() != 0)
        return system_lacks("hidapi: expected to start, found no access to the system's HID devices");
    return {};
}

// Device strings are UTF-16 in the descriptor and wchar_t in hidapi; they go on as UTF-8. What is no
// character is left out, so that a broken device cannot break a terminal.
std::string utf8_from(const wchar_t* wide) {
    std::string text;
    for (; wide != nullptr && *wide != L'\0'; ++wide) {
        const auto point = static_cast<std::uint32_t>(*wide);
        const bool is_control = point < 0x20 || (point >= 0x7f && point < 0xa0);
        const bool is_surrogate = point >= 0xd800 && point < 0xe000;
        if (is_control || is_surrogate || point > 0x10ffff) continue;
        const auto continuation = [&](unsigned shift) {
            text.push_back(static_cast<char>(0x80U | ((point >> shift) & 0x3fU)));
        };
        if (point < 0x80) {
            text.push_back(static_cast<char>(point));
        } else if (point < 0x800) {
            text.push_back(static_cast<char>(0xc0U | (point >> 6U)));
            continuation(0);
        } else if (point < 0x10000) {
            text.push_back(static_cast<char>(0xe0U | (point >> 12U)));
            continuation(6);
            continuation(0);
        } else {
            text.push_back(static_cast<char>(0xf0U | (point >> 18U)));
            continuation(12);
            continuation(6);
            continuation(0);
        }
    }
    return text;
}

}  // namespace onggi::haptics::hid
