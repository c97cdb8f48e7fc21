#include "igaStructure/model/shell/ShellConstraints.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>

namespace tokay::structure {

namespace {

constexpr double sameDirection = 1e-10;

// Control points of a side of a patch, and of the row next to it.
struct Rows {
    std::vector<int> rim, next;
};

Rows rowsAt(const ShellPatch& patch, geometry::Edge edge) {
    const geometry::NurbsSurface& surface = patch.surface();
    Rows rows{surface.boundaryCurve(edge).controlPoints, {}};
    const int nU = surface.u().nBasis();
    const int step = edge == geometry::Edge::left     ? 1
                     : edge == geometry::Edge::right  ? -1
                     : edge == geometry::Edge::bottom ? nU
                                                      : -nU;
    for (int k : rows.rim) {
        rows.next.push_back(k + step);
    }
    return rows;
}

// The axis of space along which all normals of an edge are.
std::optional<int> normalAxis(const std::vector<EdgePoint>& points) {
    for (int axis = 0; axis < 3; ++axis) {
        bool all = !points.empty();
        for (const EdgePoint& point : points) {
            all = all && std::abs(point.side.normal()[axis]) > 1 - sameDirection;
        }
        if (all) {
            return axis;
        }
    }
    return std::nullopt;
}

class Builder {
  public:
    Builder(const ShellDescription& description, const ShellPatches& patches, int nNodes)
        : description_(description), patches_(patches) {
        constraints_.supported.assign(3 * nNodes, false);
    }

    ShellConstraints build() {
        for (const EdgeSupport& support : description_.edgeSupports) {
            for (const geometry::BrepTrim& trim : support.trims) {
                hold(support, trim);
            }
        }
        for (const PointSupport& support : description_.pointSupports) {
            hold(support);
        }
        for (const geometry::BrepEdge& edge : description_.model.edges()) {
            for (std::size_t k = 1; k < edge.trims.size(); ++k) {
                join(edge.trims[0], edge.trims[k]);
            }
        }
        for (std::size_t face = 0; face < patches_.size() && description_.bending; ++face) {
            addRotationSprings(bendingStiffness(static_cast<int>(face)),
                               creasePoints(*patches_[face]));
        }
        constraints_.fixed = constraints_.supported;
        fixNodesWithoutBody();
        return std::move(constraints_);
    }

  private:
    const ShellPatch& patchOf(const geometry::BrepTrim& trim) const { return *patches_[trim.face]; }
    const geometry::NurbsCurve& curveOf(const geometry::BrepTrim& trim) const {
        return description_.model.curve(trim.face, trim.curve);
    }
    double membraneStiffness(int face) const {
        const double nu = description_.material.poissonsRatio;
        return description_.penalty * description_.material.youngsModulus *
               description_.thickness[face] / (1 - nu * nu);
    }
    double bendingStiffness(int face) const {
        return membraneStiffness(face) * std::pow(description_.thickness[face], 2) / 12;
    }

    void fix(const ShellPatch& patch, const std::vector<int>& controlPoints, int component) {
        for (int k : controlPoints) {
            constraints_.supported[3 * patch.nodes()[k] + component] = true;
        }
    }

    void hold(const EdgeSupport& support, const geometry::BrepTrim& trim) {
        const ShellPatch& patch = patchOf(trim);
        const std::vector<EdgePoint> points = edgePoints(patch, curveOf(trim));
        const auto side = rimOf(curveOf(trim), patch.surface());
        const bool exact = side && !support.weak;
        if (exact) {
            for (int c = 0; c < 3; ++c) {
                if (support.fixed[c]) {
                    fix(patch, rowsAt(patch, *side).rim, c);
                }
            }
        } else {
            addDisplacementSprings(support.fixed, trim.face, points);
        }
        if (!support.clamped || !description_.bending) {
            return;
        }
        const std::optional<int> axis = normalAxis(points);
        if (exact && axis && support.fixed[*axis]) {
            fix(patch, rowsAt(patch, *side).next, *axis);
        } else {
            addRotationSprings(bendingStiffness(trim.face), points);
        }
    }

    void hold(const PointSupport& support) {
        const ShellPatch& patch = *patches_[support.face];
        const PatchPlace place(patch, support.at, Eigen::Vector2d::Zero());
        Eigen::Index k = 0;
        const bool interpolates = place.N.row(0).maxCoeff(&k) > 1 - 1e-12;
        for (int c = 0; c < 3 && interpolates; ++c) {
            if (support.fixed[c]) {
                constraints_.supported[3 * place.nodes[k] + c] = true;
            }
        }
        if (!interpolates) {
            constraints_.springs.push_back(std::make_unique<DisplacementSpring>(
                place, nullptr, support.fixed, membraneStiffness(support.face)));
        }
    }

