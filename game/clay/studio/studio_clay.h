// The studio clay: clay with an inside, a weight and a strength, thrown on a wheel of its own. Any one thread
// at a time; the tick allocates nothing, calls nothing outside this room and cannot fail. Units: mm, mm^3, N,
// s, rad, kPa, g. Frame: +Y up along the wheel axis, origin at the centre of the wheel head; the wheel turns
// counter-clockwise seen from above.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "game/clay/paper_clay.h"
#include "game/clay/studio/contact.h"
#include "game/clay/studio/grip_work.h"
#include "game/clay/studio/hand.h"
#include "game/clay/studio/load.h"
#include "game/clay/studio/lump.h"
#include "game/clay/studio/rings.h"
#include "game/clay/studio/studio_parameters.h"
#include "game/clay/studio/wheel.h"

namespace onggi::clay {

class StudioClay;
struct Joining;
// See joining.h.
Result<StudioClay> join_pots(const StudioClay& lower, const StudioClay& upper, const Joining& joining);

namespace studio {

// Below this speed the wheel counts as standing: a hand dents the clay instead of shaping a turning ring.
constexpr double kTurningRadS = 0.2;

// Trimming a foot: where the pot bears it, and how far a trimmer may cut.

// Chosen: the wall and the foot that a potter leaves at least.
constexpr double kTrimmedWallMm = 3.0;
constexpr double kTrimmedFootMm = 15.0;

// LI of leather-hard clay, which keeps its shape and can still be cut: the plastic limit.
constexpr double kLeatherHardLiquidity = 0.0;

// Wall thickness right above the floor; 0 if the clay is solid.
double foot_wall_mm(const Rings& rings);

// The outer radius that a careful trimmer leaves ring i: three millimetres of wall, measured across it and
// round the floor's corner; for solid clay below, a foot.
double least_outer_mm(const Rings& rings, int i) noexcept;

// Dries all clay to leather hard at once. Drier clay stays unchanged.
void dry_to_leather(Rings& rings) noexcept;

}  // namespace studio

// Result of one tick.
struct StudioForces {
    ContactForces hand;    // on the first hand; touched rings as in the paper's clay
    ContactForces second;  // on the second hand, or on the assist
    double wheel_load_n_mm = 0.0;
    tool::Side side = tool::Side::kFree;
    tool::Side second_side = tool::Side::kFree;
    bool rings_moved = false;  // rings were split, joined or removed: all indices changed
    bool has_second = false;   // a second hand or the assist was active, at this place:
    dvec3 second_position_mm{0.0};
    studio::GripReport grip;  // of a guided hand

    [[nodiscard]] dvec3 total_n() const { return hand.total_n(); }  // for the device in the first hand
};

// Checks a lump against the limits named at its fields.
Result<void> check(const StudioLump& lump);

// A pot of N rings that own volume (rings.h); their heights follow from their radii. Hands shape it by touch.
// A tick runs in this order: wheel, hands (hand.h), contact (contact.h), pushes and presses (moves.h), the
// wall as a whole (wall_field.h), centring and sectors (roundness.h), places, split and join (rings.h), load
// and slump (load.h), forces (force.h).
//
// MODEL.md beside this file states the laws. Departures from their plain form:
// Differs: a lump starts with as many rings as its height needs at 200 mm/N each and has room for 2 N; N
//   rings of a low dome would be flakes.
// Differs: a push that would break a bound is shortened to it rather than refused, so that a fast hand moves
//   the clay as fast as it may instead of not at all. The refusal stays as the final check.
// Differs: sectors do not take part in the flow of the mean circle. A bump passing under the hand would cone
//   the whole ring, as off-centre clay would.
// Differs: forces use the depth before the tick's flow, which removes about a hundredth of that depth.
//   join run in the ticks between, each with the time step of both.
class StudioClay {
  public:
    // Precondition: check(lump) holds.
    explicit StudioClay(const StudioLump& lump = {});

