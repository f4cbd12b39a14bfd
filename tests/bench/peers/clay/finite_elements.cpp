// Linear and corotational finite elements, axisymmetric: rectangles in the half plane (r, y), assembled by
// GetFEM, factorised by Eigen's sparse LDL^T. The lowest row stands fixed on the wheel head.
//
// Linear: the stiffness is factorised once (Bro-Nielsen and Cotin, 1996); a tick finds the contact forces by
// the compliance of the touched rows and substitutes them back for the whole body. Corotational: the strain
// is taken in a frame that turns with each element (Mueller and Gross, 2004), so a tick assembles and
// factorises anew: one Newton step, contact by a penalty.
#include <getfem/getfem_generic_assembly.h>
#include <getfem/getfem_mesh_fem.h>
#include <getfem/getfem_mesh_im.h>

#include <Eigen/Sparse>
#include <algorithm>
#include <string>

#include "contact.h"
#include "model.h"

namespace onggi::peers {
namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Vector = getfem::model_real_plain_vector;

constexpr double kFixed = 1e6;  // N/mm, on displacements that must be 0

// Cuts from 0 to end_mm, finest at the end, each longer than the next by a fifth.
std::vector<double> graded_cuts(double end_mm, double finest_mm) {
    std::vector<double> cuts{end_mm};
    for (double step_mm = finest_mm; cuts.back() - step_mm > 0.6 * step_mm; step_mm *= 1.2)
        cuts.push_back(cuts.back() - step_mm);
    cuts.push_back(0.0);
    return {cuts.rbegin(), cuts.rend()};
}

std::vector<double> even_cuts(int rows) {
    std::vector<double> cuts;
    for (int i = 0; i <= rows; ++i)
        cuts.push_back(kHeightMm * i / rows);
    return cuts;
}

class Solid {
  public:
    Solid(const std::vector<double>& cuts_r, const std::vector<double>& cuts_y, int degree)
        : field_(mesh_, 2),
          rotations_(mesh_),
          integration_(mesh_) {
        const auto shape = bgeot::parallelepiped_geotrans(2, 1);
        for (std::size_t i = 0; i + 1 < cuts_r.size(); ++i)
            for (std::size_t j = 0; j + 1 < cuts_y.size(); ++j) {
                std::vector<bgeot::base_node> corners;
                for (const std::size_t y : {j, j + 1})
                    for (const std::size_t r : {i, i + 1})
                        corners.emplace_back(cuts_r[r], cuts_y[y]);
                mesh_.add_convex_by_points(shape, corners.begin());
            }
        field_.set_finite_element(getfem::classical_fem(shape, static_cast<bgeot::short_type>(degree)));
        rotations_.set_qdim(2, 2);
        rotations_.set_finite_element(getfem::classical_fem(shape, 0));
        integration_.set_integration_method(getfem::int_method_descriptor("IM_GAUSS_PARALLELEPIPED(2,4)"));
        for (std::size_t dof = 0; dof < field_.nb_basic_dof(); ++dof) {
            const auto at = field_.point_of_basic_dof(dof);
            if (at[1] < 1e-9 || (at[0] < 1e-9 && dof % 2 == 0)) fixed_.push_back(dof);
            if (at[0] > kWallMm - 1e-9 && dof % 2 == 0) wall_.push_back(dof);
        }
        std::sort(wall_.begin(), wall_.end(),
                  [&](std::size_t a, std::size_t b) { return y_mm(a) < y_mm(b); });
    }

    [[nodiscard]] std::size_t size() const { return field_.nb_basic_dof(); }
    [[nodiscard]] double y_mm(std::size_t dof) const { return field_.point_of_basic_dof(dof)[1]; }
    // The radial displacements of the wall, from the lowest.
    [[nodiscard]] const std::vector<std::size_t>& wall() const { return wall_; }