    void join(const geometry::BrepTrim& first, const geometry::BrepTrim& second) {
        const double gap =
            std::max(description_.model.tolerance(), 1e-3 * description_.model.size());
        const std::vector<EdgePoint> points =
            edgePoints(patchOf(first), curveOf(first), patchOf(second), curveOf(second), gap);
        // The softer patch decides: springs are stiff enough for it, and no stiffer.
        const bool secondIsSofter = membraneStiffness(second.face) < membraneStiffness(first.face);
        const int softer = secondIsSofter ? second.face : first.face;
        addDisplacementSprings({true, true, true}, softer, points);
        if (description_.bending) {
            addRotationSprings(bendingStiffness(softer), points);
        }
        ++constraints_.nJoints;
    }

    static double elementSize(const EdgePoint& point) {
        return point.other ? std::min(point.side.elementSize(), point.other->elementSize())
                           : point.side.elementSize();
    }

    void addDisplacementSprings(const std::array<bool, 3>& components, int face,
                                const std::vector<EdgePoint>& points) {
        for (const EdgePoint& point : points) {
            constraints_.springs.push_back(std::make_unique<DisplacementSpring>(
                point.side, point.other ? &*point.other : nullptr, components,
                membraneStiffness(face) * point.weight / elementSize(point)));
        }
    }

    void addRotationSprings(double stiffness, const std::vector<EdgePoint>& points) {
        for (const EdgePoint& point : points) {
            constraints_.springs.push_back(
                std::make_unique<RotationSpring>(point.side, point.other ? &*point.other : nullptr,
                                                 stiffness * point.weight / elementSize(point)));
        }
    }

    void fixNodesWithoutBody() {
        std::vector<bool> hasBody(constraints_.fixed.size() / 3, false);
        for (const auto& patch : patches_) {
            for (int j = 0; j < patch->v().nSpans(); ++j) {
                for (int node : patch->nodesOfRow(j)) {
                    hasBody[node] = true;
                }
            }
        }
        for (std::size_t k = 0; k < constraints_.fixed.size(); ++k) {
            constraints_.fixed[k] = constraints_.fixed[k] || !hasBody[k / 3];
        }
    }

    const ShellDescription& description_;
    const ShellPatches& patches_;
    ShellConstraints constraints_;
};

// The six rigid motions (translations, rotations about axes through the centre,
// lengths relative to the size) as displacements of the nodes.
Eigen::MatrixXd rigidMotions(const geometry::Points& nodes) {
    const geometry::Point centre = nodes.colwise().mean();
    const double size = (nodes.colwise().maxCoeff() - nodes.colwise().minCoeff()).norm();
    Eigen::MatrixXd motions(3 * nodes.rows(), 6);
    for (Eigen::Index k = 0; k < nodes.rows(); ++k) {
        const geometry::Point x = (nodes.row(k).transpose() - centre) / size;
        motions.block<3, 3>(3 * k, 0).setIdentity();
        motions.block<3, 3>(3 * k, 3) = -skew(x);
    }
    return motions;
}

// Sum over all that is held of r r^T, r being what the six motions do there.
Eigen::Matrix<double, 6, 6> held(const geometry::Points& nodes,
                                 const ShellConstraints& constraints) {
    const Eigen::MatrixXd motions = rigidMotions(nodes);
    Matrix6d sum = Matrix6d::Zero();
    for (std::size_t k = 0; k < constraints.supported.size(); ++k) {
        if (constraints.supported[k]) {
            sum += motions.row(k).transpose() * motions.row(k);
        }
    }
    for (const auto& spring : constraints.springs) {
        const Eigen::MatrixXd rows = spring->restRows();
        Eigen::MatrixXd own(rows.cols(), 6);
        for (std::size_t k = 0; k < spring->nodes().size(); ++k) {
            own.middleRows<3>(3 * static_cast<Eigen::Index>(k)) =
                motions.middleRows<3>(3 * spring->nodes()[k]);
        }
        const Eigen::MatrixXd effect = rows * own;
        sum += effect.transpose() * effect / (1e-300 + rows.squaredNorm());
    }
    return sum;
}

} // namespace

ShellConstraints shellConstraints(const ShellDescription& description, const ShellPatches& patches,
                                  int nNodes) {
    return Builder(description, patches, nNodes).build();
}

std::vector<std::string> freeRigidMotions(const geometry::Points& nodes,
                                          const ShellConstraints& constraints) {
    constexpr double rounding = 1e-13;
    const Eigen::SelfAdjointEigenSolver<Matrix6d> modes(held(nodes, constraints));
    const double nothing = rounding * std::max(1.0, modes.eigenvalues()[5]);
    const int nFree = static_cast<int>((modes.eigenvalues().array() <= nothing).count());
    static const char* const names[6] = {"translation along x", "translation along y",
                                         "translation along z", "rotation about x",
                                         "rotation about y",    "rotation about z"};
    std::vector<std::string> found;
    const Eigen::MatrixXd space = modes.eigenvectors().leftCols(nFree);
    for (int k = 0; k < 6; ++k) {
        // A motion is free if it lies in the space of free motions.
        if (space.row(k).squaredNorm() > 1 - 1e-6) {
            found.emplace_back(names[k]);
        }
    }
    if (static_cast<int>(found.size()) < nFree) {
        found.emplace_back(found.empty() ? "a rotation" : "another rotation");
    }
    return found;
}

} // namespace tokay::structure
