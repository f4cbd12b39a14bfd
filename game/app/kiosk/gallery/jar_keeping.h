// The bowls of a jar in the making with their histories: sets them aside, tries them together, joins them,
// and undoes each step; writes every step to the disk, so that an interrupted visit can go on. The keeper's
// thread.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "game/app/kiosk/gallery/interrupted_session.h"
#include "game/haptic/history.h"

namespace onggi::app {

// The placement of the upper bowl on the lower one.
struct JarJoin {
    dvec2 shift_mm{0.0};    // x and z, in the lower bowl's clay frame
    double mouth_mm = 0.0;  // outer diameter of the opening cut into the upper bowl's foot
};

// The clay on the wheel.
enum class JarStage { kNone, kFirstBowl, kSecondBowl, kJar };

class JarKeeping {
  public:
    // FOLDER/jar.json stores the stage; the bowls' sessions are FOLDER/jar-1.onggi and jar-2.onggi.
    JarKeeping(std::filesystem::path folder, const haptic::HapticState& lump,
               const haptic::HapticParameters& parameters)
        : folder_(std::move(folder)),
          lump_(lump),
          parameters_(parameters) {}

    // Begins a jar modelled on that museum's pot. begin(), note() and set_aside() return the disk's errors,
    // but take effect all the same.
    Result<void> begin(std::string target);
    // Records that another stage's clay is on the wheel.
    Result<void> note(JarStage stage);
    // Sets the first bowl aside and writes it to the disk, because from now on no journal contains it.
    Result<void> set_aside(haptic::History&& bowl);
    [[nodiscard]] bool has_bowl() const { return first_ != nullptr; }
    // Precondition: has_bowl().
    [[nodiscard]] const haptic::HapticState& bowl() const { return first_->state(); }
    // The distance between the two rims, mm. kBadInput: see join_pots(). Precondition: has_bowl().
    [[nodiscard]] Result<double> rims_mm(const clay::StudioClay& second, double mouth_mm) const;
    // Joins the bowls: returns the jar's history, which begins with the joined pot, and keeps the second
    // bowl's. Errors as rims_mm(), without effect. Precondition: has_bowl().
    [[nodiscard]] Result<haptic::History> join(haptic::History& second, const JarJoin& join);
    // The history of the bowl that undo may restore: the first bowl's before the joining, the second one's
    // after it; null if that bowl cannot be restored.
    [[nodiscard]] const haptic::History* to_take_back(bool is_second) const {
        return is_second == (second_ != nullptr) ? (is_second ? second_ : first_).get() : nullptr;
    }
    // Returns that bowl's history, to continue it. Precondition: it may be taken back.
    [[nodiscard]] haptic::History take_back();
    // Drops the jar on the wheel; the first bowl waits for a new second one.
    Result<void> drop_second();
    // Deletes the jar's state, also on the disk.
    void forget();

    [[nodiscard]] JarStage stage() const { return stage_; }
    [[nodiscard]] const std::string& target() const { return target_; }
    // The sessions of the joined jar's bowls, to keep beside the jar's own session, which begins where they
    // end. Empty if the bowls are not joined.
    [[nodiscard]] std::vector<std::filesystem::path> sessions() const;

    // Reads the state of an interrupted visit; appends a line to `remarks` for damaged files, which are
    // dropped. Error: the disk or memory fails; the files stay for the next start.
    Result<void> look(std::vector<std::string>& remarks);
    // Replays up to `ticks` more ticks of the bowls. Returns true while there are more. Error: a bowl cannot
    // be replayed, and the jar is dropped; or one cannot be read, as in look(), and the stage stays.
    Result<bool> restore(int ticks);
    // The clay on the jar's wheel if it has no journal; otherwise null. Errors as look().
    [[nodiscard]] Result<std::unique_ptr<InterruptedSession>> left_over() const;
    // The state with which the clay on the jar's wheel began.
    [[nodiscard]] const haptic::HapticState& start() const { return jar_start_ ? *jar_start_ : lump_; }

  private:
    [[nodiscard]] Result<clay::StudioClay> joined(const clay::StudioClay& second, const JarJoin& join) const;
    [[nodiscard]] std::filesystem::path session_place(int bowl) const;
    [[nodiscard]] std::filesystem::path note_place() const { return folder_ / "jar.json"; }
    [[nodiscard]] Result<void> save(const haptic::History& history, int bowl) const;
    [[nodiscard]] Result<void> read_note();
    void remove(const std::filesystem::path& file) const noexcept;

    std::filesystem::path folder_;
    haptic::HapticState lump_;
    haptic::HapticParameters parameters_;
    JarStage stage_ = JarStage::kNone;
    std::string target_;
    JarJoin join_;
    std::unique_ptr<haptic::History> first_;
    std::unique_ptr<haptic::History> second_;       // set once they are joined
    std::unique_ptr<InterruptedSession> restored_;  // the bowl that is being replayed
    std::optional<haptic::HapticState> jar_start_;  // of a jar that was restored
};

}  // namespace onggi::app
