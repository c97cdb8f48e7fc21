// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/errors.hpp"
#include "igaStructure/case/makeBody.hpp"
#include "igaStructure/exampleCase.hpp"
#include "igaStructure/kinematics/Body.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace tokay;
using namespace tokay::structure;
using Eigen::VectorXd;
using geometry::Points;
using mapper::FaceMesh;
using testing::HasSubstr;

namespace {

enum class Shape { plane, beam, shell, solid };

struct Member {
    Shape shape;
    TransferMethod method;
    LoadTransfer loads;
};

std::vector<Member> everyMapping() {
    std::vector<Member> all;
    for (const Shape shape : {Shape::plane, Shape::beam, Shape::shell, Shape::solid}) {
        for (const TransferMethod method :
             {TransferMethod::nearestNeighbour, TransferMethod::nearestElement, TransferMethod::rbf,
              TransferMethod::mortar, TransferMethod::dualMortar, TransferMethod::offset}) {
            for (const LoadTransfer loads : {LoadTransfer::integrated, LoadTransfer::transposed}) {
                if (method != TransferMethod::offset || shape == Shape::beam ||
                    shape == Shape::shell) {
                    all.push_back({shape, method, loads});
                }
            }
        }
    }
    return all;
}

// Those of them that map from elements, not from samples, which know nothing of edges between.
std::vector<Member> everyMappingFromElements() {
    std::vector<Member> all = everyMapping();
    all.erase(std::remove_if(all.begin(), all.end(),
                             [](const Member& member) {
                                 return member.method == TransferMethod::nearestNeighbour ||
                                        member.method == TransferMethod::rbf;
                             }),
              all.end());
    return all;
}

std::string mappingName(const testing::TestParamInfo<Member>& info) {
    static const std::map<Shape, std::string> shapes = {{Shape::plane, "plane"},
                                                        {Shape::beam, "beam"},
                                                        {Shape::shell, "shell"},
                                                        {Shape::solid, "solid"}};
    static const std::map<TransferMethod, std::string> methods = {
        {TransferMethod::nearestNeighbour, "nearestNeighbour"},
        {TransferMethod::nearestElement, "nearestElement"},
        {TransferMethod::rbf, "rbf"},
        {TransferMethod::mortar, "mortar"},
        {TransferMethod::dualMortar, "dualMortar"},
        {TransferMethod::offset, "offset"}};
    return shapes.at(info.param.shape) + "_" + methods.at(info.param.method) + "_" +
           (info.param.loads == LoadTransfer::integrated ? "integrated" : "transposed");
}

std::unique_ptr<Body> bodyOf(Shape shape) {
    const std::string rest = ", strains: linear}\n"
                             "material: {type: StVenantKirchhoff, youngsModulus: 1e5, "
                             "poissonsRatio: 0.3, density: 1000}\n"
                             "supports: []\ntime: {step: 0.1, end: 1}\n";
    const std::string sheet = "geometry: {cylinder: {base: [0, 0, 0], radius: 1, height: 1, "
                              "angles: [0, 60]}}\n";
    switch (shape) {
    case Shape::plane:
        return makeBody(readText("geometry: {rectangle: {origin: [0, 0], size: [0.2, 1]}}\n"
                                 "discretisation: {degree: [2, 2], elements: [1, 5]}\n"
                                 "model: {kinematics: planeStrain" +
                                 rest));
    case Shape::beam:
        return makeBody(readText("geometry: {line: {from: [0, 0], to: [0, 1]}}\n"
                                 "discretisation: {degree: [3], elements: [5]}\n"
                                 "model: {thickness: 0.05, kinematics: beam" +
                                 rest));
    case Shape::shell:
        return makeBody(readText(sheet +
                                 "discretisation: {degree: [2, 2], elements: [4, 3]}\n"
                                 "model: {thickness: 0.05, kinematics: shell" +
                                 rest));
    case Shape::solid:
        break;
    }
    return makeBody(readText(sheet +
                             "discretisation: {degree: [2, 2, 2], elements: [4, 3, 1]}\n"
                             "model: {thickness: 0.2, kinematics: solid" +
                             rest));
}

FaceMesh edges(int n) {
    FaceMesh mesh{Points::Zero(n + 1, 3), {}};
    for (int i = 0; i <= n; ++i) {
        mesh.vertices(i, 1) = static_cast<double>(i) / n;
        if (i > 0) {
            mesh.faces.push_back({i - 1, i});
        }
    }
    return mesh;
}

FaceMesh cylinder(double radius, int nAround, int nUp) {
    FaceMesh mesh{Points((nAround + 1) * (nUp + 1), 3), {}};
    for (int j = 0; j <= nUp; ++j) {
        for (int i = 0; i <= nAround; ++i) {
            const double angle = M_PI / 3 * i / nAround;
            const int k = i + (nAround + 1) * j;
            mesh.vertices.row(k) << radius * std::cos(angle), radius * std::sin(angle),
                static_cast<double>(j) / nUp;
            if (i < nAround && j < nUp) {
                mesh.faces.push_back({k, k + 1, k + nAround + 2, k + nAround + 1});
            }
        }
    }
    return mesh;
}

/// n faces along the wet part of a body.
FaceMesh fluidOf(Shape shape, int n) {
    switch (shape) {
    case Shape::plane:
    case Shape::beam:
        return edges(n);
    case Shape::shell:
        return cylinder(1, n, n);
    case Shape::solid:
        break;
    }
    return cylinder(0.9, n, n); // the inner face
}

Coupling couplingOf(const Member& member) {
    Coupling coupling;
    coupling.method = member.method;
    coupling.loads = member.loads;
    coupling.gapLimit = 0.1; // chords of the cylinder
    if (member.shape == Shape::plane) {
        coupling.interface = {"left"};
    } else if (member.shape == Shape::solid) {
        coupling.interface = {"back"};
    }
    return coupling;
}

/// Unknowns of the motion A X + b.
VectorXd affineMotion(const Body& body, const InterfaceTransfer& transfer, const Eigen::Matrix3d& A,
                      const Eigen::Vector3d& b) {
    const Points X = transfer.controlPoints(VectorXd::Zero(body.model().nUnknowns()));
    const int d = body.model().nComponents();
    VectorXd unknowns(X.rows() * d);
    for (Eigen::Index k = 0; k < X.rows(); ++k) {
        const Eigen::Vector3d u = A * X.row(k).transpose() + b;
        unknowns.segment(d * k, d) = u.head(d);
    }
    return unknowns;
}

Points randomForces(const Body& body, Eigen::Index n) {
    std::srand(3);
    Points forces = Points::Random(n, 3);
    forces.rightCols(3 - body.dimension()).setZero();
    return forces;
}

Points faceMeans(const FaceMesh& mesh, const Points& values) {
    return mapper::loadsAtVertices(mesh).shares.transpose() * values;
}

class EveryMapping : public testing::TestWithParam<Member> {};
class EveryMappingFromElements : public EveryMapping {};

} // namespace

