#include "engine/window/pens.h"

#include <xcb/xcb.h>
#include <xcb/xinput.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <string_view>

namespace onggi::window {
namespace {

// Labels of the drivers of Wacom, of libinput and of Xwayland.
constexpr std::array<std::string_view, kPenAxes> kLabels{"Abs Pressure", "Abs Tilt X", "Abs Tilt Y"};
// The ends of a tilt's range, in all three drivers.
constexpr double kMostTiltRad = 64.0 * kPi / 180.0;

// Reads a value at an offset; zero past the end.
template <typename T>
T value_at(std::span<const std::byte> bytes, std::size_t offset) {
    T value{};
    if (offset <= bytes.size() && bytes.size() - offset >= sizeof value)
        std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

// Fixed point: 32 integer bits, 32 fractional bits.
double number_at(std::span<const std::byte> bytes, std::size_t offset) {
    return value_at<std::int32_t>(bytes, offset) + value_at<std::uint32_t>(bytes, offset + 4) / 4294967296.0;
}

std::size_t padded(std::size_t bytes) {
    return (bytes + 3) / 4 * 4;
}

// Where the fields of a valuator's class lie.
constexpr std::size_t kNumberAt = 6;
constexpr std::size_t kLabelAt = 8;
constexpr std::size_t kLeastAt = 12;
constexpr std::size_t kMostAt = 20;
constexpr std::size_t kModeAt = 40;
constexpr std::size_t kValuatorBytes = 44;

}  // namespace

std::vector<PenDevice> read_pens(std::span<const std::byte> infos, int count,
                                 const std::array<std::uint32_t, kPenAxes>& labels) {
    constexpr std::size_t kHeadBytes = 12;
    std::vector<PenDevice> pens;
    for (; count > 0 && infos.size() >= kHeadBytes; --count) {
        PenDevice pen{.id = value_at<std::uint16_t>(infos, 0)};
        bool is_pen = value_at<std::uint16_t>(infos, 2) == XCB_INPUT_DEVICE_TYPE_SLAVE_POINTER &&
                      value_at<std::uint8_t>(infos, 10) != 0;
        std::size_t at = kHeadBytes + padded(value_at<std::uint16_t>(infos, 8));
        for (int classes = value_at<std::uint16_t>(infos, 6); classes > 0; --classes) {
            const auto type = value_at<std::uint16_t>(infos, at);
            const std::size_t bytes = std::size_t{4} * value_at<std::uint16_t>(infos, at + 2);
            if (bytes == 0) return pens;
            // A touch screen's fingers are no pens.
            if (type == XCB_INPUT_DEVICE_CLASS_TYPE_TOUCH) is_pen = false;
            const bool is_whole = bytes >= kValuatorBytes && at + kValuatorBytes <= infos.size();
            if (type == XCB_INPUT_DEVICE_CLASS_TYPE_VALUATOR && is_whole &&
                value_at<std::uint8_t>(infos, at + kModeAt) == XCB_INPUT_VALUATOR_MODE_ABSOLUTE) {
                const auto* const label =
                    std::find(labels.begin(), labels.end(), value_at<std::uint32_t>(infos, at + kLabelAt));
                const PenDevice::Axis axis{value_at<std::uint16_t>(infos, at + kNumberAt),
                                           number_at(infos, at + kLeastAt), number_at(infos, at + kMostAt)};
                if (label != labels.end() && axis.most > axis.least)
                    pen.axes[static_cast<std::size_t>(label - labels.begin())] = axis;
            }
            at += bytes;
        }
        if (is_pen && pen.axes[0].number >= 0) pens.push_back(pen);
        infos = infos.subspan(std::min(at, infos.size()));
    }
    return pens;
}

PointerReport read_report(std::uint16_t device, std::span<const std::byte> values, int mask_words) {
    PointerReport report{.device = device, .values = {}};
    std::size_t at = std::size_t{4} * static_cast<std::size_t>(mask_words);
    for (int word = 0; word < mask_words; ++word) {
        auto mask = value_at<std::uint32_t>(values, std::size_t{4} * static_cast<std::size_t>(word));
        for (; mask != 0 && at + 8 <= values.size(); mask &= mask - 1, at += 8)
            report.values.emplace_back(32 * word + std::countr_zero(mask), number_at(values, at));
    }
    return report;
}

void PenState::know(const std::vector<PenDevice>& devices) {
    std::vector<Held> held;
    std::optional<std::size_t> leader;
    for (const PenDevice& device : devices) {
        const auto known = std::find_if(held_.begin(), held_.end(),
                                        [&](const Held& one) { return one.device.id == device.id; });
        if (leader_ && known == held_.begin() + static_cast<std::ptrdiff_t>(*leader_)) leader = held.size();
        held.push_back(known == held_.end() ? Held{} : *known);
        held.back().device = device;
    }
    held_ = std::move(held);
    leader_ = leader;
}

void PenState::take(const PointerReport& report) {
    const auto held = std::find_if(held_.begin(), held_.end(),
                                   [&](const Held& one) { return one.device.id == report.device; });
    if (held == held_.end()) return touched();
    leader_ = static_cast<std::size_t>(held - held_.begin());
    for (const auto& [number, value] : report.values) {
        for (std::size_t i = 0; i < kPenAxes; ++i) {
            const PenDevice::Axis& axis = held->device.axes[i];
            if (axis.number != number) continue;
            const bool is_tilt = i != static_cast<std::size_t>(PenAxis::kPressure);
            const double from = is_tilt ? 0.0 : axis.least;
            const double span =
                is_tilt ? std::max(std::fabs(axis.least), std::fabs(axis.most)) : axis.most - from;
            held->fraction[i] = std::clamp((value - from) / span, is_tilt ? -1.0 : 0.0, 1.0);
        }
    }
    const double pressure = held->fraction[0];
    if (!(pressure > 0.0)) return;
    held->lightest = std::min(held->lightest, pressure);
    held->firmest = std::max(held->firmest, pressure);
}

std::optional<Pen> PenState::pen() const {
    constexpr double kChanges = 0.01;
    if (!leader_) return std::nullopt;
    const Held& held = held_[*leader_];
    if (held.firmest - held.lightest < kChanges) return std::nullopt;
    return Pen{.pressure = held.fraction[0],
               .tilt_rad = kMostTiltRad * dvec2(held.fraction[1], held.fraction[2])};
}

std::unique_ptr<Pens> Pens::open() {
    auto server = InputServer::connect();
    if (server == nullptr) return nullptr;
    xcb_connection_t* const to = server->connection();
    // Raw events come whoever has grabbed the pointer, and take no event away from GLFW.
    const xcb_window_t root = xcb_setup_roots_iterator(xcb_get_setup(to)).data->root;
    const bool takes =
        server->select(root, XCB_INPUT_DEVICE_ALL_MASTER,
                       XCB_INPUT_XI_EVENT_MASK_RAW_MOTION | XCB_INPUT_XI_EVENT_MASK_RAW_BUTTON_PRESS) &&
        server->select(root, XCB_INPUT_DEVICE_ALL,
                       XCB_INPUT_XI_EVENT_MASK_HIERARCHY | XCB_INPUT_XI_EVENT_MASK_DEVICE_CHANGED);
    if (!takes) return nullptr;
    std::unique_ptr<Pens> self(new Pens(std::move(server)));
    for (std::size_t i = 0; i < kPenAxes; ++i) {
        const auto asked =
            xcb_intern_atom(to, 0, static_cast<std::uint16_t>(kLabels[i].size()), kLabels[i].data());
        const InputServer::Answer<xcb_intern_atom_reply_t> atom(xcb_intern_atom_reply(to, asked, nullptr));
        if (!atom) return nullptr;
        self->labels_[i] = atom->atom;
    }
    self->find();
    return self;
}

void Pens::find() {
    xcb_connection_t* const to = server_->connection();
    const InputServer::Answer<xcb_input_xi_query_device_reply_t> found(
        xcb_input_xi_query_device_reply(to, xcb_input_xi_query_device(to, XCB_INPUT_DEVICE_ALL), nullptr));
    if (!found) return;
    const std::span infos(reinterpret_cast<const std::byte*>(found.get()) + sizeof *found,
                          std::size_t{4} * found->length);
    state_.know(read_pens(infos, found->num_infos, labels_));
}

void Pens::poll() {
    bool has_changed = false;
    while (const auto event = server_->next_event()) {
        if (event->event_type == XCB_INPUT_HIERARCHY || event->event_type == XCB_INPUT_DEVICE_CHANGED) {
            has_changed = true;
            continue;
        }
        const auto* raw = reinterpret_cast<const xcb_input_raw_motion_event_t*>(event.get());
        // The event's length does not count the word that xcb adds to its head.
        const std::span values(reinterpret_cast<const std::byte*>(raw) + sizeof *raw,
                               std::size_t{4} * raw->length);
        if (std::exchange(has_changed, false)) find();
        state_.take(read_report(raw->sourceid, values, raw->valuators_len));
    }
    if (has_changed) find();
}

}  // namespace onggi::window