    [[nodiscard]] const StudioLump& lump() const { return lump_; }
    [[nodiscard]] int ring_count() const { return rings_.count; }
    [[nodiscard]] int ring_capacity() const { return rings_.capacity; }
    [[nodiscard]] int sector_count() const { return rings_.sectors; }
    [[nodiscard]] double height_mm() const { return rings_.top_mm(); }
    [[nodiscard]] double floor_mm() const { return rings_.floor_mm(); }
    // Bottom first; ring_count() values each.
    [[nodiscard]] std::span<const double> outer_mm() const { return column(rings_.outer_mm); }
    [[nodiscard]] std::span<const double> inner_mm() const { return column(rings_.inner_mm); }
    [[nodiscard]] double centre_height_mm(int ring) const { return rings_.centre_mm(ring); }
    // Off-centre of a ring, x and z in the clay's frame.
    [[nodiscard]] dvec2 centre_mm(int ring) const;
    // Residuals of a ring, sector_count() values, counter-clockwise; empty if the ring is round.
    [[nodiscard]] std::span<const float> residuals_mm(int ring) const;
    [[nodiscard]] const studio::Rings& rings() const { return rings_; }

    [[nodiscard]] const studio::Ledger& ledger() const { return ledger_; }
    [[nodiscard]] double volume_mm3() const { return rings_.on_wheel_mm3(); }
    [[nodiscard]] double ledger_error_mm3() const { return ledger_.error_mm3(volume_mm3()); }

    // The warning: the largest load index of the last sweep, its height and its cause.
    [[nodiscard]] double load_index() const { return sweep_.peak_index; }
    [[nodiscard]] double load_height_mm() const { return sweep_.peak_height_mm; }
    [[nodiscard]] studio::Cause load_cause() const { return sweep_.peak_cause; }
    // The first ring that failed; Cause::kNone while all stand.
    [[nodiscard]] const studio::Failure& failure() const { return sweep_.failure; }
    // Cut off the wheel: the pot is finished, hands no longer move it.
    [[nodiscard]] bool is_cut_off() const { return carried_.cut_off; }
    // Whether all clay is leather hard or drier; a guided trimmer works only on such clay.
    [[nodiscard]] bool is_leather_hard() const;
    // Water on the hands, 0 to 1.
    [[nodiscard]] double film() const { return carried_.film; }
    // Puts a cut-off pot back on the wheel, standing, so that it can be thrown on. A pot that was not cut off
    // gets the same state.
    void put_back();
    [[nodiscard]] std::uint64_t splits() const { return carried_.splits; }
    [[nodiscard]] std::uint64_t joins() const { return carried_.joins; }

    [[nodiscard]] const studio::PoweredWheel& wheel() const { return wheel_; }
    void set_wheel_speed(double speed_rad_s) { wheel_.set_speed(speed_rad_s); }

    // For tests, demonstrations and benchmarks. Replaces the clay by a wall: solid of that outer radius up to
    // floor_mm, hollow above. The ledger restarts. Precondition: within the bounds of studio_parameters.h;
    // the wall's rings fit.
    void set_wall(double outer_mm, double wall_mm, double floor_mm, double height_mm, int rings);
    // For the same uses. Sets new radii for the present rings, with volumes that keep every height. Same
    // preconditions.
    void set_profile(std::span<const double> outer_mm, std::span<const double> inner_mm);
    // For the same uses. Sets all ring centres, in the clay's frame.
    void set_centre(const dvec2& centre_mm);
    void set_liquidity(double liquidity_index);

    // Puts a fresh lump on the wheel; the wheel keeps turning. No allocation.
    void restart() noexcept;
    // Copies the clay and the wheel of another start. Precondition: a lump with as many rings and sectors. No
    // allocation.
    void restart_from(const StudioClay& start) noexcept;

    // Commits all memory that this clay may need, so that no tick is the first to touch a page. Without this
    // call a clay takes only what its rings use.
    void take_memory() noexcept { rings_.residual_mm.take_memory(); }

    // One step of 1/f. A hand with a number that is not finite counts as absent. Precondition:
    // check(parameters) holds.
    StudioForces tick(const tool::ToolState& tool, const StudioParameters& parameters) noexcept;

