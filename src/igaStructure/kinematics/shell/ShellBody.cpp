// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/ShellBody.hpp"

#include "geometry/trimming/patchTriangles.hpp"
#include "igaStructure/kinematics/thinness.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace tokay::structure {

using Eigen::MatrixXd;
using Eigen::Vector3d;

namespace {

// The part of a patch inside its loops, as fine as cells of full elements.
VtuMesh triangleMesh(const geometry::TrimmedPatch& patch, int number, int subdivision) {
    const geometry::Box box = geometry::Box::around(patch.basis().controlPoints());
    const int nCells = subdivision * std::max(patch.nElementsU(), patch.nElementsV());
    // A chord of an arc leaves it by an eighth of its length, squared, over the radius.
    const geometry::PatchTriangles triangles =
        geometry::patchTriangles(patch, box.diagonal() / (8.0 * nCells * nCells));
    VtuMesh mesh;
    mesh.cellSize = 3;
    mesh.cellType = VtkCell::triangle;
    for (const geometry::Parameters& at : triangles.parameters) {
        mesh.points.push_back({number, at[0], at[1], 0});
    }
    for (const std::array<int, 3>& triangle : triangles.triangles) {
        mesh.connectivity.insert(mesh.connectivity.end(), triangle.begin(), triangle.end());
    }
    return mesh;
}

// Principal values of a plane tensor (11, 22, 12), the larger one first.
Eigen::Vector2d principal(const Vector3d& tensor) {
    const double mean = 0.5 * (tensor[0] + tensor[1]);
    const double radius = std::hypot(0.5 * (tensor[0] - tensor[1]), tensor[2]);
    return {mean + radius, mean - radius};
}

} // namespace

ShellBody::ShellBody(ShellDescription description)
    : shell_(std::move(description)), projector_(shell_.model()) {
    add({"membraneForce", "N/m", 3, true, [this](const MotionState& state, const auto& locations) {
             return resultant(&ShellState::force, state, locations);
         }});
    add({"bendingMoment", "N", 3, shell_.description().bending,
         [this](const MotionState& state, const auto& locations) {
             return resultant(&ShellState::moment, state, locations);
         }});
    add({"principalStressTop", "Pa", 2, false,
         [this](const MotionState& state, const auto& locations) {
             return principalStress(1, state, locations);
         }});
    add({"principalStressBottom", "Pa", 2, false,
         [this](const MotionState& state, const auto& locations) {
             return principalStress(-1, state, locations);
         }});
}

namespace {

// Joints that the geometry does not name: they may be meant as slits.
std::string describeFoundJoints(const geometry::BrepModel& model) {
    std::vector<std::string> found;
    for (const geometry::BrepEdge& edge : model.edges()) {
        if (edge.isFound) {
            found.push_back(edge.name);
        }
    }
    return found.empty() ? ""
                         : fmt::format("  joined where edges coincide (geometry.slit: yes keeps "
                                       "them open): {}\n",
                                       fmt::join(found, ", "));
}

// Corrections to a CAD file are never silent.
std::string describeRemarks(const geometry::BrepModel& model) {
    return model.remarks().empty()
               ? ""
               : fmt::format("  note: {}\n", fmt::join(model.remarks(), "\n  note: "));
}

} // namespace

std::string ShellBody::description() const {
    const ShellDescription& all = shell_.description();
    const auto [thinnest, thickest] =
        std::minmax_element(all.thickness.begin(), all.thickness.end());
    int nElements = 0;
    int nCut = 0;
    for (const auto& patch : shell_.patches()) {
        nElements += static_cast<int>(patch->patch().elements(geometry::ElementState::full).size());
        nCut += static_cast<int>(patch->patch().elements(geometry::ElementState::cut).size());
    }
    const geometry::NurbsSurface& first = shell_.patches()[0]->surface();
    return fmt::format(
        "  {}, {} strains, {} patch{} with {} joint{}, degree {} x {}, {} elements and {} cut "
        "ones\n"
        "  {}, thickness {:g} to {:g} m\n"
        "{}{}",
        all.bending ? "Kirchhoff-Love shell" : "membrane",
        shell_.isLinear() ? "linear" : "nonlinear", shell_.patches().size(),
        shell_.patches().size() == 1 ? "" : "es", shell_.constraints().nJoints,
        shell_.constraints().nJoints == 1 ? "" : "s", first.u().degree(), first.v().degree(),
        nElements, nCut, all.material.description(), *thinnest, *thickest,
        describeFoundJoints(all.model), describeRemarks(all.model));
}

