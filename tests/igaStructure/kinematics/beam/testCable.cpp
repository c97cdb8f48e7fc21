// SPDX-License-Identifier: GPL-3.0-or-later
#include "exampleBeam.hpp"

#include <Eigen/Eigenvalues>
#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace tokay;
using namespace tokay::structure;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

BeamSection cableSection() {
    BeamSection section;
    section.thickness = 0.1;
    section.axialStiffness = 1e5;
    section.mass = 2;
    return section;
}

const std::vector<BeamSupport> bothEnds = {{BeamEnd::start, true, true, false, true},
                                           {BeamEnd::end, true, true, false, true}};

// Lowest three of a prestressed string along x, vibrating along a component.
VectorXd frequenciesAlong(const Beam& string, int component) {
    SparseMatrix tangent;
    string.internalForce(VectorXd::Zero(string.nUnknowns()), tangent);
    std::vector<int> across;
    for (int k = component; k < string.nUnknowns(); k += string.dimension()) {
        if (!string.fixed()[k]) {
            across.push_back(k);
        }
    }
    const MatrixXd K = MatrixXd(tangent)(across, across);
    const MatrixXd M = MatrixXd(string.massMatrix())(across, across);
    return Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd>(K, M)
        .eigenvalues()
        .head<3>()
        .cwiseSqrt();
}

// A cable that hangs in a plane: the first column of axes is along its span, the
// second one upwards.
void expectElasticCatenary(const Eigen::Matrix3d& axes, int dimension) {
    // Span 8 between level ends, unstretched length L; horizontal force H follows
    // from span = 2 H/w asinh(w L / 2 H) + H L / EA (Irvine 1981).
    const double w = 2 * 9.81;
    const double EA = 1e5;
    const double H = 60;
    const double root = std::sinh(1.0);
    const double L = 2 * H / w * root; // asinh(w L / 2 H) = 1
    const double span = 2 * H / w + H * L / EA;
    const double V = 0.5 * w * L;
    const double sag = (std::hypot(H, V) - H) / w + 0.5 * V * L / (2 * EA);
    // Starts as a circular arc with a prestress that makes it stiff across its
    // axis, longer than L by the stretch that goes with it.
    const double prestress = 60;
    const double length = L / std::sqrt(1 - 2 * prestress / EA);
    double half = 1; // half opening angle: sin(half)/half = span/L
    for (int k = 0; k < 100; ++k) {
        half -= (std::sin(half) - half * span / length) / (std::cos(half) - span / length);
    }
    const double radius = 0.5 * length / half;
    const geometry::NurbsCurve inPlane =
        geometry::arc({0, 0, 0}, radius, 1.5 * M_PI - half, 1.5 * M_PI + half);
    const geometry::NurbsCurve arc(inPlane.knotVector(), inPlane.controlPoints() * axes.transpose(),
                                   inPlane.weights());
    BeamLoads loads;
    loads.gravities.emplace_back();
    for (int c = 0; c < dimension; ++c) {
        loads.gravities[0].emplace_back(fmt::format("{:.17g}", -9.81 * axes(c, 1)), "");
    }
    BeamSection section = cableSection();
    section.prestress = prestress;
    Beam line(geometry::refine(arc, 3, 16), section, Strains::nonlinear, bothEnds, loads,
              dimension);
    const VectorXd d = loadSteps(line, 10).back();
    const double middle = line.curve().knotVector().last() / 2;
    const VectorXd all = line.controlDisplacements(d);
    const geometry::CurveBasis basis = line.curve().basis(middle, 0);
    Eigen::Vector3d lowest = line.curve().point(middle);
    for (int a = 0; a < basis.N.cols(); ++a) {
        lowest.head(dimension) +=
            basis.N(0, a) * all.segment(dimension * (basis.first + a), dimension);
    }
    const double ends = -radius * std::cos(half);
    // Measures of strain differ by the strain squared, 1e-6; discretisation 1e-5.
    EXPECT_NEAR(ends - axes.col(1).dot(lowest), sag, 1e-4 * sag);
    EXPECT_NEAR(axes.col(2).dot(lowest), 0, 1e-9 * sag);
    EXPECT_NEAR(line.stateAt(middle, d).normalForce, H, 2e-3 * H);
}

} // namespace

TEST(Cable, prestressed_string_has_the_frequencies_of_the_wave_equation) {
    BeamSection section = cableSection();
    section.prestress = 50;
    for (Strains strains : {Strains::linear, Strains::nonlinear}) {
        for (int dimension : {2, 3}) {
            const Beam line(geometry::refine(geometry::line({0, 0, 0}, {3, 0, 0}), 4, 16), section,
                            strains, bothEnds, {}, dimension);
            for (int component = 1; component < dimension; ++component) {
                const VectorXd found = frequenciesAlong(line, component);
                for (int n = 1; n <= 3; ++n) {
                    const double exact = n * M_PI / 3 * std::sqrt(50.0 / 2);
                    EXPECT_NEAR(found[n - 1], exact, 1e-7 * exact); // degree 4, 16 elements
                }
            }
        }
    }
}

TEST(Cable, hanging_cable_takes_the_shape_of_the_elastic_catenary) {
    expectElasticCatenary(Eigen::Matrix3d::Identity(), 2);
}

TEST(Cable, hanging_cable_in_an_oblique_plane_takes_the_shape_of_the_elastic_catenary) {
    Eigen::Matrix3d axes; // z is upwards
    axes << 0.8, 0, 0.6, 0.6, 0, -0.8, 0, 1, 0;
    expectElasticCatenary(axes, 3);
}