    // Hash of everything a later tick depends on, for replay checks. No allocation.
    [[nodiscard]] std::uint64_t state_hash() const;
    // The same state as little-endian bytes, and its reader. The reader refuses a wrong size and any state
    // that no tick could have left.
    [[nodiscard]] std::vector<std::byte> start_state() const;
    static Result<StudioClay> from_start_state(std::span<const std::byte> bytes);

  private:
    friend Result<StudioClay> join_pots(const StudioClay&, const StudioClay&, const Joining&);

    [[nodiscard]] std::span<const double> column(const std::vector<double>& values) const {
        return {values.data(), static_cast<std::size_t>(rings_.count)};
    }
    // Visits every number of the state in a fixed order: for the hash, the writer and the reader.
    template <typename Self, typename Visitor>
    static void visit_state(Self& self, Visitor& visitor);

    // The hands that no grip guides in this tick; the second may be the assist.
    struct Hands {
        std::array<bool, 2> present{};
        bool opposite = false;  // each bears against the other, across a wall
    };

    void use_wire(const tool::ToolState& tool);
    // touch: whether the first hand presses and is not guided. Fills in hands_ and, for each hand present,
    // its contact in contacts_.
    Hands find_hands(const tool::ToolState& tool, const StudioParameters& parameters, bool touch);
    // Computes the forces on the hands, then lets the hands work the clay.
    void work_hands(const Hands& hands, double water, const StudioParameters& parameters,
                    StudioForces& result);
    studio::Changed act(studio::Contact& contact, const studio::Hand& hand, const studio::Hand* other,
                        double water, const StudioParameters& parameters);
    [[nodiscard]] studio::GripClimate climate(const tool::ToolState& tool,
                                              const StudioParameters& parameters) const;
    studio::Changed guide(const tool::ToolState& tool, const StudioParameters& parameters,
                          StudioForces& result);
    studio::Changed guide_tool(const tool::ToolState& tool, const StudioParameters& parameters,
                               StudioForces& result);
    studio::Changed guide_trimmer(const tool::ToolState& tool, const StudioParameters& parameters,
                                  StudioForces& result);
    // Lays a held tool on the outer face at the finger's height. Returns false if the finger is too far from
    // it.
    bool lay_tool(const tool::ToolState& tool, StudioForces& result, studio::Hand& hand);
    void find_tool_contact(studio::Contact& contact, double y_mm, double depth_mm, double print_mm);
    void feel_guided(const studio::Contact& contact, const studio::Hand& hand, double bears_n_mm,
                     const StudioParameters& parameters, StudioForces& result);
    bool tend_rings(double dt_s);
    double allowed_speed(double wanted_rad_s, const StudioParameters& parameters) const;
    ContactForces feel_hand(studio::Hand& hand, const studio::Contact& contact, const studio::Hand* other,
                            const StudioParameters& parameters, double& load_n_mm);
    void tear();
    static std::string damage_of(const StudioClay& clay);

    StudioLump lump_;
    studio::Rings rings_;
    studio::Ledger ledger_;
    studio::PoweredWheel wheel_;
    studio::LoadSweep sweep_;
    std::array<studio::Hand, 2> hands_;
    studio::GripState grip_;
    // The rest of the state that passes from tick to tick.
    struct Carried {
        double film = 0.0;           // water on the hands, 0 to 1
        double tend_credit = 0.0;    // ring visits paid for by simulated time
        double change_credit = 0.0;  // splits and joins, likewise
        int tend_next = 0;
        int stripe = 0;  // cycles with the ticks: selects the rings to round and the work that is due
        double wheel_load_n_mm = 0.0;  // of the last tick
        double load_height_mm = 0.0;
        bool owes_cursors = false;  // the walls used the previous tick
        bool cut_off = false;
        bool wire_was_used = false;  // one cut per pull
        std::uint64_t splits = 0;
        std::uint64_t joins = 0;
    } carried_;

    // Work space; never hashed.
    bool walls_took_turn_ = false;
    std::array<studio::Contact, 2> contacts_;
    studio::GripSpace grip_space_;
    std::vector<double> scratch_;
};

// One sentence on why the clay failed; empty while it stands.
std::string sentence(const studio::Failure& failure);

}  // namespace onggi::clay
