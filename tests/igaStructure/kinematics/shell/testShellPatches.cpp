// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/errors.hpp"
#include "exampleShell.hpp"
#include "geometry/projection/SurfaceProjector.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

using namespace tokay;
using namespace tokay::structure;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using geometry::TrimmedPatch;
using geometry::TrimmingLoop;

namespace {

constexpr double same = 5e-3; // relative; a cut or split roof against the whole one
constexpr double roofTip = 0.3006;

// The roof of Scordelis and Lo cut out of a larger one, if there are margins.
geometry::NurbsSurface roofSurface(double angleMargin, double lengthMargin, double from = 0,
                                   double to = 1) {
    const double first = (50 + 80 * from) * M_PI / 180 - angleMargin;
    const double last = (50 + 80 * to) * M_PI / 180 + angleMargin;
    return geometry::cylinderPatch({0, 0, -lengthMargin}, 25, 50 + 2 * lengthMargin, first, last);
}

// Beam in parameter space through places of the cylinder, straight in the angle.
geometry::NurbsCurve parameterLine(const geometry::NurbsSurface& surface, const Vector3d& start,
                                   const Vector3d& end) {
    const geometry::SurfaceProjector projector(surface);
    const geometry::SurfaceProjection a = projector.closest(start), b = projector.closest(end);
    return geometry::line({a.xi, a.eta, 0}, {b.xi, b.eta, 0});
}

Vector3d onRoof(double degrees, double z) {
    const double angle = degrees * M_PI / 180;
    return {25 * std::cos(angle), 25 * std::sin(angle), z};
}

void addRoofLoads(ShellDescription& roof) {
    roof.strains = Strains::linear;
    for (int face = 0; face < static_cast<int>(roof.thickness.size()); ++face) {
        roof.loads.tractions.push_back({face, VectorField::constant({0, -90, 0})});
    }
}

double tip(const Shell& shell, int face, const VectorXd& d) {
    const geometry::SurfaceProjector projector(shell.patches()[face]->surface());
    const geometry::SurfaceProjection place = projector.closest(onRoof(50, 25));
    return -shell.stateAt(face, place.xi, place.eta, d).displacement[1];
}

const ShellMaterial concrete{4.32e8, 0, 1};

// Two plates side by side, joined along a straight edge askew in space, with
// bases that do not match; the second one may be kinked by an angle. Joined by springs;
// the other methods are tested in testShellEdges.
ShellDescription twoPlates(double kink, Strains strains) {
    const Vector3d along(0.3, 1, 0.2);
    const Vector3d across(1, -0.1, 0);
    const Eigen::AngleAxisd turn(kink, along.normalized());
    const TrimmedPatch first(geometry::plate({0, 0, 0}, across, along), "first");
    const TrimmedPatch second(geometry::plate(across, turn * across, along), "second");
    ShellDescription description{
        geometry::BrepModel({{first.refined(3, 3, 2, 3)}, {second.refined(2, 2, 2, 4)}},
                            {{"joint", {{0, right}, {1, left}}}}),
        {0.05, 0.05},
        {1e6, 0.3, 1000}};
    description.strains = strains;
    description.edgeMethod = EdgeMethod::penalty;
    return description;
}

} // namespace

TEST(ShellPatches, roof_cut_out_of_a_larger_patch_is_the_whole_roof) {
    const geometry::NurbsSurface surface = roofSurface(0.21, 7);
    std::vector<geometry::NurbsCurve> rim;
    const Vector3d corners[4] = {onRoof(50, 0), onRoof(130, 0), onRoof(130, 50), onRoof(50, 50)};
    for (int k = 0; k < 4; ++k) {
        rim.push_back(parameterLine(surface, corners[k], corners[(k + 1) % 4]));
    }
    const TrimmedPatch patch(surface, {TrimmingLoop(geometry::LoopKind::outer, rim)}, "roof");
    ShellDescription roof{geometry::BrepModel({{patch.refined(3, 3, 11, 11)}}), {0.25}, concrete};
    roof.edgeSupports = {support(bottom, {true, true, false}), support(top, {true, true, false})};
    const geometry::Points start = rim[0].derivatives(0, 0);
    roof.pointSupports = {{0, {start(0, 0), start(0, 1)}, {false, false, true}}};
    addRoofLoads(roof);
    Shell shell(std::move(roof));
    EXPECT_NEAR(tip(shell, 0, solveStatic(shell)), roofTip, same * roofTip);
}

