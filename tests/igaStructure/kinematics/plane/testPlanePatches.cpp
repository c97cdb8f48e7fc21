// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/errors.hpp"
#include "geometry/brep/cadJson.hpp"
#include "geometry/primitives/primitives.hpp"
#include "igaStructure/case/makeBody.hpp"
#include "igaStructure/case/readCase.hpp"
#include "igaStructure/kinematics/plane/PlanePatchesBody.hpp"
#include "igaStructure/timeIntegration/TimeIntegrator.hpp"
#include "temporaryDirectory.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>

using namespace tokay;
using namespace tokay::structure;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

PlaneMaterial material(Kinematics kinematics) {
    PlaneMaterial material;
    material.kinematics = kinematics;
    material.youngsModulus = 1e5;
    material.poissonsRatio = 0.3;
    material.density = 1;
    material.thickness = kinematics == Kinematics::planeStress ? 0.2 : 1;
    return material;
}

VectorXd solved(Body& body) {
    TimeIntegrator integrator(body.model(), TimeScheme::quasiStatic(), {1e-12, 40, true}, 0);
    integrator.beginTimeStep(1, 1);
    integrator.solve();
    integrator.acceptTimeStep();
    return integrator.state().displacement;
}

// Kirsch's solution for tension 1 along x at infinity and a hole of radius 1:
// xx, yy, xy.
Vector3d kirsch(const Vector3d& x) {
    const double r2 = x.head<2>().squaredNorm();
    const double a = std::atan2(x[1], x[0]);
    const double s = 1 / r2, q = 1.5 * s * s;
    return {1 - s * (1.5 * std::cos(2 * a) + std::cos(4 * a)) + q * std::cos(4 * a),
            -s * (0.5 * std::cos(2 * a) - std::cos(4 * a)) - q * std::cos(4 * a),
            -s * (0.5 * std::sin(2 * a) + std::sin(4 * a)) + q * std::sin(4 * a)};
}

// Its displacement in plane stress (G shear modulus, kappa = (3 - nu) / (1 + nu)).
Vector3d kirschDisplacement(const Vector3d& x) {
    const PlaneMaterial own = material(Kinematics::planeStress);
    const double nu = own.poissonsRatio, kappa = (3 - nu) / (1 + nu);
    const double G = own.youngsModulus / (2 * (1 + nu));
    const double r = x.head<2>().norm(), a = std::atan2(x[1], x[0]);
    const double inner = 2 / r - 2 / (r * r * r);
    return Vector3d(r * (kappa + 1) * std::cos(a) + 2 / r * (1 + kappa) * std::cos(a) +
                        inner * std::cos(3 * a),
                    r * (kappa - 3) * std::sin(a) + 2 / r * (1 - kappa) * std::sin(a) +
                        inner * std::sin(3 * a),
                    0) /
           (8 * G);
}

VectorField traction(const Vector3d& normal, double thickness) {
    return {[=](const geometry::Point& x, double) {
                const Vector3d s = kirsch(x);
                return Vector3d(thickness * Vector3d(s[0] * normal[0] + s[2] * normal[1],
                                                     s[2] * normal[0] + s[1] * normal[1], 0));
            },
            false, true};
}

geometry::NurbsCurve clockwise(const geometry::NurbsCurve& arc) {
    return {arc.knotVector(), arc.controlPoints().colwise().reverse(), arc.weights().reverse()};
}

// A quarter of the plate, 4 x 4, cut out of a square that is a bit larger, so that the
// symmetric edges and the hole are trimming curves inside of elements.
PlanePatchesCase plateWithHole(EdgeMethod method, Kinematics kinematics, int degree, int n) {
    constexpr double lower = -0.131, size = 4.131;
    const auto at = [&](double x, double y) {
        return geometry::Point((x - lower) / size, (y - lower) / size, 0);
    };
    std::vector<geometry::NurbsCurve> curves = {
        geometry::line(at(1, 0), at(4, 0)), geometry::line(at(4, 0), at(4, 4)),
        geometry::line(at(4, 4), at(0, 4)), geometry::line(at(0, 4), at(0, 1)),
        clockwise(geometry::arc(at(0, 0), 1 / size, 0, 0.5 * M_PI))};
    const geometry::TrimmedPatch patch(
        geometry::rectangle({lower, lower, 0}, size, size),
        {geometry::TrimmingLoop(geometry::LoopKind::outer, std::move(curves))}, "plate");
    const PlaneMaterial own = material(kinematics);
    ShellDescription plate{geometry::BrepModel({{patch.refined(degree, degree, n, n)}}),
                           {own.thickness},
                           own.asPlaneStress()};
    plate.strains = Strains::linear;
    plate.bending = false;
    plate.isPlane = true;
    plate.edgeMethod = method;
    plate.edgeSupports = {{{{0, 0}}, {false, true, false}}, {{{0, 3}}, {true, false, false}}};
    plate.loads.edgeForces = {{{0, 1}, traction({1, 0, 0}, own.thickness)},
                              {{0, 2}, traction({0, 1, 0}, own.thickness)}};
    return {std::move(plate), own};
}

