// The effects of a visit's steps, applied: to the wheel, to the keeper's disk, to the staff's desk; and the
// pots that come of it. Main thread.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "game/app/kiosk/staff/staff_desk.h"
#include "game/app/kiosk/visit/visit_drawing.h"
#include "game/app/kiosk/visit/visit_input.h"
#include "game/app/kiosk/visit/visit_jar.h"
#include "game/app/kiosk/visit/visit_parts.h"
#include "game/app/kiosk/visit/visit_wheel.h"
#include "game/screens/page/view.h"

namespace onggi::app {

class VisitEffects {
  public:
    // All outlive it.
    VisitEffects(const VisitParts& parts, VisitWheel& wheel, VisitInput& input, VisitDrawing& drawing,
                 VisitJar& jar, VisitTrim& trim, StaffDesk& desk, VisitFlow& flow)
        : parts_(parts),
          wheel_(wheel),
          input_(input),
          drawing_(drawing),
          jar_(jar),
          trim_(trim),
          desk_(desk),
          flow_(flow) {}

    // left: the screen before the step that asks for it.
    void apply(const kiosk::Effect& effect, const VisitMoment& moment, kiosk::Screen left);
    // What the keeper has done meanwhile. Once a frame.
    void take_answers();

    // The visitor's pot, fired; null before.
    [[nodiscard]] const std::shared_ptr<const screens::FiredPot>& pot() const { return pot_; }
    // The last few pots that were kept, the newest first.
    [[nodiscard]] const std::vector<screens::ShelfPot>& day() const { return day_; }
    [[nodiscard]] std::uint64_t pots_kept() const { return pots_kept_; }  // since the start
    // How the kept pot goes home by phone; null where it does not, or not yet.
    [[nodiscard]] const std::shared_ptr<const screens::PhoneWay>& phone_way() const { return phone_way_; }
    // The wall of the day, the oldest pot first; null or empty: nothing is there.
    [[nodiscard]] const std::shared_ptr<const std::vector<screens::ShelfPot>>& wall() const { return wall_; }
    // When a pot was put there last; long ago, where none was.
    [[nodiscard]] double put_on_wall_s() const { return put_on_wall_s_; }
    [[nodiscard]] bool quits() const { return quits_; }
    [[nodiscard]] bool restarts() const { return restarts_; }

  private:
    // Parts of apply(), each for the effects on one thing.
    void apply_to_clay(const kiosk::Effect& effect, const VisitMoment& moment);
    void apply_to_drawing(const kiosk::Effect& effect, const VisitMoment& moment);
    void apply_to_jar(const kiosk::Effect& effect, const VisitMoment& moment);
    void apply_to_done_pot(const kiosk::Effect& effect, const VisitMoment& moment);  // once it is cut off
    void apply_to_kiosk(const kiosk::Effect& effect);  // its house settings, its staff's desk, its end
    void move_hand(kiosk::Button direction);           // a button of the pad
    void resume(const VisitMoment& moment);
    // Of the settings' targets.
    [[nodiscard]] std::optional<std::size_t> thrown_after() const;
    void write_session();
    // One by one, what the keeper answers.
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
    // And the phones' keeper.
    void take(const PhoneAnswer::OfPot& shared);
    void take(const PhoneAnswer::Survey& survey) { desk_.take(survey); }
    void take(const PhoneAnswer::Remark&) {}
    void fire_drawing();
    void save();
    void share();
    void keep_house();
    void move_on_wall(bool up, double now_s);

    const VisitParts& parts_;
    VisitWheel& wheel_;
    VisitInput& input_;
    VisitDrawing& drawing_;
    VisitJar& jar_;
    VisitTrim& trim_;
    StaffDesk& desk_;
    VisitFlow& flow_;
    std::shared_ptr<const screens::FiredPot> pot_;
    std::shared_ptr<const pot::Pot> interrupted_bowl_;  // the first of an interrupted jar
    std::shared_ptr<const decoration::Recorded> interrupted_drawing_;
    std::vector<screens::ShelfPot> day_;
    bool may_be_trimmed_ = false;  // it is about to be cut off for the first time
    std::string kept_name_;        // of it, in the gallery
    std::shared_ptr<const screens::PhoneWay> phone_way_;
    static constexpr double kLongAgoS = -1e9;
    std::shared_ptr<const std::vector<screens::ShelfPot>> wall_;
    double put_on_wall_s_ = kLongAgoS;
    bool thrown_ = false;  // clay was put on in this visit
    int kept_ = 0;         // pots of it
    std::uint64_t pots_kept_ = 0;
    bool quits_ = false;
    bool restarts_ = false;
};

}  // namespace onggi::app