TEST(ShellPatches, roof_of_three_patches_that_do_not_match_is_the_whole_roof) {
    const double limits[4] = {0, 0.3, 0.65, 1};
    const int degrees[3] = {3, 2, 4};
    const int elements[3][2] = {{4, 9}, {12, 20}, {4, 8}};
    std::vector<geometry::BrepFace> faces;
    for (int k = 0; k < 3; ++k) {
        const TrimmedPatch patch(roofSurface(0, 0, limits[k], limits[k + 1]),
                                 "part" + std::to_string(k));
        faces.push_back({patch.refined(degrees[k], degrees[k], elements[k][0], elements[k][1])});
    }
    ShellDescription roof{geometry::BrepModel(faces, geometry::coincidentEdges(faces, 1e-6)),
                          {0.25, 0.25, 0.25},
                          concrete};
    for (int face = 0; face < 3; ++face) {
        roof.edgeSupports.push_back({{{face, bottom}, {face, top}}, {true, true, false}});
    }
    roof.pointSupports = {{0, {0, 0}, {false, false, true}}};
    addRoofLoads(roof);
    Shell shell(std::move(roof));
    EXPECT_EQ(shell.constraints().nJoints, 2);
    EXPECT_NEAR(tip(shell, 0, solveStatic(shell)), roofTip, same * roofTip);
}

TEST(ShellPatches, stretched_plate_with_a_hole_has_no_force_inside) {
    // Patch test of a trimmed patch: under a uniform strain the internal forces are
    // those of the tractions on the rim, so they balance and turn nothing; and
    // functions that are zero on all rims have none.
    const geometry::NurbsSurface surface = geometry::rectangle({0, 0, 0}, 2, 1);
    geometry::NurbsCurve circle = geometry::arc({0.45, 0.5, 0}, 0.19, 0, 2 * M_PI);
    geometry::Points reversed = circle.controlPoints().colwise().reverse();
    const Eigen::VectorXd weights = circle.weights().reverse();
    const TrimmingLoop hole(geometry::LoopKind::inner,
                            {geometry::NurbsCurve(circle.knotVector(), reversed, weights)});
    const TrimmedPatch patch(surface, {hole}, "plate");
    ShellDescription description{
        geometry::BrepModel({{patch.refined(2, 2, 12, 12)}}), {0.1}, {1e6, 0.3, 1}};
    description.strains = Strains::nonlinear;
    const Shell shell(std::move(description));
    const VectorXd d = motion(shell, [](const Vector3d& X) -> Vector3d {
        return {1.1 * X[0] + 0.2 * X[1], 0.9 * X[1], 0.3 * X[0] + X[2]};
    });
    const VectorXd force = shell.internalForce(d).force;
    const double scale = force.lpNorm<Eigen::Infinity>();
    const ShellState state = shell.stateAt(0, 0.9, 0.9, d);
    for (const auto& [xi, eta] : {std::pair{0.05, 0.5}, {0.6, 0.13}, {1.0, 1.0}}) {
        EXPECT_LT((shell.stateAt(0, xi, eta, d).force - state.force).norm(),
                  1e-12 * state.force.norm());
    }
    // Every function around this node lives away from the hole and the rim.
    const int nU = shell.patches()[0]->surface().u().nBasis();
    int nInside = 0;
    for (int j = 2; j + 2 < nU; ++j) {
        for (int i = 10; i + 2 < nU; ++i, ++nInside) {
            EXPECT_LT(force.segment<3>(3 * (i + nU * j)).norm(), 1e-12 * scale) << i << " " << j;
        }
    }
    EXPECT_GT(nInside, 10);
    Vector3d sum = Vector3d::Zero();
    for (int node = 0; node < shell.nodes().count(); ++node) {
        sum += force.segment<3>(3 * node);
    }
    EXPECT_LT(sum.norm(), 1e-11 * scale);
}

TEST(ShellPatches, joined_plates_move_rigidly_without_force) {
    for (double kink : {0.0, 0.7}) {
        const Shell shell(twoPlates(kink, Strains::nonlinear));
        const Eigen::AngleAxisd rotation(4.0, Vector3d(1, -2, 0.5).normalized());
        const VectorXd d = motion(
            shell, [&](const Vector3d& X) -> Vector3d { return rotation * X + Vector3d(1, 2, 3); });
        SparseMatrix tangent;
        const VectorXd force = shell.internalForce(d, tangent).force;
        EXPECT_LT(force.lpNorm<Eigen::Infinity>(), 1e-13 * VectorXd(tangent.diagonal()).maxCoeff());
    }
}