TEST_P(EveryMapping, translation_is_exact_and_the_sum_of_forces_is_kept) {
    const std::unique_ptr<Body> body = bodyOf(GetParam().shape);
    for (const int n : {1, 4, 20}) { // faces larger, as large and smaller than knot spans
        const FaceMesh fluid = fluidOf(GetParam().shape, n);
        const auto transfer = body->transfer(couplingOf(GetParam()), fluid);
        const Eigen::Vector3d b(0.3, -0.2, body->dimension() == 3 ? 0.7 : 0);
        const VectorXd translation = affineMotion(*body, *transfer, Eigen::Matrix3d::Zero(), b);
        const Points moved = transfer->displacements(translation);
        EXPECT_LT((moved.rowwise() - b.transpose()).cwiseAbs().maxCoeff(), 1e-11);
        const Points forces = randomForces(*body, fluid.nFaces());
        const VectorXd rest = VectorXd::Zero(translation.size());
        const Points onControlPoints = transfer->controlForces(rest, forces);
        EXPECT_LT((onControlPoints.colwise().sum() - forces.colwise().sum()).norm(),
                  1e-11 * forces.cwiseAbs().sum());
    }
}

TEST_P(EveryMapping, transposed_loads_keep_work_and_integrated_ones_do_to_second_order) {
    const std::unique_ptr<Body> body = bodyOf(GetParam().shape);
    const auto error = [&](int n) {
        const FaceMesh fluid = fluidOf(GetParam().shape, n);
        const auto transfer = body->transfer(couplingOf(GetParam()), fluid);
        // A smooth traction and a smooth motion
        const Points centres = faceMeans(fluid, fluid.vertices);
        Points forces = Points::Zero(fluid.nFaces(), 3);
        forces.col(0) = (2 * centres.col(1)).array().cos() / fluid.nFaces();
        const Points X = transfer->controlPoints(VectorXd::Zero(body->model().nUnknowns()));
        const int d = body->model().nComponents();
        VectorXd motion = VectorXd::Zero(X.rows() * d);
        for (Eigen::Index k = 0; k < X.rows(); ++k) {
            motion[d * k] = X(k, 1) * X(k, 1);
        }
        // Some faces do work and others take it: relative to the sum of magnitudes
        const Points work = forces.cwiseProduct(faceMeans(fluid, transfer->displacements(motion)));
        const double onStructure =
            transfer->forces(VectorXd::Zero(motion.size()), forces).dot(motion);
        return std::abs(onStructure - work.sum()) / work.cwiseAbs().sum();
    };
    if (GetParam().loads == LoadTransfer::transposed) {
        EXPECT_LT(error(6), 1e-11);
    } else if (GetParam().method == TransferMethod::nearestNeighbour) {
        EXPECT_LT(error(12), 0.2); // steps between samples
    } else if (GetParam().method == TransferMethod::rbf) {
        EXPECT_LT(error(24), 5e-3); // what interpolation misses between samples, whatever the faces
    } else {
        EXPECT_LT(error(24), error(6) / 8 + 1e-9);
        // A chord's mean misses (1/24)^2/12 of a curvature of 2; the mean motion is a fifth
        EXPECT_LT(error(24), 2e-3);
    }
}