    // The stiffness for elements turned by their rotations, and the forces that those alone ask for.
    void assemble(const Vector& rotations, Sparse& stiffness, Vector& load) {
        const double shear = kYoungMpa / (2.0 * (1.0 + kPoisson));
        const Vector mu{shear};
        const Vector lambda{2.0 * shear * kPoisson / (1.0 - 2.0 * kPoisson)};
        const Vector nothing(size());
        getfem::ga_workspace workspace;
        workspace.add_fem_variable("u", field_, gmm::sub_interval(0, size()), nothing);
        workspace.add_fem_constant("R", rotations_, rotations);
        workspace.add_fixed_size_constant("mu", mu);
        workspace.add_fixed_size_constant("la", lambda);
        // Volume 2 pi r dr dy; the hoop strain is u_r/r.
        const std::string hoop = "(u(1)/X(1))";
        const std::string test_hoop = "(Test_u(1)/X(1))";
        const std::string strain = "(Sym(R'*(Id(2)+Grad_u))-Id(2))";
        const std::string test_strain = "Sym(R'*Grad_Test_u)";
        workspace.add_expression("2*pi*X(1)*(2*mu*(" + strain + ":" + test_strain + "+" + hoop + "*" +
                                     test_hoop + ")+la*(Trace" + strain + "+" + hoop + ")*(Trace(" +
                                     test_strain + ")+" + test_hoop + "))",
                                 integration_);
        workspace.assembly(2);
        workspace.assembly(1);
        load = workspace.assembled_vector();
        gmm::scale(load, -1.0);
        std::vector<Eigen::Triplet<double>> entries;
        const auto& assembled = workspace.assembled_matrix();
        for (std::size_t column = 0; column < size(); ++column) {
            const auto& values = gmm::mat_const_col(assembled, column);
            for (auto it = gmm::vect_const_begin(values); it != gmm::vect_const_end(values); ++it)
                entries.emplace_back(it.index(), column, *it);
        }
        for (const std::size_t dof : fixed_)
            entries.emplace_back(dof, dof, kFixed);
        stiffness.resize(static_cast<Eigen::Index>(size()), static_cast<Eigen::Index>(size()));
        stiffness.setFromTriplets(entries.begin(), entries.end());
    }

    // The rotation of each element: the nearest to its mean deformation gradient. Elements of degree one.
    void find_rotations(const Eigen::VectorXd& moved_mm, Vector& rotations) const {
        for (dal::bv_visitor element(mesh_.convex_index()); !element.finished(); ++element) {
            const auto dofs = field_.ind_basic_dof_of_element(element);
            const auto corner = [&](int node, int axis) {
                return moved_mm[static_cast<Eigen::Index>(dofs[2 * node + axis])];
            };
            const auto& points = mesh_.points_of_convex(element);
            const double width = points[1][0] - points[0][0];
            const double height = points[2][1] - points[0][1];
            const auto across = [&](int axis) {
                return (corner(1, axis) + corner(3, axis) - corner(0, axis) - corner(2, axis)) /
                       (2.0 * width);
            };
            const auto along = [&](int axis) {
                return (corner(2, axis) + corner(3, axis) - corner(0, axis) - corner(1, axis)) /
                       (2.0 * height);
            };
            const double cosine = 2.0 + across(0) + along(1);
            const double sine = across(1) - along(0);
            const double length = std::hypot(cosine, sine);
            const auto first = rotations_.ind_basic_dof_of_element(element)[0];
            rotations[first] = rotations[first + 3] = cosine / length;
            rotations[first + 1] = sine / length;  // column by column
            rotations[first + 2] = -sine / length;
        }
    }
    [[nodiscard]] Vector no_rotations() const {
        Vector rotations(rotations_.nb_basic_dof());
        for (std::size_t i = 0; i < rotations.size(); i += 4)
            rotations[i] = rotations[i + 3] = 1.0;
        return rotations;
    }

  private:
    getfem::mesh mesh_;
    getfem::mesh_fem field_;
    getfem::mesh_fem rotations_;
    getfem::mesh_im integration_;
    std::vector<std::size_t> fixed_;
    std::vector<std::size_t> wall_;
};

// The wall of a solid that was moved.
class Body : public Model {
  public:
    Body(const std::vector<double>& cuts_r, const std::vector<double>& cuts_y, int degree)
        : solid_(cuts_r, cuts_y, degree),
          moved_mm_(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(solid_.size()))) {}
    double wall_mm(double y_mm) override {
        std::vector<double> heights_mm;
        std::vector<double> outward_mm;
        for (const std::size_t dof : solid_.wall()) {
            heights_mm.push_back(solid_.y_mm(dof));
            outward_mm.push_back(moved_mm_[static_cast<Eigen::Index>(dof)]);
        }
        return kWallMm + interpolated(heights_mm, outward_mm, y_mm);
    }

  protected:
    Solid solid_;
    Eigen::SimplicialLDLT<Sparse> factor_;
    Eigen::VectorXd moved_mm_;
};

