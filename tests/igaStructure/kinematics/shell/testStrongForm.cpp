// SPDX-License-Identifier: GPL-3.0-or-later
#include "exampleShell.hpp"
#include "geometry/quadrature/gaussLegendre.hpp"
#include "igaStructure/kinematics/shell/egm/StrongForm.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

using namespace tokay;
using namespace tokay::structure;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

// A doubly curved element with oblique parameter lines.
geometry::NurbsSurface saddle() {
    geometry::Points points(9, 3);
    for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 3; ++i) {
            const double x = 0.5 * i, y = 0.5 * j;
            points.row(i + 3 * j) << x + 0.2 * y + 0.1 * x * y, 0.8 * y - 0.1 * x * x,
                0.2 * (i == 1) - 0.15 * (j == 1) + 0.1 * x * y;
        }
    }
    const geometry::KnotVector quadratic = geometry::KnotVector::uniform(2, 1);
    return {quadratic, quadratic, points};
}

VectorXd gathered(const std::vector<int>& nodes, const VectorXd& u) {
    VectorXd own(3 * nodes.size());
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        own.segment<3>(3 * static_cast<Eigen::Index>(k)) = u.segment<3>(3 * nodes[k]);
    }
    return own;
}

// Control value (i, j) of one element of degree 10 whose functions vanish at its rim with
// their first derivatives.
int innerNode(int i, int j) {
    return i + 11 * j;
}

// By parts twice the work of stresses of u on such functions v is that of -L u.
void expectWorkOfResidual(const ShellDescription& description) {
    const Shell shell(description);
    SparseMatrix stiffness;
    shell.internalForce(VectorXd::Zero(shell.nUnknowns()), stiffness);
    const VectorXd u = randomMotion(shell.nUnknowns(), 1);
    VectorXd v = VectorXd::Zero(shell.nUnknowns());
    for (int j = 2; j <= 8; ++j) {
        for (int i = 2; i <= 8; ++i) {
            v.segment<3>(3 * innerNode(i, j)) = Vector3d(1 + i - j, 0.5 * j - 2, 3 - 0.3 * i * j);
        }
    }
    const auto& rule = geometry::gaussLegendre(24);
    double work = 0, size = 0;
    for (std::size_t b = 0; b < rule.points.size(); ++b) {
        for (std::size_t a = 0; a < rule.points.size(); ++a) {
            const geometry::Parameters at(rule.points[a], rule.points[b]);
            const StrongForm form(description, 0, *shell.patches()[0], 0, at);
            const Vector3d moved = shell.displacementAt(0, at, 0, v);
            const double own = form.area * rule.weights[a] * rule.weights[b] *
                               moved.dot(form.L * gathered(form.nodes, u));
            work -= own;
            size += std::abs(own);
        }
    }
    // The stiffness matrix is integrated by 11 points a direction, metrics being no
    // polynomials: their error is what is allowed.
    EXPECT_NEAR(work, v.dot(stiffness * u), 1e-6 * size);
    EXPECT_GT(std::abs(work), 1e-3 * size); // not zero by chance
}

ShellDescription oneElement(bool bending) {
    ShellDescription shell = onePatch(saddle(), 10, 1, 1, bending ? 0.3 : 0.1, {1e3, 0.3, 1});
    shell.strains = Strains::linear;
    shell.bending = bending;
    return shell;
}

} // namespace

TEST(StrongForm, works_on_interior_motions_as_the_stiffness_of_a_curved_shell_does) {
    expectWorkOfResidual(oneElement(true));
}

TEST(StrongForm, works_on_interior_motions_as_the_stiffness_of_a_prestressed_membrane_does) {
    ShellDescription membrane = oneElement(false);
    membrane.prestress = {200, 50, 30};
    expectWorkOfResidual(membrane);
}

TEST(StrongForm, fourth_derivatives_of_degree_3_are_in_the_knots) {
    // Control values f - h^2 f''/6 at Greville points make cubics exact, so of x^4 between
    // uniform knots, as the shift by a knot changes it by a cubic, the third derivative jumps
    // by 24 h at each.
    constexpr int n = 12;
    ShellDescription plate =
        onePatch(geometry::rectangle({0, 0, 0}, 3, 3), 3, n, n, 0.1, {1e3, 0.3, 1});
    plate.strains = Strains::linear;
    const Shell shell(plate);
    const double h = 3.0 / n, third = h * h / 6;
    const VectorXd w = motion(shell, [&](const Vector3d& x) -> Vector3d {
        const double x2 = x[0] * x[0], y2 = x[1] * x[1];
        const double xx = x2 - 2 * third, yy = y2 - 2 * third; // of x^2 and y^2
        const double x4 = x2 * x2 - 12 * third * x2, y4 = y2 * y2 - 12 * third * y2;
        return x + Vector3d(0, 0, x4 + xx * yy + 2 * y4);
    });
    const double D = 1e3 / (1 - 0.09) * 1e-3 / 12;
    for (const geometry::Parameters& at :
         {geometry::Parameters(0.46, 0.47), geometry::Parameters(0.52, 0.58)}) {
        const ShellPatch& patch = *shell.patches()[0];
        const StrongForm form(plate, 0, patch, patch.patch().elementAt(at), at);
        const Vector3d residual = form.L * gathered(form.nodes, w);
        // 24 + 2 (2 2) + 2 24, less what rounding leaves of fourth differences.
        EXPECT_NEAR(residual[2], -D * 80, 1e-9 * D * 80);
    }
}

TEST(StrongForm, no_stress_comes_of_rigid_motion) {
    const ShellDescription description = oneElement(true);
    const Shell shell(description);
    const VectorXd turned = motion(shell, [](const Vector3d& x) -> Vector3d {
        return x + Vector3d(0.3, -0.2, 0.5).cross(x) + Vector3d(1, 2, 3);
    });
    const StrongForm form(description, 0, *shell.patches()[0], 0, {0.3, 0.7});
    // Rounding of fourth derivatives of degree 10.
    EXPECT_LT((form.L * gathered(form.nodes, turned)).norm(),
              1e-11 * form.L.norm() * turned.norm());
}
