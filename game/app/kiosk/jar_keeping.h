// The bowls of a jar in the making, with all that was done to each, beside the frame: set aside, held
// together, joined, and back again. The keeper's thread.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "engine/core/result.h"
#include "game/haptic/history.h"

namespace onggi::app {

// How the upper bowl is set on the lower one.
struct JarJoin {
    dvec2 shift_mm{0.0};    // x and z, in the lower one's clay frame
    double mouth_mm = 0.0;  // across and outside, where the upper one's foot is cut open
};

class JarKeeping {
  public:
    // The bowls' sessions are FOLDER/jar-1.onggi and jar-2.onggi.
    JarKeeping(std::filesystem::path folder, const haptic::HapticParameters& parameters)
        : folder_(std::move(folder)),
          parameters_(parameters) {}

    // The first bowl, as it is now. An error of the disk's: it is kept here all the same.
    Result<void> set_aside(haptic::History&& bowl);
    [[nodiscard]] bool has_bowl() const { return first_ != nullptr; }
    // How far apart the rims of the two are, mm. kBadInput as join_pots(). Precondition: has_bowl().
    [[nodiscard]] Result<double> rims_mm(const clay::StudioClay& second, double mouth_mm) const;
    // The history of the jar, which begins as the two are joined; the second bowl's is kept. Errors: as
    // rims_mm(), and then nothing has changed. Precondition: has_bowl().
    [[nodiscard]] Result<haptic::History> join(haptic::History& second, const JarJoin& join);
    // What was done is taken back: that bowl's history, to go on with. None where there is none.
    [[nodiscard]] std::optional<haptic::History> take_back();  // the first one's, before they are joined
    [[nodiscard]] std::optional<haptic::History> part();       // the second one's
    // The jar is gone from the wheel, and the first bowl waits for another second one.
    void drop_second();
    void forget();

    // Of the bowls that the jar on the wheel is made of, for who keeps it: its own session begins where
    // theirs end. Empty: it is not joined.
    [[nodiscard]] std::vector<std::filesystem::path> sessions() const;

  private:
    [[nodiscard]] Result<clay::StudioClay> joined(const clay::StudioClay& second, const JarJoin& join) const;
    [[nodiscard]] std::filesystem::path session_place(int bowl) const;
    [[nodiscard]] Result<void> save(const haptic::History& history, int bowl) const;

    std::filesystem::path folder_;
    haptic::HapticParameters parameters_;
    std::unique_ptr<haptic::History> first_;
    std::unique_ptr<haptic::History> second_;  // once they are joined
};

}  // namespace onggi::app
