// Places paintings in the one texture that an overlay draws from. The texture's two halves take turns: new
// paintings go into the current half; when it is full, the other half is emptied and becomes current.
// Paintings in the old half keep their place until it is emptied; nothing is moved. No Vulkan here. Main
// thread.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "engine/ui/geometry.h"
#include "engine/ui/painting.h"

namespace onggi::ui {

class Atlas {
  public:
    // A square texture with sides of this many pixels.
    explicit Atlas(int side_px);
    // Returns the side for pictures of this size: as small as possible, because the contents are in memory
    // twice.
    [[nodiscard]] static int side_px_for(int width_px, int height_px);

    struct Upload {
        int x = 0;
        int y = 0;
        std::shared_ptr<const Painting> painting;
    };

    // Returns the place of the painting with this key, in pixels; adds the painting if it is missing. Empty
    // if the painting is larger than a half. If the current half is full, the halves are swapped and
    // generation() changes; paintings placed since begin_asking() may then have lost their place, so place
    // all of them again.
    [[nodiscard]] std::optional<Rect> place(std::uint64_t key,
                                            const std::shared_ptr<const Painting>& painting);

    // Replaces the painting with this key by another of the same size; like place() if there is none.
    [[nodiscard]] std::optional<Rect> replace(std::uint64_t key,
                                              const std::shared_ptr<const Painting>& painting);

    // Starts a round: paintings that are placed or replaced from now on are in use.
    void begin_asking() { ++asking_; }
    // Removes the paintings that were not used since begin_asking(). A clear pixel is uploaded over each
    // one's corner, so that its painting is not kept in memory for a place that is never drawn.
    void forget_unasked();

    // Returns the uploads to copy into the texture before drawing from it, and clears the list.
    [[nodiscard]] std::vector<Upload> take_uploads();
    // How often a half has been emptied.
    [[nodiscard]] std::uint64_t generation() const { return generation_; }
    [[nodiscard]] int side_px() const { return side_; }

  private:
    struct Shelf {
        int y = 0;
        int height = 0;
        int used = 0;  // pixels from the left
    };
    struct Place {
        Rect rect;
        std::uint64_t asked = 0;  // value of asking_ when it was last used
    };
    struct Half {
        int top = 0;
        int next_shelf_y = 0;
        std::vector<Shelf> shelves;
        std::unordered_map<std::uint64_t, Place> places;
    };
    [[nodiscard]] std::optional<Rect> find(std::uint64_t key);
    [[nodiscard]] std::optional<Rect> room_for(Half& half, int width, int height) const;
    void empty(Half& half);

    int side_;
    std::array<Half, 2> halves_;
    std::size_t current_ = 0;
    std::uint64_t generation_ = 0;
    std::uint64_t asking_ = 0;
    std::vector<Upload> uploads_;
};

}  // namespace onggi::ui
