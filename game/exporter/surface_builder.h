// Rows of corners become one closed surface: vertices, normals, triangles, and where they lie in the pictures
// that a pot wears. Inside game/exporter only. Any thread but the haptic one. mm, wet size.
#pragma once

#include <cstdint>
#include <vector>

#include "game/exporter/pot_faces.h"
#include "game/exporter/pot_solid.h"

namespace onggi::exporter {

// A surface walked row by row such that its outside lies to the right of the walk in the plane of radius and
// height: up the outside, in over the rim, down the inside. Both ends are closed by discs, the first facing
// down and the last facing up; or the last row meets the first.
struct Walk {
    std::vector<FaceRow> rows;
    bool meets_itself = false;
};

class SurfaceBuilder {
  public:
    SurfaceBuilder(int corners, bool unwraps);

    void add_walk(const Walk& walk);
    [[nodiscard]] double volume_mm3() const;
    // Unit length, none of them against a face that it belongs to. After the last walk; once.
    void finish_normals();
    // Places in the pictures and tangents into the solid's mesh, and the rows of the pictures. After that.
    void unwrap(double shrinkage, PotSolid& pot) const;

    std::vector<dvec3> positions_mm;
    std::vector<dvec3> normals;  // summed over faces, until they are finished
    std::vector<std::uint32_t> indices;

  private:
    // Vertices of one row, or of the middle of a disc.
    struct Strip {
        std::uint32_t first = 0;
        double along_mm = 0.0;  // of the walk so far
        double radius_mm = 0.0;
        double y_mm = 0.0;
        bool inside = false;
        bool is_middle = false;
    };

    std::uint32_t add_row(const FaceRow& row);
    void add_band(std::uint32_t from, std::uint32_t to);
    void add_disc(const FaceRow& rim, bool faces_up);
    void add_middle(const FaceRow& rim, bool faces_up);
    void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
    void mend_normals();
    [[nodiscard]] std::uint32_t next_of(std::uint32_t corner) const;
    [[nodiscard]] std::uint32_t in_row() const;

    std::vector<dvec2> circle_;
    bool unwraps_;
    double along_mm_ = 0.0;
    std::vector<Strip> strips_;
};

}  // namespace onggi::exporter
