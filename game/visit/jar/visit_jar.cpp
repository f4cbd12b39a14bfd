#include "game/visit/jar/visit_jar.h"

#include <utility>

#include "game/clay/studio/hand.h"
#include "game/heritage/jar.h"
#include "game/pot/set_aside.h"

namespace onggi::visit {
namespace {

JarStep jar_step(const VisitFlow& flow) {
    return flow.state().throwing.jar.step;
}

}  // namespace

bool VisitJar::works_on(Finger what) const {
    return step_of(flow_.state().screen).finger == what;
}

const heritage::Target* VisitJar::target() const {
    const std::optional<int> chosen = flow_.state().throwing.target;
    if (!chosen) return nullptr;
    return &targets_[places_[static_cast<std::size_t>(*chosen)]];
}

void VisitJar::set_aside(std::shared_ptr<const pot::Pot> bowl) {
    bowl_ = std::move(bowl);
    bowl_section_ = std::make_shared<const pot::Section>(pot::section_of(*bowl_));
}

void VisitJar::forget() {
    bowl_.reset();
    bowl_section_.reset();
}

void VisitJar::look(const haptic::Snapshot& snapshot) {
    constexpr double kLeastOfBowl = 2.0 / 3.0;  // of the target bowl's height
    const kiosk::JarMaking& jar = flow_.state().throwing.jar;
    const bool throws_bowl = jar.step == JarStep::kFirstBowl || jar.step == JarStep::kSecondBowl;
    const heritage::Target* const after = target();
    if (!works_on(Finger::kClay) || !throws_bowl || after == nullptr) return;
    const double least_mm = kLeastOfBowl * double{heritage::jar_of(*after).bowl_mm.back().y};
    const pot::Pot& shape = *snapshot.pot;
    const bool is_open = shape.can_be_hollow() && !shape.inner_mm.empty() && shape.inner_mm.back() > 0.0F;
    const bool is_bowl = is_open && shape.height_mm >= least_mm;
    if (is_bowl == jar.is_bowl) return;
    flow_.dispatch(kiosk::event::Bowl{is_bowl});
}

std::string VisitJar::target_id() const {
    const heritage::Target* const after = target();
    return after != nullptr ? after->id : std::string();
}

std::vector<vec2> VisitJar::outline() const {
    const heritage::Target* const after = target();
    if (after == nullptr || !works_on(Finger::kClay)) return {};
    switch (jar_step(flow_)) {
        case JarStep::kNone:
            return heritage::wet_outline(*after);
        case JarStep::kFirstBowl:
            return heritage::jar_of(*after).bowl_mm;
        case JarStep::kAside:
        case JarStep::kSecondBowl:
            return bowl_section_ ? bowl_section_->outside : heritage::jar_of(*after).bowl_mm;
        case JarStep::kJoin:
        case JarStep::kSeam:
            break;
    }
    return {};
}

std::shared_ptr<const pot::Section> VisitJar::aside() const {
    const bool is_aside = works_on(Finger::kClay) &&
                          (jar_step(flow_) == JarStep::kAside || jar_step(flow_) == JarStep::kSecondBowl);
    return is_aside ? bowl_section_ : nullptr;
}

dvec2 VisitJar::shift_mm(const dvec2& heading) const {
    const double right_mm = flow_.state().throwing.jar.shift_mm;
    return right_mm * clay::studio::into_clay({1.0, 0.0}, {heading.x, heading.y});
}

double VisitJar::mouth_mm() const {
    const heritage::Target* const after = target();
    return after != nullptr ? heritage::jar_of(*after).mouth_mm : 0.0;
}

double VisitJar::height_mm(const haptic::Snapshot& snapshot) const {
    const bool is_both = works_on(Finger::kBowl) && bowl_;
    return snapshot.pot->height_mm + (is_both ? bowl_->height_mm : 0.0);
}

void VisitJar::show(wheel::WheelScene& scene, const haptic::Snapshot& snapshot) {
    ecs::Registry& registry = scene.registry();
    if (!bowl_) return registry.destroy(in_scene_);
    if (!registry.alive(in_scene_)) in_scene_ = registry.create();
    registry.add(in_scene_, wheel::PotApart{.pot = bowl_.get()});
    if (works_on(Finger::kBowl)) {
        registry.add(in_scene_, wheel::HeldOver{vec2(shift_mm(snapshot.wheel_direction))});
    } else {
        registry.remove<wheel::HeldOver>(in_scene_);
    }
}

}  // namespace onggi::visit
