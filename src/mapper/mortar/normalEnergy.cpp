// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/mortar/normalEnergy.hpp"

namespace tokay::mapper {

SparseMatrix normalEnergy(const CurveInterface& interface) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < interface.nCurves(); ++i) {
        for (const NormalSlope& at : interface.curve(i).normalSlopes()) {
            for (std::size_t k = 0; k < at.values.size(); ++k) {
                for (std::size_t l = 0; l < at.values.size(); ++l) {
                    entries.emplace_back(at.values[k], at.values[l],
                                         at.measure * at.weights[k] * at.weights[l]);
                }
            }
        }
    }
    SparseMatrix matrix(interface.nValues(), interface.nValues());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

} // namespace tokay::mapper
