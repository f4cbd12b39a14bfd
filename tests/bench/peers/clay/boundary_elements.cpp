// The boundary element method as haptic rendering used it (ArtDefo, James and Pai, 1999): only the surface is
// meshed, the influence of each touched row on the whole surface is computed beforehand, and a tick adds
// those influences up.
//
// Axisymmetric, constant elements, by collocation: c u + H u = G t, with Kelvin's solutions integrated round
// the axis. The diagonal of H follows from two states of known displacement and traction: a translation along
// the axis, and u_r = r.
#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <vector>

#include "contact.h"
#include "model.h"

namespace onggi::peers {
namespace {

using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kShearMpa = kYoungMpa / (2.0 * (1.0 + kPoisson));

// Gauss's points and weights on 0 to 1.
struct Gauss {
    std::vector<double> at, weight;
    explicit Gauss(int count) {
        // Golub and Welsch: from the eigenvalues of the recurrence of Legendre's polynomials.
        MatrixXd recurrence = MatrixXd::Zero(count, count);
        for (int i = 1; i < count; ++i)
            recurrence(i, i - 1) = recurrence(i - 1, i) = i / std::sqrt(4.0 * i * i - 1.0);
        const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(recurrence);
        for (int i = 0; i < count; ++i) {
            at.push_back(0.5 + 0.5 * solver.eigenvalues()[i]);
            weight.push_back(std::pow(solver.eigenvectors()(0, i), 2.0));
        }
    }
};

// A strip of the surface, from and to in (r, y), with its outward normal.
struct Strip {
    Vector2d from, to, normal;
    bool is_fixed;
    [[nodiscard]] Vector2d middle() const { return 0.5 * (from + to); }
    [[nodiscard]] double length_mm() const { return (to - from).norm(); }
};

// Adds Kelvin's displacements and tractions at the ring through `field` for unit loads (radial, axial) at
// `source`, times weight, integrated round the axis: rows are loads, columns the parts (radial, axial) of the
// answer.
void add_ring(const Vector2d& source, const Vector2d& field, const Vector2d& normal, double weight,
              const Gauss& gauss, Matrix2d& displacement, Matrix2d& traction) {
    // sinh spreads the points where the ring passes the source.
    const double near = std::max((field - source).norm() / field.x(), 1e-9);
    const double end = std::asinh(kPi / near);
    const double scale_u = 1.0 / (16.0 * kPi * kShearMpa * (1.0 - kPoisson));
    const double scale_t = -1.0 / (8.0 * kPi * (1.0 - kPoisson));
    for (std::size_t k = 0; k < gauss.at.size(); ++k) {
        const double angle = near * std::sinh(end * gauss.at[k]);
        const double part =
            2.0 * weight * field.x() * gauss.weight[k] * end * near * std::cosh(end * gauss.at[k]);
        const double cosine = std::cos(angle);
        const double sine = std::sin(angle);
        const Vector3d away(field.x() * cosine - source.x(), field.y() - source.y(), field.x() * sine);
        const double distance = away.norm();
        const Vector3d d = away / distance;
        const Vector3d n(normal.x() * cosine, normal.y(), normal.x() * sine);
        const double dn = d.dot(n);
        const std::array<Vector3d, 2> parts{Vector3d(cosine, 0.0, sine), Vector3d::UnitY()};
        for (int load = 0; load < 2; ++load) {
            for (int to = 0; to < 2; ++to) {
                const Vector3d& e = parts[static_cast<std::size_t>(to)];
                const double along = d[load] * d.dot(e);
                displacement(load, to) +=
                    part * scale_u / distance * ((3.0 - 4.0 * kPoisson) * e[load] + along);
                traction(load, to) += part * scale_t / (distance * distance) *
                                      (dn * ((1.0 - 2.0 * kPoisson) * e[load] + 3.0 * along) -
                                       (1.0 - 2.0 * kPoisson) * (d[load] * n.dot(e) - n[load] * d.dot(e)));
            }
        }
    }
}

class BoundaryElements : public Model {
  public:
    explicit BoundaryElements(int rows) : rows_(rows), contact_(solve()) {}
    double tick(double depth_mm) override {
        const VectorXd& inward_n = contact_.press(depth_mm);
        moved_mm_.noalias() = influence_ * inward_n;
        return inward_n.sum();
    }
    double wall_mm(double y_mm) override {
        return kWallMm + moved_mm_[2 * static_cast<Eigen::Index>(y_mm / kHeightMm * rows_)];
    }