// A body that bends within a knot span of its clamped edges, next to much larger faces.
TEST_P(EveryMappingFromElements, points_on_clamped_edges_stay_on_them) {
    const std::unique_ptr<Body> body = bodyOf(GetParam().shape);
    const FaceMesh fluid = fluidOf(GetParam().shape, 2);
    const auto transfer = body->transfer(couplingOf(GetParam()), fluid);
    const bool isSheet = body->dimension() == 3; // from 0 to 60 degrees, z from 0 to 1
    const auto isOnEdge = [&](const Eigen::RowVector3d& X) {
        const double along = isSheet ? std::atan2(X[1], X[0]) * 3 / M_PI : X[1];
        const double up = isSheet ? X[2] : 0.5;
        return std::min({along, 1 - along, up, 1 - up}) < 1e-9;
    };
    const Points X = transfer->controlPoints(VectorXd::Zero(body->model().nUnknowns()));
    const int d = body->model().nComponents();
    VectorXd motion = VectorXd::Zero(X.rows() * d);
    for (Eigen::Index k = 0; k < X.rows(); ++k) {
        motion[d * k] = isOnEdge(X.row(k)) ? 0 : 1;
    }
    const Points moved = transfer->displacements(motion);
    int nInside = 0;
    for (Eigen::Index i = 0; i < moved.rows(); ++i) {
        if (isOnEdge(fluid.vertices.row(i))) {
            EXPECT_LT(moved.row(i).norm(), 1e-11) << i;
        } else {
            EXPECT_GT(moved(i, 0), 0.5);
            ++nInside;
        }
    }
    EXPECT_EQ(nInside, 1);
}

INSTANTIATE_TEST_SUITE_P(Transfer, EveryMapping, testing::ValuesIn(everyMapping()), mappingName);
INSTANTIATE_TEST_SUITE_P(Transfer, EveryMappingFromElements,
                         testing::ValuesIn(everyMappingFromElements()), mappingName);

TEST(Transfer, nearest_element_rbf_and_mortar_take_linear_motions_exactly) {
    Eigen::Matrix3d A;
    A << 0.1, -0.3, 0.2, 0.4, 0.2, -0.1, 0.3, 0.1, -0.2;
    for (const Shape shape : {Shape::plane, Shape::beam}) {
        for (const TransferMethod method : {TransferMethod::nearestElement, TransferMethod::rbf,
                                            TransferMethod::mortar, TransferMethod::dualMortar}) {
            const std::unique_ptr<Body> body = bodyOf(shape);
            const FaceMesh fluid = fluidOf(shape, 7);
            const auto transfer =
                body->transfer(couplingOf({shape, method, LoadTransfer::integrated}), fluid);
            const Points moved =
                transfer->displacements(affineMotion(*body, *transfer, A, Eigen::Vector3d::Zero()));
            const Points exact = fluid.vertices * A.transpose();
            EXPECT_LT((moved - exact).leftCols(2).cwiseAbs().maxCoeff(), 1e-11);
        }
    }
}

TEST(Transfer, point_loads_on_a_finer_structure_are_told) {
    const std::unique_ptr<Body> body = bodyOf(Shape::plane);
    const FaceMesh coarse = fluidOf(Shape::plane, 2);
    const auto report = [&](TransferMethod method, LoadTransfer loads) {
        return body->transfer(couplingOf({Shape::plane, method, loads}), coarse)->report();
    };
    EXPECT_THAT(report(TransferMethod::nearestElement, LoadTransfer::transposed),
                HasSubstr("2 of 2 faces are larger than a knot span"));
    EXPECT_THAT(report(TransferMethod::nearestElement, LoadTransfer::integrated),
                testing::Not(HasSubstr("WARNING")));
    EXPECT_THAT(report(TransferMethod::mortar, LoadTransfer::transposed),
                testing::Not(HasSubstr("WARNING")));
}

TEST(Transfer, points_that_mortar_does_not_reach_are_refused) {
    const std::unique_ptr<Body> body = bodyOf(Shape::shell);
    FaceMesh fluid = fluidOf(Shape::shell, 4);
    // The last row of faces lies beyond the edge at z = 1, nearer than the limit
    fluid.vertices.col(2) = fluid.vertices.col(2).unaryExpr([](double z) {
        return z > 0.9 ? 1.1 : z > 0.6 ? 1.05 : z;
    });
    try {
        body->transfer(couplingOf({Shape::shell, TransferMethod::mortar, LoadTransfer::integrated}),
                       fluid);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("coupling.mapping.type"));
    }
}
