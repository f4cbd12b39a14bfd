// The bowls of a jar in the making, with all that was done to each, beside the frame: set aside, held
// together, joined, and back again; noted on the disk at every step, so that an interrupted visit goes on
// where it was. The keeper's thread.
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

// How the upper bowl is set on the lower one.
struct JarJoin {
    dvec2 shift_mm{0.0};    // x and z, in the lower one's clay frame
    double mouth_mm = 0.0;  // across and outside, where the upper one's foot is cut open
};

// Which clay is on the wheel.
enum class JarStage { kNone, kFirstBowl, kSecondBowl, kJar };

class JarKeeping {
  public:
    // FOLDER/jar.json says how far it has come; the bowls' sessions are FOLDER/jar-1.onggi and jar-2.onggi.
    JarKeeping(std::filesystem::path folder, const haptic::HapticState& lump,
               const haptic::HapticParameters& parameters)
        : folder_(std::move(folder)),
          lump_(lump),
          parameters_(parameters) {}

    // A jar after that pot of a museum. The errors of these and of set_aside() are the disk's: what was asked
    // is done all the same.
    Result<void> begin(std::string target);
    // Another clay of the jar is on the wheel now.
    Result<void> note(JarStage stage);
    // The first bowl, as it is now; noted once nothing else tells of it.
    Result<void> set_aside(haptic::History&& bowl);
    [[nodiscard]] bool has_bowl() const { return first_ != nullptr; }
    // Precondition: has_bowl().
    [[nodiscard]] const haptic::HapticState& bowl() const { return first_->state(); }
    // How far apart the rims of the two are, mm. kBadInput as join_pots(). Precondition: has_bowl().
    [[nodiscard]] Result<double> rims_mm(const clay::StudioClay& second, double mouth_mm) const;
    // The history of the jar, which begins as the two are joined; the second bowl's is kept. Errors: as
    // rims_mm(), and then nothing has changed. Precondition: has_bowl().
    [[nodiscard]] Result<haptic::History> join(haptic::History& second, const JarJoin& join);
    // What may be taken back: the first bowl before the two are joined, or the second one then; null: that
    // one may not.
    [[nodiscard]] const haptic::History* to_take_back(bool is_second) const {
        return is_second == (second_ != nullptr) ? (is_second ? second_ : first_).get() : nullptr;
    }
    // That bowl's history, to go on with. Precondition: it may be taken back.
    [[nodiscard]] haptic::History take_back();
    // The jar is gone from the wheel, and the first bowl waits for another second one.
    Result<void> drop_second();
    // Nothing of it stays, on the disk neither.
    void forget();

    [[nodiscard]] JarStage stage() const { return stage_; }
    [[nodiscard]] const std::string& target() const { return target_; }
    // Of the bowls that the jar on the wheel is made of, for who keeps it: its own session begins where
    // theirs end. Empty: it is not joined.
    [[nodiscard]] std::vector<std::filesystem::path> sessions() const;

    // Of an interrupted visit: looks for what it noted; a line for what is damaged.
    void look(std::vector<std::string>& remarks);
    // Works out so many ticks more of its bowls. True while there are more. An error: a bowl cannot be worked
    // out, and the jar is forgotten.
    Result<bool> restore(int ticks);
    // What was on its wheel, where there is no journal of that; null: nothing.
    [[nodiscard]] std::unique_ptr<InterruptedSession> left_over() const;
    // What the clay on its wheel began as.
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
    std::unique_ptr<haptic::History> second_;       // once they are joined
    std::unique_ptr<InterruptedSession> restored_;  // the bowl that is being worked out
    std::optional<haptic::HapticState> jar_start_;  // of a jar that was restored
};

}  // namespace onggi::app
