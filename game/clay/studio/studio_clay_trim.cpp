// The guided trimmer's part of the tick: a loop that lies on the outer face at the finger's height and shaves
// off what stands out beyond the finger. The pot is leather hard by then: it is cut and does not give way.
#include <algorithm>
#include <cmath>

#include "game/clay/studio/strength.h"
#include "game/clay/studio/studio_clay.h"
#include "game/clay/studio/trimming.h"

namespace onggi::clay {

studio::Changed StudioClay::guide_trimmer(const StudioInput& input, const StudioParameters& parameters,
                                          StudioForces& result) {
    constexpr double kDeepestMm = 2.0;  // of one shaving
    constexpr double kOfWheel = 0.2;    // a potter takes no more at once than the wheel bears
    if (!is_leather_hard()) {
        studio::dry_to_leather(rings_);
        studio::restart(sweep_, rings_);
        carried_.film = 0.0;
    }
    studio::Hand hand;
    if (!lay_tool(input, result, hand)) return {};
    const double y = hand.position_mm.y;
    const double face = std::fabs(result.grip.hand_mm.x);
    const double beyond = std::clamp(face - std::fabs(input.hand.position_mm.x), 0.0, kDeepestMm);
    studio::Contact& contact = contacts_[0];
    find_tool_contact(contact, y, beyond, hand.radius_mm);
    if (!contact.touches() || contact.range.size() <= 0) return {};
    feel_guided(contact, hand, kOfWheel * parameters.wheel.largest_torque_n_mm, parameters, result);
    const double fraction = studio::relaxed_fraction(parameters.dt_s() / parameters.trim_time_s);
    for (int k = 0; k < contact.range.size(); ++k) {
        const std::size_t at = studio::Rings::at(k);
        const int ring = contact.range.first + k;
        const double spare = rings_.outer_mm[studio::Rings::at(ring)] - studio::least_outer_mm(rings_, ring);
        const double most = parameters.forgiving ? std::max(spare, 0.0) / fraction : kDeepestMm;
        scratch_[at] = std::min(contact.depth_mm[at], most);
    }
    const studio::Changed changed =
        studio::cut_face(rings_, contact, hand, scratch_, fraction, ledger_.trimmings_mm3);
    if (changed.size() > 0) rings_.place(changed.first, rings_.count);
    return changed;
}

bool StudioClay::is_leather_hard() const {
    constexpr auto kLeather = static_cast<float>(studio::kLeatherHardLiquidity);
    return std::all_of(rings_.liquidity.begin(), rings_.liquidity.begin() + rings_.count,
                       [](float liquidity) { return liquidity <= kLeather; });
}

}  // namespace onggi::clay
