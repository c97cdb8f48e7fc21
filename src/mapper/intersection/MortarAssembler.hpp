// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/Discretisation.hpp"
#include "mapper/RowSparseMatrix.hpp"
#include "mapper/intersection/SparseSum.hpp"

namespace tokay::mapper {

/// Test functions of the mortar condition: the destination's own, or functions
/// biorthogonal to them element by element, for which the mass matrix is diagonal.
enum class MortarBasis { standard, dual };

/// Sums M_DD = integral of N_D N_D^T and M_DO = integral of N_D N_O^T over the
/// intersection of the two sides, in groups of quadrature points: all points of a
/// destination element, or, when the source's faces lead, all of a source face.
class MortarAssembler {
  public:
    /// @param nElements  of the destination, if a group can hold points of several
    /// of them and an element occurs in several groups; else 0. There is no dual
    /// basis then, as no group has a whole element.
    MortarAssembler(int nTo, int nFrom, MortarBasis basis, int nElements = 0);

    /// A quadrature point in an element of the destination, which determines the
    /// list of its functions.
    void add(double weight, const Functions& to, const Functions& from, int element = 0);

    /// Integrals over a common piece of a triangle of each side: of products of the destination's
    /// barycentric coordinates with each other, and with the source's.
    void add(const CornerFunctions& to, const CornerFunctions& from, const Eigen::Matrix3d& mass,
             const Eigen::Matrix3d& cross);

    /// A place with no partner: its functions exist, but get nothing from there.
    void addUnmatched(const std::vector<int>& toValues);
    void addUnmatched(int toValue) { isOnInterface_[toValue] = 1; }

    /// Source of the dual basis: Wohlmuth, SIAM J. Numer. Anal. 38, 2000
    void endGroup();

    /// The sums, which the assembler then no longer has.
    RowSparseMatrix takeMass();
    RowSparseMatrix takeCross();
    /// Values on the destination's interface that have no mass.
    int nUncovered(const RowSparseMatrix& massMatrix) const;

  private:
    struct ElementMass {
        std::vector<int> values;
        Eigen::MatrixXd matrix;
    };
    /// An element's part in the current group.
    struct Part {
        int element;
        std::vector<int> toValues, fromValues;
        Eigen::MatrixXd mass, cross; ///< cross may have columns to spare

        int column(int fromValue);
        void add(double weight, const Functions& to, const Functions& from);
        void makeDual();
    };
    Part& partOf(int element, const std::vector<int>& toValues);
    void close(const Part& part);
    void addCross(const Part& part);

    int nTo_;
    MortarBasis basis_;
    bool sourceLeads_;
    /// Masses of elements that occur in several groups.
    std::vector<ElementMass> elements_;
    /// The cross matrix's is its transpose where the source leads: rows are then those of the
    /// leading side, which few groups have, and short.
    SparseSum mass_, cross_;
    std::vector<char> isOnInterface_;

    /// The first nParts_ belong to the current group; the others are memory to reuse.
    std::vector<Part> parts_;
    std::size_t nParts_ = 0;
    /// Integrals of the destination's functions times barycentric coordinates.
    Eigen::Matrix<double, Eigen::Dynamic, 3> onTo_;
};

} // namespace tokay::mapper