std::vector<VtuMesh> ShellBody::meshes(const OutputOptions& options) const {
    std::vector<VtuMesh> meshes;
    for (std::size_t face = 0; face < shell_.patches().size(); ++face) {
        const geometry::TrimmedPatch& patch = shell_.patches()[face]->patch();
        const int number = static_cast<int>(face);
        if (patch.isTrimmed()) {
            meshes.push_back(triangleMesh(patch, number, options.subdivision));
        } else if (options.cells == CellShape::bezier) {
            meshes.push_back(bezierMesh(patch.basis(), number));
        } else {
            meshes.push_back(quadMesh(patch.basis(), options.subdivision, number));
        }
    }
    return meshes;
}

MatrixXd ShellBody::positions(const std::vector<Location>& locations) const {
    MatrixXd values(3, locations.size());
    for (std::size_t k = 0; k < locations.size(); ++k) {
        const geometry::Points d = shell_.patches()[locations[k].patch]->surface().derivatives(
            locations[k].xi, locations[k].eta, 1);
        values.col(k) = d.row(0).transpose();
        if (locations[k].zeta != 0) {
            const Vector3d normal =
                d.row(1).transpose().head<3>().cross(d.row(2).transpose().head<3>());
            values.col(k) += locations[k].zeta * normal.normalized();
        }
    }
    return values;
}

MatrixXd ShellBody::displacements(const Eigen::VectorXd& displacement,
                                  const std::vector<Location>& locations) const {
    MatrixXd values(3, locations.size());
    for (std::size_t k = 0; k < locations.size(); ++k) {
        const Location& location = locations[k];
        values.col(k) = shell_.displacementAt(location.patch, {location.xi, location.eta},
                                              location.zeta, displacement);
    }
    return values;
}

MatrixXd ShellBody::resultant(Vector3d ShellState::*of, const MotionState& state,
                              const Locations& locations) const {
    MatrixXd values(3, locations.size());
    for (std::size_t k = 0; k < locations.size(); ++k) {
        const Location& at = locations[k];
        values.col(k) = shell_.stateAt(at.patch, at.xi, at.eta, state.displacement).*of;
    }
    return values;
}

MatrixXd ShellBody::principalStress(double side, const MotionState& state,
                                    const Locations& locations) const {
    MatrixXd values(2, locations.size());
    for (std::size_t k = 0; k < locations.size(); ++k) {
        const Location& at = locations[k];
        const ShellState is = shell_.stateAt(at.patch, at.xi, at.eta, state.displacement);
        const double t = shell_.description().thickness[at.patch];
        values.col(k) = principal(is.force / t + side * 6 / (t * t) * is.moment);
    }
    return values;
}

Body::Closest ShellBody::closest(const geometry::Point& point) const {
    const geometry::ModelProjection found = projector_.closest(point);
    Location location{found.face, found.xi, found.eta, 0};
    const geometry::Points d =
        shell_.patches()[found.face]->surface().derivatives(found.xi, found.eta, 1);
    const Vector3d a1 = d.row(1);
    const Vector3d a2 = d.row(2);
    const double half = 0.5 * shell_.description().thickness[found.face];
    const double along = (point - d.row(0).transpose()).dot(a1.cross(a2).normalized());
    location.zeta = std::clamp(along, -half, half);
    return {location, (positions({location}).col(0) - point).norm()};
}

double ShellBody::thickness() const {
    const std::vector<double>& thickness = shell_.description().thickness;
    return *std::min_element(thickness.begin(), thickness.end());
}

double ShellBody::massPerWetArea() const {
    return shell_.description().material.density * thickness();
}

double ShellBody::largestThicknessOverRadius() const {
    double largest = 0;
    for (std::size_t face = 0; face < shell_.patches().size(); ++face) {
        largest = std::max(largest, shell_.description().thickness[face] *
                                        largestCurvature(shell_.patches()[face]->surface()));
    }
    return largest;
}