// The same with the displacement of the solution given along the hole.
PlanePatchesCase plateHeldAtHole(EdgeMethod method, int degree, int n) {
    PlanePatchesCase plate = plateWithHole(method, Kinematics::planeStress, degree, n);
    EdgeSupport hole{{{0, 4}}, {true, true, false}};
    hole.motion = std::make_shared<VectorField>(VectorField{
        [](const geometry::Point& x, double) { return kirschDisplacement(x); }, false, true});
    plate.membrane.edgeSupports.push_back(hole);
    return plate;
}

struct StressError {
    double concentration; ///< at the top of the hole, less 3
    double l2;            ///< relative, on a polar grid around the hole
};

StressError stressError(PlanePatchesCase plate) {
    PlanePatchesBody body(std::move(plate));
    MotionState state;
    state.displacement = solved(body);
    const auto stress = [&](const Vector3d& x) {
        const VectorXd s = body.field("stress").evaluate(state, {body.closest(x).location});
        return Vector3d(s[0], s[1], s[3]);
    };
    double error = 0, size = 0;
    for (int i = 0; i < 12; ++i) {
        for (int j = 0; j < 12; ++j) {
            const double r = 1.01 + 2.9 * (i + 0.5) / 12;
            const double a = 0.5 * M_PI * (j + 0.5) / 12;
            const Vector3d x(r * std::cos(a), r * std::sin(a), 0);
            error += r * (stress(x) - kirsch(x)).squaredNorm();
            size += r * kirsch(x).squaredNorm();
        }
    }
    return {stress({0, 1, 0})[0] - 3, std::sqrt(error / size)};
}

} // namespace

TEST(PlanePatches, stresses_of_a_plate_with_a_trimmed_hole_converge_to_kirschs) {
    for (const EdgeMethod method : {EdgeMethod::nitsche, EdgeMethod::penalty}) {
        const StressError coarse =
            stressError(plateWithHole(method, Kinematics::planeStress, 3, 16));
        const StressError fine = stressError(plateWithHole(method, Kinematics::planeStress, 3, 32));
        // Stresses are of the order of the degree; 0.4 below, as a coarse element is a quarter
        // of the radius.
        EXPECT_GT(std::log2(coarse.l2 / fine.l2), 3 - 0.4);
        EXPECT_LT(fine.l2, 5e-4);
        EXPECT_LT(std::abs(fine.concentration), 0.005 * 3);
        EXPECT_LT(std::abs(fine.concentration), 0.2 * std::abs(coarse.concentration));
    }
    // In plane strain stresses in the plane are the same.
    EXPECT_LT(stressError(plateWithHole(EdgeMethod::nitsche, Kinematics::planeStrain, 3, 32)).l2,
              5e-4);
}

TEST(PlanePatches, strong_supports_of_a_trimmed_hole_converge_to_kirschs) {
    // By the extended gradient method; the coarse element is a quarter of the radius, so its
    // cut elements reach far and the error falls faster than by the order of the stress.
    const StressError coarse = stressError(plateHeldAtHole(EdgeMethod::egm, 3, 16));
    const StressError fine = stressError(plateHeldAtHole(EdgeMethod::egm, 3, 32));
    EXPECT_GT(std::log2(coarse.l2 / fine.l2), 3);
    EXPECT_LT(fine.l2, 1e-3);
    EXPECT_LT(std::abs(fine.concentration), 0.02 * 3);
}

namespace {

// Two parts of a rectangle 2 x 1 that meet along a slanted line, with meshes that do not match.
geometry::BrepModel twoTrimmedParts() {
    const auto part = [](const char* name, double lower, double size,
                         const std::vector<Vector3d>& corners) {
        std::vector<geometry::NurbsCurve> curves;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const auto at = [&](const Vector3d& x) {
                return geometry::Point((x[0] - lower) / size, (x[1] + 0.2) / 1.4, 0);
            };
            curves.push_back(geometry::line(at(corners[k]), at(corners[(k + 1) % corners.size()])));
        }
        return geometry::TrimmedPatch(
            geometry::rectangle({lower, -0.2, 0}, size, 1.4),
            {geometry::TrimmingLoop(geometry::LoopKind::outer, std::move(curves))}, name);
    };
    const auto left = part("west", -0.1, 1.5, {{0, 0, 0}, {0.8, 0, 0}, {1.2, 1, 0}, {0, 1, 0}});
    const auto right = part("east", 0.7, 1.45, {{0.8, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1.2, 1, 0}});
    return geometry::BrepModel({{left}, {right}}, {{"joint", {{0, 1}, {1, 3, false}}},
                                                   {"south", {{0, 0}}},
                                                   {"south east", {{1, 0}}},
                                                   {"outer", {{1, 1}}},
                                                   {"north east", {{1, 2}}},
                                                   {"north", {{0, 2}}},
                                                   {"inner", {{0, 3}}}});
}

