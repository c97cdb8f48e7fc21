#include "igaStructure/model/Supports.hpp"

#include <Eigen/QR>

namespace tokay::structure {

std::vector<bool> fixedUnknowns(const geometry::NurbsSurface& surface,
                                const std::vector<Support>& supports) {
    std::vector<bool> fixed(2 * surface.nControlPoints(), false);
    for (const Support& support : supports) {
        for (int k : surface.boundaryCurve(support.edge).controlPoints) {
            for (int c = 0; c < 2; ++c) {
                fixed[2 * k + c] = fixed[2 * k + c] || support.fixed[c];
            }
        }
    }
    return fixed;
}

namespace {

// Values of the rigid motions (columns: along x, along y, rotation about the
// middle) at the fixed unknowns, lengths relative to the body's size.
Eigen::MatrixX3d rigidMotionsAt(const geometry::NurbsSurface& surface,
                                const std::vector<bool>& fixed) {
    const geometry::Points& points = surface.controlPoints();
    const geometry::Point centre = points.colwise().mean();
    const double size = (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm();
    Eigen::MatrixX3d motions(fixed.size(), 3);
    int n = 0;
    for (int k = 0; k < surface.nControlPoints(); ++k) {
        const geometry::Point x = (points.row(k).transpose() - centre) / size;
        if (fixed[2 * k]) {
            motions.row(n++) << 1, 0, -x[1];
        }
        if (fixed[2 * k + 1]) {
            motions.row(n++) << 0, 1, x[0];
        }
    }
    return motions.topRows(n);
}

int rank(const Eigen::MatrixXd& matrix) {
    if (matrix.size() == 0) {
        return 0;
    }
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(matrix);
    qr.setThreshold(1e-10); // entries are of order one, so this only hides rounding
    return static_cast<int>(qr.rank());
}

} // namespace

std::vector<std::string> freeRigidMotions(const geometry::NurbsSurface& surface,
                                          const std::vector<bool>& fixed) {
    return freeRigidMotions(rigidMotionsAt(surface, fixed), 3);
}

std::vector<std::string> freeRigidMotions(const Eigen::MatrixXd& motions, int nMotions) {
    const int nFree = nMotions - rank(motions);
    if (nFree == 0) {
        return {};
    }
    // A translation is free if no unknown along it is fixed.
    const int dimension = motions.cols() == 3 ? 2 : 3;
    std::vector<std::string> names;
    for (int c = 0; c < dimension; ++c) {
        if (motions.col(c).isZero(0)) {
            names.push_back(std::string("translation along ") + "xyz"[c]);
        }
    }
    if (static_cast<int>(names.size()) < nFree) {
        names.push_back("rotation");
    }
    return names;
}

} // namespace tokay::structure
