// Contact of a linear elastic wall: the rows near the tool, what each gives way per newton on each, and the
// forces that keep the tool out.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "model.h"

namespace onggi::peers {

constexpr double kReachMm = 8.0;  // of the tool's centre: rows that a depth of 2 mm may press, with a margin

class RowContact {
  public:
    // compliance_mm_per_n: inward displacement of row i under an inward newton on row j, both within reach.
    RowContact(std::vector<double> heights_mm, Eigen::MatrixXd compliance_mm_per_n)
        : heights_mm_(std::move(heights_mm)),
          compliance_(std::move(compliance_mm_per_n)),
          pressed_(heights_mm_.size(), false) {}

    // Inward forces f >= 0 with C f >= overlap, and f = 0 wherever the wall is clear of the tool (Signorini),
    // by an active set that starts from the last tick's.
    const Eigen::VectorXd& press(double depth_mm) {
        const auto count = static_cast<Eigen::Index>(heights_mm_.size());
        Eigen::VectorXd overlap(count);
        for (Eigen::Index i = 0; i < count; ++i)
            overlap[i] = overlap_mm(heights_mm_[static_cast<std::size_t>(i)], depth_mm);
        force_n_ = Eigen::VectorXd::Zero(count);
        for (int pass = 0; pass < 50; ++pass) {
            std::vector<Eigen::Index> rows;
            for (Eigen::Index i = 0; i < count; ++i)
                if (pressed_[static_cast<std::size_t>(i)]) rows.push_back(i);
            force_n_.setZero();
            if (!rows.empty()) {
                const Eigen::MatrixXd pressed = compliance_(rows, rows);
                const Eigen::VectorXd wanted = overlap(rows);
                force_n_(rows) = Eigen::VectorXd(pressed.llt().solve(wanted));
            }
            const Eigen::VectorXd way = compliance_ * force_n_;
            bool changed = false;
            for (Eigen::Index i = 0; i < count; ++i) {
                const auto at = static_cast<std::size_t>(i);
                const bool press = pressed_[at] ? force_n_[i] > 0.0 : way[i] < overlap[i] - 1e-9;
                changed = changed || press != pressed_[at];
                pressed_[at] = press;
            }
            if (!changed) break;
        }
        return force_n_;
    }

  private:
    std::vector<double> heights_mm_;
    Eigen::MatrixXd compliance_;
    std::vector<bool> pressed_;
    Eigen::VectorXd force_n_;
};

}  // namespace onggi::peers
