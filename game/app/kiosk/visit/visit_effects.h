// Applies the effects of a visit's steps to the wheel, the keeper and the staff's desk; holds the resulting
// pots. Main thread.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "game/app/kiosk/staff/staff_desk.h"
#include "game/app/kiosk/visit/visit_input.h"
#include "game/app/kiosk/visit/visit_parts.h"
#include "game/app/kiosk/visit/visit_wheel.h"
#include "game/screens/page/view.h"
#include "game/visit/decorate/visit_drawing.h"
#include "game/visit/jar/visit_jar.h"

namespace onggi::app {

class VisitEffects {
  public:
    // All references must outlive it.
    VisitEffects(const VisitParts& parts, VisitWheel& wheel, VisitInput& input, visit::VisitDrawing& drawing,
                 visit::VisitJar& jar, visit::VisitTrim& trim, StaffDesk& desk, VisitFlow& flow)
        : parts_(parts),
          wheel_(wheel),
          input_(input),
          drawing_(drawing),
          jar_(jar),
          trim_(trim),
          desk_(desk),
          flow_(flow) {}

    void apply(const kiosk::Effect& effect, const VisitMoment& moment);
    // Takes the keeper's answers. Call it once a frame.
    void take_answers();

    // The visitor's fired pot; null before the firing.
    [[nodiscard]] const std::shared_ptr<const screens::FiredPot>& pot() const { return pot_; }
    // The pot of an interrupted visit, until it is accepted or declined; null without one.
    [[nodiscard]] const std::shared_ptr<const pot::Section>& left_over() const { return left_over_; }
    // The last kept pots, newest first.
    [[nodiscard]] const std::vector<screens::ShelfPot>& day() const { return day_; }
    [[nodiscard]] std::uint64_t pots_kept() const { return pots_kept_; }  // since the start
    // The code of the kept pot for phones; null without sharing or before it is ready.
    [[nodiscard]] const std::shared_ptr<const screens::PhoneWay>& phone_way() const { return phone_way_; }
    // The wall of the day, oldest first; may be null or empty.
    [[nodiscard]] const std::shared_ptr<const std::vector<screens::ShelfPot>>& wall() const { return wall_; }
    // The time of the last addition; in the distant past if there was none.
    [[nodiscard]] double put_on_wall_s() const { return put_on_wall_s_; }
    [[nodiscard]] bool quits() const { return quits_; }
    [[nodiscard]] bool restarts() const { return restarts_; }