  private:
    // Side, bottom and top, finest at the edges.
    [[nodiscard]] std::vector<Strip> surface() const {
        std::vector<Strip> strips;
        const double pitch_mm = kHeightMm / rows_;
        for (int i = 0; i < rows_; ++i)
            strips.push_back({{kWallMm, i * pitch_mm}, {kWallMm, (i + 1) * pitch_mm}, {1.0, 0.0}, false});
        for (const double y_mm : {0.0, kHeightMm}) {
            double outer_mm = kWallMm;
            for (double step_mm = pitch_mm; outer_mm > 0.0; step_mm *= 1.2) {
                const double inner_mm = outer_mm - 1.6 * step_mm > 0.0 ? outer_mm - step_mm : 0.0;
                strips.push_back(
                    {{inner_mm, y_mm}, {outer_mm, y_mm}, {0.0, y_mm > 0.0 ? 1.0 : -1.0}, y_mm == 0.0});
                outer_mm = inner_mm;
            }
        }
        return strips;
    }

    static void integrate(const Vector2d& source, const Strip& strip, bool is_own, Matrix2d& g, Matrix2d& h) {
        static const Gauss few(3);
        static const Gauss many(10);
        static const Gauss round(20);
        const Vector2d way = strip.to - strip.from;
        g.setZero();
        h.setZero();
        if (is_own) {
            // Both halves, with squares of the points, because the kernel grows as the logarithm of the
            // distance.
            for (std::size_t k = 0; k < many.at.size(); ++k)
                for (const double side : {-0.5, 0.5})
                    add_ring(source, source + side * many.at[k] * many.at[k] * way, strip.normal,
                             many.weight[k] * many.at[k] * strip.length_mm(), round, g, h);
            return;
        }
        const bool is_near = (strip.middle() - source).norm() < 3.0 * strip.length_mm();
        const Gauss& gauss = is_near ? many : few;
        for (std::size_t k = 0; k < gauss.at.size(); ++k)
            add_ring(source, strip.from + gauss.at[k] * way, strip.normal,
                     gauss.weight[k] * strip.length_mm(), round, g, h);
    }

    RowContact solve() {
        const std::vector<Strip> strips = surface();
        const auto count = static_cast<Eigen::Index>(strips.size());
        MatrixXd g(2 * count, 2 * count);
        MatrixXd h(2 * count, 2 * count);
        const double lame = 2.0 * kShearMpa * kPoisson / (1.0 - 2.0 * kPoisson);
        for (Eigen::Index i = 0; i < count; ++i) {
            const Vector2d source = strips[static_cast<std::size_t>(i)].middle();
            Vector2d lacks_axial = Vector2d::Zero();
            Vector2d lacks_radial = Vector2d::Zero();
            for (Eigen::Index j = 0; j < count; ++j) {
                const Strip& strip = strips[static_cast<std::size_t>(j)];
                Matrix2d own_g;
                Matrix2d own_h;
                integrate(source, strip, i == j, own_g, own_h);
                g.block<2, 2>(2 * i, 2 * j) = own_g;
                h.block<2, 2>(2 * i, 2 * j) = own_h;
                const Vector2d spread(strip.normal.x() * 2.0 * (lame + kShearMpa),
                                      strip.normal.y() * 2.0 * lame);
                lacks_radial += own_g * spread;
                if (i == j) continue;
                lacks_axial -= own_h.col(1);
                lacks_radial -= own_h.col(0) * strip.middle().x();
            }
            h.block<2, 1>(2 * i, 2 * i) = lacks_radial / source.x();
            h.block<2, 1>(2 * i, 2 * i + 1) = lacks_axial;
        }
        // Unknown: displacements where the surface is free, tractions on the wheel head.
        MatrixXd unknown = h;
        std::vector<double> heights_mm;
        std::vector<Eigen::Index> rows;
        for (Eigen::Index j = 0; j < count; ++j) {
            const Strip& strip = strips[static_cast<std::size_t>(j)];
            if (strip.is_fixed) unknown.middleCols<2>(2 * j) = -g.middleCols<2>(2 * j);
            if (j >= rows_ || std::abs(strip.middle().y() - kToolHeightMm) > kReachMm) continue;
            rows.push_back(2 * j);
            heights_mm.push_back(strip.middle().y());
        }
        const double area_mm2 = 2.0 * kPi * kWallMm * kHeightMm / rows_;
        influence_ = unknown.partialPivLu().solve(MatrixXd(-g(Eigen::all, rows) / area_mm2));
        const MatrixXd compliance = -influence_(rows, Eigen::all);
        return {heights_mm, 0.5 * (compliance + compliance.transpose())};
    }

    int rows_;
    MatrixXd influence_;  // of an inward newton on each row in reach, on all that is unknown
    RowContact contact_;
    VectorXd moved_mm_;
};

}  // namespace

std::unique_ptr<Model> boundary_elements(int rows) {
    return std::make_unique<BoundaryElements>(rows);
}

}  // namespace onggi::peers
