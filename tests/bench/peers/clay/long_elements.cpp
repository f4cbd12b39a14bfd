// The long element method (Costa and Balaniuk, 2001): the body is a fluid in long elastic elements, here from
// the axis to the wall, one for each row and sector. With U_i the way that element i gives inward, per area:
//     E U_i/R + T sum over neighbours (U_i - U_j)/d_ij^2 - dp = p_i        elasticity, surface tension,
//     pressure (Pascal) sum A_i U_i = 0                                                      the fluid keeps
//     its volume
// The volume is kept by a stiff pressure, dp = -k sum A_i U_i / V, so that the matrix is positive. Pressed
// elements lie on the tool; the others follow by conjugate gradients from the last tick's shape. E is the
// solid's; T is a free number of the method, chosen so that a dent dies away over 5 mm.
#include <cstddef>
#include <vector>

#include "model.h"

namespace onggi::peers {
namespace {

constexpr double kDentMm = 5.0;
constexpr double kTension = kYoungMpa / kWallMm * kDentMm * kDentMm;  // MPa mm
constexpr double kBulkMpa = 100.0 * kYoungMpa;
constexpr double kSlowestStep = 1e-5;  // of the first residual

class LongElements : public Model {
  public:
    explicit LongElements(int rows)
        : rows_(rows),
          pitch_mm_(kHeightMm / rows),
          area_mm2_(2.0 * kPi * kWallMm / kSectors * pitch_mm_),
          way_mm_(static_cast<std::size_t>(rows) * kSectors, 0.0),
          pressed_(way_mm_.size(), 0),
          rest_(way_mm_.size()),
          along_(way_mm_.size()),
          image_(way_mm_.size()) {}

    double tick(double depth_mm) override {
        for (int row = 0; row < rows_; ++row) {
            const double overlap = overlap_mm((row + 0.5) * pitch_mm_, depth_mm);
            for (int sector = 0; sector < kSectors; ++sector) {
                const std::size_t at = index(row, sector);
                pressed_[at] = overlap > 0.0 && way_mm_[at] <= overlap + kTouchMm ? 1 : 0;
                if (pressed_[at] != 0) way_mm_[at] = overlap;
            }
        }
        relax();
        double force_n = 0.0;
        apply(way_mm_, image_);
        for (std::size_t at = 0; at < way_mm_.size(); ++at)
            if (pressed_[at] != 0) force_n += image_[at] * area_mm2_;
        return force_n;
    }
    double wall_mm(double y_mm) override {
        return kWallMm - way_mm_[index(static_cast<int>(y_mm / pitch_mm_), 0)];
    }

  private:
    static constexpr double kTouchMm = 1e-3;

    [[nodiscard]] std::size_t index(int row, int sector) const {
        return static_cast<std::size_t>(row) * kSectors + static_cast<std::size_t>(sector);
    }

    // pressures = A way, of all elements.
    void apply(const std::vector<double>& way, std::vector<double>& pressures) const {
        const double round_mm = 2.0 * kPi * kWallMm / kSectors;
        const double up = kTension / (pitch_mm_ * pitch_mm_);
        const double round = kTension / (round_mm * round_mm);
        double volume = 0.0;
        for (const double inward : way)
            volume += inward;
        const double pressure = kBulkMpa * volume * area_mm2_ / (kPi * kWallMm * kWallMm * kHeightMm);
        for (int row = 0; row < rows_; ++row)
            for (int sector = 0; sector < kSectors; ++sector) {
                const double own = way[index(row, sector)];
                double sum = kYoungMpa / kWallMm * own + pressure;
                sum += round * (2.0 * own - way[index(row, (sector + 1) % kSectors)] -
                                way[index(row, (sector + kSectors - 1) % kSectors)]);
                // The lowest stands on the wheel head; the highest ends free.
                sum += up * (own - (row > 0 ? way[index(row - 1, sector)] : 0.0));
                if (row + 1 < rows_) sum += up * (own - way[index(row + 1, sector)]);
                pressures[index(row, sector)] = sum;
            }
    }

    double free_square(const std::vector<double>& a, const std::vector<double>& b) const {
        double sum = 0.0;
        for (std::size_t at = 0; at < a.size(); ++at)
            if (pressed_[at] == 0) sum += a[at] * b[at];
        return sum;
    }

    // Conjugate gradients on the elements that nothing presses.
    void relax() {
        apply(way_mm_, image_);
        for (std::size_t at = 0; at < rest_.size(); ++at) {
            rest_[at] = pressed_[at] != 0 ? 0.0 : -image_[at];
            along_[at] = rest_[at];
        }
        double square = free_square(rest_, rest_);
        if (first_square_ == 0.0) first_square_ = square;
        while (square > kSlowestStep * kSlowestStep * first_square_) {
            apply(along_, image_);
            const double step = square / free_square(along_, image_);
            for (std::size_t at = 0; at < rest_.size(); ++at) {
                if (pressed_[at] != 0) continue;
                way_mm_[at] += step * along_[at];
                rest_[at] -= step * image_[at];
            }
            const double next = free_square(rest_, rest_);
            for (std::size_t at = 0; at < rest_.size(); ++at)
                along_[at] = pressed_[at] != 0 ? 0.0 : rest_[at] + next / square * along_[at];
            square = next;
        }
    }

    int rows_;
    double pitch_mm_;
    double area_mm2_;
    std::vector<double> way_mm_;
    std::vector<char> pressed_;
    std::vector<double> rest_, along_, image_;
    double first_square_ = 0.0;
};

}  // namespace

std::unique_ptr<Model> long_elements(int rows) {
    return std::make_unique<LongElements>(rows);
}

}  // namespace onggi::peers