  private:
    // Applies one effect; some need the moment.
    void apply_one(const kiosk::effect::StartDemo& /*effect*/, const VisitMoment& moment) {
        wheel_.begin_show(moment.now_s);
    }
    void apply_one(const kiosk::effect::FreshClay& effect);
    void apply_one(const kiosk::effect::Undo& /*effect*/) { parts_.keeper.undo(); }
    void apply_one(const kiosk::effect::BeforeCollapse& effect, const VisitMoment& moment);
    void apply_one(const kiosk::effect::BeginJar& /*effect*/) { parts_.keeper.begin_jar(jar_.target_id()); }
    void apply_one(const kiosk::effect::SetAside& effect);
    void apply_one(const kiosk::effect::TakeBack& back, const VisitMoment& moment);
    void apply_one(const kiosk::effect::HoldTogether& effect);
    void apply_one(const kiosk::effect::JoinBowls& effect, const VisitMoment& moment);
    void apply_one(const kiosk::effect::MoveHand& move);
    void apply_one(const kiosk::effect::CutRim& /*effect*/) { wheel_.finger().cut_rim(); }
    void apply_one(const kiosk::effect::ShowStep& show, const VisitMoment& moment);
    void apply_one(const kiosk::effect::StopShow& /*effect*/) { wheel_.finger().stop_showing(); }
    void apply_one(const kiosk::effect::CutOff& effect);
    void apply_one(const kiosk::effect::BeginTrim& effect, const VisitMoment& moment);
    void apply_one(const kiosk::effect::EndTrim& trimmed);
    void apply_one(const kiosk::effect::BeginDrawing& /*effect*/, const VisitMoment& moment) {
        drawing_.begin(moment.snapshot.wheel_direction);
    }
    void apply_one(const kiosk::effect::UndoStroke& /*effect*/) { drawing_.undo(); }
    void apply_one(const kiosk::effect::ClearDrawing& /*effect*/) { drawing_.clear(); }
    void apply_one(const kiosk::effect::PutBrush& brush);
    void apply_one(const kiosk::effect::EndDrawing& effect);
    void apply_one(const kiosk::effect::Save& effect);
    void apply_one(const kiosk::effect::Share& effect);
    void apply_one(const kiosk::effect::Wall& wall, const VisitMoment& moment);
    void apply_one(const kiosk::effect::ForgetPot& effect);
    void apply_one(const kiosk::effect::Resume& effect, const VisitMoment& moment);
    void apply_one(const kiosk::effect::DropInterrupted& /*effect*/) {
        left_over_.reset();
        parts_.keeper.drop_interrupted_session();
    }
    void apply_one(const kiosk::effect::SetVolume& set) {
        parts_.sound.set_volume(set.volume / kLoudestStep);
    }
    void apply_one(const kiosk::effect::KeepHouse& effect);
    void apply_one(const kiosk::effect::VisitBegan& effect);
    void apply_one(const kiosk::effect::VisitEnded& ended);
    void apply_one(const kiosk::effect::TestForce& /*effect*/) { desk_.test_force(); }
    void apply_one(const kiosk::effect::TestSound& /*effect*/) { desk_.test_sound(); }
    void apply_one(const kiosk::effect::DeletePot& deleted) { desk_.delete_pot(deleted.pot); }
    void apply_one(const kiosk::effect::WithdrawCode& withdrawn) { desk_.withdraw_code(withdrawn.pot); }
    void apply_one(const kiosk::effect::Restart& /*effect*/) { quits_ = restarts_ = true; }
    void apply_one(const kiosk::effect::Quit& /*effect*/) {
        quits_ = true;
        restarts_ = false;
    }
    // The target's index.
    [[nodiscard]] std::optional<std::size_t> thrown_after() const;
    // The place on the shelf of that museum's pot; empty if it is not there.
    [[nodiscard]] std::optional<int> place_of(const std::string& target_id) const;
    [[nodiscard]] VisitPlace place() const;
    void write_session();
    // The keeper's answers.
    void take(const KeeperAnswer::CutOff& cut);
    void take(const KeeperAnswer::SetAside& aside);
    void take(const KeeperAnswer::Saved& saved);
    void take(const KeeperAnswer::SessionWritten& session) { parts_.phone->film(session.place); }
    void take(const KeeperAnswer::Wall& wall) { wall_ = wall.pots; }
    void take(const KeeperAnswer::Interrupted& found);
    void take(const KeeperAnswer::Survey& survey) { desk_.take(survey); }
    void take(const KeeperAnswer::NotPut&) { wheel_.clay().expect_nothing(); }
    void take(const kiosk::Event& event);
    void take(const KeeperAnswer::Remark&) {}
    // The answers of KioskPhone.
    void take(const PhoneAnswer::OfPot& shared);
    void take(const PhoneAnswer::Survey& survey) { desk_.take(survey); }
    void take(const PhoneAnswer::Remark&) {}

    const VisitParts& parts_;
    VisitWheel& wheel_;
    VisitInput& input_;
    visit::VisitDrawing& drawing_;
    visit::VisitJar& jar_;
    visit::VisitTrim& trim_;
    StaffDesk& desk_;
    VisitFlow& flow_;
    std::shared_ptr<const screens::FiredPot> pot_;
    std::shared_ptr<const pot::Pot> interrupted_bowl_;  // the first bowl of an interrupted jar
    std::shared_ptr<const decoration::Recorded> interrupted_drawing_;
    std::shared_ptr<const pot::Section> left_over_;
    VisitPlace kept_place_;  // as the keeper knows it
    std::vector<screens::ShelfPot> day_;
    bool may_be_trimmed_ = false;  // the pot will be cut off for the first time
    std::string kept_name_;        // the pot's name in the gallery
    std::shared_ptr<const screens::PhoneWay> phone_way_;
    static constexpr double kLongAgoS = -1e9;
    std::shared_ptr<const std::vector<screens::ShelfPot>> wall_;
    double put_on_wall_s_ = kLongAgoS;
    bool thrown_ = false;  // clay was put on the wheel in this visit
    int kept_ = 0;         // number of pots kept in this visit
    std::uint64_t pots_kept_ = 0;
    bool quits_ = false;
    bool restarts_ = false;
};

}  // namespace onggi::app