TEST(ShellPatches, tangent_of_joined_plates_equals_finite_differences) {
    for (double kink : {0.0, 0.7}) {
        ShellDescription description = twoPlates(kink, Strains::nonlinear);
        description.edgeSupports = {{{{0, left}}, {true, true, true}, true, true}};
        const Shell shell(std::move(description));
        const VectorXd d = randomMotion(shell.nUnknowns(), 0.02);
        SparseMatrix tangent;
        shell.internalForce(d, tangent);
        MatrixXd differences(d.size(), d.size());
        const double h = 1e-6; // truncation and rounding both below 1e-8
        for (Eigen::Index k = 0; k < d.size(); ++k) {
            const VectorXd shift = h * VectorXd::Unit(d.size(), k);
            differences.col(k) =
                (shell.internalForce(d + shift).force - shell.internalForce(d - shift).force) /
                (2 * h);
        }
        EXPECT_LT((MatrixXd(tangent) - differences).norm(), 1e-7 * differences.norm());
    }
}

TEST(ShellPatches, joined_plates_pass_the_patch_test) {
    // A uniform strain of both plates is continuous, so the joint does nothing.
    const Shell shell(twoPlates(0, Strains::linear));
    ShellDescription apart = twoPlates(0, Strains::linear);
    apart.model = geometry::BrepModel(apart.model.faces());
    const Shell separate(std::move(apart));
    const VectorXd d = motion(shell, [](const Vector3d& X) -> Vector3d {
        return {X[0] + 1e-3 * X[0] + 2e-3 * X[1], X[1] - 1e-3 * X[1], X[2]};
    });
    const VectorXd force = shell.internalForce(d).force;
    // The stiffness of the springs times the rounding of the projection on the edge.
    EXPECT_LT((force - separate.internalForce(d).force).norm(), 1e-9 * force.norm());
}

TEST(ShellPatches, weak_supports_hold_as_exact_ones_do) {
    double tips[2];
    for (const bool weak : {false, true}) {
        ShellDescription plate =
            onePatch(geometry::rectangle({0, 0, 0}, 4, 1), 3, 8, 2, 0.05, {1e6, 0.3, 1});
        plate.strains = Strains::linear;
        plate.edgeSupports = {{{{0, left}}, {true, true, true}, true, weak}};
        plate.edgeMethod = EdgeMethod::penalty;
        plate.loads.edgeForces = {{{0, right}, VectorField::constant({0, 0, -1})}};
        Shell shell(std::move(plate));
        tips[weak] = shell.stateAt(0, 1, 0.5, solveStatic(shell)).displacement[2];
    }
    EXPECT_NEAR(tips[1], tips[0], 1e-3 * std::abs(tips[0])); // what the springs give way
}

TEST(ShellPatches, patches_that_are_apart_are_told) {
    ShellDescription description = twoPlates(0, Strains::linear);
    const TrimmedPatch far(geometry::plate({1.5, 0, 0}, {1, 0, 0}, {0, 1, 0}), "far");
    description.model = geometry::BrepModel(
        {description.model.faces()[0], {far.refined(2, 2, 1, 1)}}, description.model.edges());
    try {
        const Shell shell(std::move(description));
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("\"first\" and \"far\""), std::string::npos)
            << error.what();
    }
}

TEST(ShellPatches, slivers_at_a_free_edge_change_nothing) {
    // A cantilever whose free edge cuts off all but a fraction of the last elements.
    for (const int degree : {2, 3, 4}) {
        double whole = 0;
        for (const double fraction : {1.0, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10}) {
            const int nKept = 8;
            const double last = (nKept + fraction) / 10;
            geometry::ParameterBox box{{0, 0}, {last, 1}};
            const TrimmedPatch patch(geometry::rectangle({0, 0, 0}, 10 / (nKept + fraction), 1),
                                     {TrimmingLoop::around(box)}, "plate");
            ShellDescription plate{geometry::BrepModel({{patch.refined(degree, degree, 10, 2)}}),
                                   {0.01},
                                   {1e6, 0.3, 1}};
            plate.strains = Strains::linear;
            plate.edgeSupports = {support(left, {true, true, true}, true)};
            plate.loads.edgeForces = {{{0, right}, VectorField::constant({0, 0, -1e-6})}};
            Shell shell(std::move(plate));
            const VectorXd d = solveStatic(shell);
            const double end = shell.stateAt(0, last, 0.5, d).displacement[2];
            if (fraction == 1) {
                whole = end;
            }
            // What nine elements and eight differ by.
            EXPECT_NEAR(end, whole, 2e-3 * std::abs(whole)) << degree << " " << fraction;
        }
    }
}