namespace {

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

// A control point far from all others is a slip of a CAD file, and what follows from the
// size of the body is then of no use.
std::string describeFarPoint(const geometry::Points& points) {
    constexpr double far = 1e4; // an arc of nearly 180 degrees: tens
    Vector3d middle;
    for (int c = 0; c < 3; ++c) {
        middle[c] = median({points.col(c).begin(), points.col(c).end()});
    }
    const Eigen::VectorXd distances = (points.rowwise() - middle.transpose()).rowwise().norm();
    Eigen::Index farthest = 0;
    const double ratio =
        distances.maxCoeff(&farthest) / median({distances.begin(), distances.end()});
    const Vector3d x = points.row(farthest).transpose();
    return ratio < far ? ""
                       : fmt::format("control point ({:.6g}, {:.6g}, {:.6g}) lies {:.2g} times as "
                                     "far out as half of the others: check the geometry",
                                     x[0], x[1], x[2], ratio);
}

} // namespace

std::vector<std::string> ShellBody::advice() const {
    const ShellDescription& all = shell_.description();
    if (const std::string far = describeFarPoint(shell_.nodes().positions); !far.empty()) {
        return {far};
    }
    const double thickest = *std::max_element(all.thickness.begin(), all.thickness.end());
    const double slenderness = shell_.size() / thickest;
    if (!all.bending) {
        return {fmt::format(
            "slenderness (size over thickness) {:.3g}{}", slenderness,
            leftOutBending(thickest, all.material.planeStressModulus(), all.prestress.maxCoeff()))};
    }
    constexpr double least = 10; // shear adds about a percent to a plate's deflection
    std::vector<std::string> lines = {fmt::format(
        "slenderness (size over thickness) {:.3g}{}", slenderness,
        slenderness < least                  ? ": shear deformation, which a Kirchhoff-Love shell "
                                               "leaves out, is not small"
        : tooThinToBend(slenderness).empty() ? ": in the range of a Kirchhoff-Love shell"
                                             : tooThinToBend(slenderness))};
    constexpr double thick = 0.1;
    if (const double share = largestThicknessOverRadius(); share > 1e-6) {
        lines.push_back(fmt::format("thickness over radius of curvature {:.3g}, terms of which "
                                    "order a shell leaves out{}",
                                    share, share > thick ? "; a solid models them" : ""));
    }
    return lines;
}

namespace {

// An edge at which the body ends; left, right, bottom and top of a patch that is whole.
geometry::BrepTrim rimNamed(const geometry::BrepModel& model, const std::string& name) {
    constexpr std::array<std::string_view, 4> sides = {"bottom", "right", "top", "left"};
    const auto side = std::find(sides.begin(), sides.end(), name);
    if (side != sides.end() && model.faces().size() == 1 && !model.patch(0).isTrimmed()) {
        return {0, static_cast<int>(side - sides.begin())}; // as the curves of its loop run
    }
    const geometry::BrepEdge& edge = model.edges()[model.edgeNumber(name)];
    if (edge.trims.size() != 1) {
        throw InputError(
            fmt::format("edge \"{}\" lies between patches of this structure: only edges "
                        "at which it ends can be coupled",
                        name));
    }
    return edge.trims[0];
}

} // namespace

std::unique_ptr<const mapper::CurveInterface>
ShellBody::edges(const std::vector<std::string>& names) const {
    if (shell_.description().bending) {
        throw InputError("the edges of a shell also turn, which coupled edges do not feel: they "
                         "would be hinges; couple membranes or plane solids, or join the patches "
                         "of a shell in one model");
    }
    std::vector<std::unique_ptr<mapper::InterfaceCurve>> curves;
    for (const std::string& name : names) {
        const geometry::BrepTrim trim = rimNamed(shell_.model(), name);
        const ShellPatch& patch = *shell_.patches()[static_cast<std::size_t>(trim.face)];
        curves.push_back(mapper::interfaceCurve(
            geometry::CurveOnSurface(shell_.model().curve(trim.face, trim.curve), patch.surface()),
            patch.nodes()));
    }
    return std::make_unique<mapper::CurveInterface>(std::move(curves), shell_.nodes().positions);
}

WetSurface ShellBody::wetSurface(const std::vector<std::string>& /*names*/) const {
    std::vector<mapper::SurfacePiece> pieces;
    for (const auto& patch : shell_.patches()) {
        pieces.push_back({patch->patch(), patch->nodes(), patch->patch().name()});
    }
    return mapper::SurfaceInterface(std::move(pieces), shell_.nodes().count());
}

} // namespace tokay::structure