class Linear : public Body {
  public:
    Linear(const std::vector<double>& cuts_r, const std::vector<double>& cuts_y, int degree)
        : Body(cuts_r, cuts_y, degree),
          contact_(compliance()) {}
    double tick(double depth_mm) override {
        const Eigen::VectorXd& inward_n = contact_.press(depth_mm);
        load_n_.setZero(moved_mm_.size());
        for (std::size_t i = 0; i < rows_.size(); ++i)
            load_n_[rows_[i]] = -inward_n[static_cast<Eigen::Index>(i)];
        moved_mm_ = factor_.solve(load_n_);
        return inward_n.sum();
    }

  private:
    RowContact compliance() {
        Sparse stiffness;
        Vector load;
        solid_.assemble(solid_.no_rotations(), stiffness, load);
        factor_.compute(stiffness);
        std::vector<double> heights_mm;
        for (const std::size_t dof : solid_.wall()) {
            if (std::abs(solid_.y_mm(dof) - kToolHeightMm) > kReachMm) continue;
            rows_.push_back(static_cast<Eigen::Index>(dof));
            heights_mm.push_back(solid_.y_mm(dof));
        }
        const auto count = static_cast<Eigen::Index>(rows_.size());
        Eigen::MatrixXd compliance(count, count);
        for (Eigen::Index i = 0; i < count; ++i)
            compliance.col(i) = factor_.solve(
                Eigen::VectorXd::Unit(moved_mm_.size(), rows_[static_cast<std::size_t>(i)]))(rows_);
        return {heights_mm, compliance};
    }

    std::vector<Eigen::Index> rows_;
    RowContact contact_;
    Eigen::VectorXd load_n_;
};

class Corotational : public Body {
  public:
    explicit Corotational(int rows)
        : Body(graded_cuts(kWallMm, kHeightMm / rows), even_cuts(rows), 1),
          rotations_(solid_.no_rotations()),
          penalty_n_per_mm_(500.0 * kYoungMpa * 2.0 * kPi * kWallMm * kHeightMm / rows) {}
    double tick(double depth_mm) override {
        solid_.find_rotations(moved_mm_, rotations_);
        solid_.assemble(rotations_, stiffness_, load_);
        for (const std::size_t dof : solid_.wall()) {
            const auto row = static_cast<Eigen::Index>(dof);
            const double overlap = overlap_mm(solid_.y_mm(dof), depth_mm);
            if (overlap + moved_mm_[row] <= 0.0) continue;
            stiffness_.coeffRef(row, row) += penalty_n_per_mm_;
            load_[dof] -= penalty_n_per_mm_ * overlap;
        }
        if (stiffness_.nonZeros() != analysed_) factor_.analyzePattern(stiffness_);
        analysed_ = stiffness_.nonZeros();
        factor_.factorize(stiffness_);
        moved_mm_ = factor_.solve(Eigen::Map<Eigen::VectorXd>(load_.data(), moved_mm_.size()));
        double force_n = 0.0;
        for (const std::size_t dof : solid_.wall())
            force_n += penalty_n_per_mm_ * std::max(0.0, overlap_mm(solid_.y_mm(dof), depth_mm) +
                                                             moved_mm_[static_cast<Eigen::Index>(dof)]);
        return force_n;
    }

  private:
    Vector rotations_;
    Vector load_;
    Sparse stiffness_;
    Eigen::Index analysed_ = 0;
    double penalty_n_per_mm_;
};

}  // namespace

std::unique_ptr<Model> linear_finite_elements(int rows) {
    return std::make_unique<Linear>(graded_cuts(kWallMm, kHeightMm / rows), even_cuts(rows), 1);
}

std::unique_ptr<Model> corotational_finite_elements(int rows) {
    return std::make_unique<Corotational>(rows);
}

std::unique_ptr<Model> fine_finite_elements() {
    constexpr double kFinestMm = 0.1;  // a square of degree two has a node in its middle
    std::vector<double> cuts_y;
    const double even_from_mm = kToolHeightMm - kReachMm;
    for (const double below : graded_cuts(even_from_mm, kFinestMm))
        cuts_y.push_back(below);
    while (cuts_y.back() < kToolHeightMm + kReachMm - 1e-9)
        cuts_y.push_back(cuts_y.back() + kFinestMm);
    const auto above = graded_cuts(kHeightMm - cuts_y.back(), kFinestMm);
    for (std::size_t i = above.size() - 1; i-- > 0;)
        cuts_y.push_back(kHeightMm - above[i]);
    return std::make_unique<Linear>(graded_cuts(kWallMm, kFinestMm), cuts_y, 2);
}

}  // namespace onggi::peers