struct CadFile {
    CadFile() { geometry::writeCadJson(twoTrimmedParts(), directory.file("parts.cad.json")); }

    Case readCase(const std::string& supports, const std::string& model,
                  const std::string& rest = "") const {
        return readCaseText("geometry: {cadJson: parts.cad.json}\n"
                            "discretisation: {degree: [2, 2], elements: [5, 4]}\nmodel: " +
                                model +
                                "\nmaterial: {type: StVenantKirchhoff, youngsModulus: 1e5, "
                                "poissonsRatio: 0.3, density: 1}\nsupports:\n" +
                                supports + rest + "time: {scheme: static, step: 1, end: 1}\n",
                            directory.file("case.yaml"));
    }

    TemporaryDirectory directory;
};

std::string messageOf(const std::function<void()>& make) {
    try {
        make();
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

} // namespace

TEST(PlanePatches, linear_field_on_the_boundary_of_two_trimmed_patches_fills_them) {
    const CadFile file;
    std::string supports;
    for (const char* edge : {"south", "south east", "outer", "north east", "north", "inner"}) {
        supports += std::string("  - {brepEdge: ") + edge +
                    ", fix: [x, y], displacement: [\"0.02*x+0.01*y\", \"0.03*y-0.01*x\"]}\n";
    }
    for (const std::string kinematics : {"planeStress", "planeStrain"}) {
        const Case plane =
            file.readCase(supports, "{kinematics: " + kinematics + ", strains: linear" +
                                        (kinematics == "planeStress" ? ", thickness: 0.1}" : "}"));
        const auto body = makeBody(plane);
        EXPECT_EQ(body->dimension(), 2);
        MotionState state;
        state.displacement = solved(*body);
        const double nu = 0.3;
        const double lambda =
            1e5 * nu / (1 + nu) / (kinematics == "planeStress" ? 1 - nu : 1 - 2 * nu);
        const double mu = 1e5 / 2 / (1 + nu);
        for (const Vector3d& x :
             {Vector3d(0.4, 0.3, 0), Vector3d(1, 0.55, 0), Vector3d(1.9, 0.9, 0)}) {
            const std::vector<Location> at = {body->closest(x).location};
            const Eigen::MatrixXd u = body->displacements(state.displacement, at);
            // Nitsche's method is consistent, so only rounding remains.
            EXPECT_NEAR(u(0, 0), 0.02 * x[0] + 0.01 * x[1], 1e-10);
            EXPECT_NEAR(u(1, 0), 0.03 * x[1] - 0.01 * x[0], 1e-10);
            const VectorXd stress = body->field("stress").evaluate(state, at);
            EXPECT_NEAR(stress[0], lambda * 0.05 + 2 * mu * 0.02, 1e-4);
            EXPECT_NEAR(stress[1], lambda * 0.05 + 2 * mu * 0.03, 1e-4);
            EXPECT_NEAR(stress[2], kinematics == "planeStress" ? 0 : lambda * 0.05, 1e-4);
            EXPECT_NEAR(stress[3], 0, 1e-4);
        }
    }
}

TEST(PlanePatches, mistakes_are_named) {
    const CadFile file;
    const std::string model = "{kinematics: planeStrain, strains: linear}";
    EXPECT_THAT(messageOf([&] { file.readCase("  - {brepEdge: nowhere, fix: [x, y]}\n", model); }),
                testing::HasSubstr("nowhere"));
    EXPECT_THAT(messageOf([&] { file.readCase("  - {edge: left, fix: [x, y]}\n", model); }),
                testing::HasSubstr("brepEdge"));
    const Case coupled = file.readCase("  - {brepEdge: inner, fix: [x, y]}\n", model,
                                       "coupling: {interface: [outer]}\n");
    EXPECT_THAT(messageOf([&] { makeBody(coupled)->transfer(*coupled.coupling, {}); }),
                testing::HasSubstr("a fluid cannot be coupled to edges of a cad.json model"));
    EXPECT_THAT(messageOf([&] {
                    readCaseText("geometry:\n  rectangle: {origin: [0, 0], size: [1, 1]}\n"
                                 "discretisation: {degree: [2, 2], elements: [2, 2]}\n"
                                 "model: {kinematics: planeStrain, strains: linear, penalty: 10}\n"
                                 "material: {type: StVenantKirchhoff, youngsModulus: 1, "
                                 "poissonsRatio: 0, density: 1}\n"
                                 "supports: [{edge: left, fix: [x, y]}]\n"
                                 "time: {step: 1, end: 1}\n",
                                 "case.yaml");
                }),
                testing::HasSubstr("penalty: goes with geometry.cadJson"));
}
