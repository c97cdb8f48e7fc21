// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/history/FilteredQr.hpp"
#include "coupling/step/StateReader.hpp"
#include "coupling/step/StateWriter.hpp"

#include <Eigen/QR>
#include <gtest/gtest.h>

#include <random>

namespace tokay::coupling {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd orthonormalBasis(const FilteredQr& qr, Eigen::Index nRows) {
    MatrixXd q(nRows, qr.nColumns());
    for (int i = 0; i < qr.nColumns(); ++i) {
        q.col(i) = qr.q()[static_cast<std::size_t>(i)];
    }
    return q;
}

/// Q is orthonormal, R upper triangular, and Q R gives the columns back; to
/// rounding errors of some hundred operations on numbers of size one.
void expectFactors(const FilteredQr& qr, const std::vector<VectorXd>& columns) {
    ASSERT_EQ(qr.nColumns(), static_cast<int>(columns.size()));
    const MatrixXd q = orthonormalBasis(qr, columns.front().size());
    EXPECT_LT((q.transpose() * q - MatrixXd::Identity(q.cols(), q.cols())).norm(), 1e-13);
    EXPECT_EQ(MatrixXd(qr.r().triangularView<Eigen::StrictlyLower>()).norm(), 0);
    const MatrixXd product = q * qr.r();
    for (int i = 0; i < qr.nColumns(); ++i) {
        EXPECT_LT((product.col(i) - columns[static_cast<std::size_t>(i)]).norm(), 1e-13);
    }
}

void erase(std::vector<VectorXd>& columns, const std::vector<int>& dropped) {
    for (const int i : dropped) {
        columns.erase(columns.begin() + i);
    }
}

TEST(FilteredQr, factors_stay_exact_as_columns_come_and_go) {
    std::srand(7);
    FilteredQr qr({QrFilter::qr2, 0});
    std::vector<VectorXd> columns;
    std::size_t largest = 0;
    for (int i = 0; i < 200; ++i) {
        const VectorXd column = VectorXd::Random(12);
        columns.insert(columns.begin(), column);
        erase(columns, qr.prepend(column));
        largest = std::max(largest, columns.size());
        if (i % 3 == 0) {
            const int victim = (i * 5) % qr.nColumns();
            qr.remove(victim);
            columns.erase(columns.begin() + victim);
        }
        if (!columns.empty()) {
            expectFactors(qr, columns);
        }
    }
    EXPECT_EQ(largest, 12u); // never more than rows
}

TEST(FilteredQr, solves_the_least_squares_problem) {
    std::srand(8);
    FilteredQr qr({QrFilter::qr2, 1e-3});
    MatrixXd V(9, 4);
    for (int i = 3; i >= 0; --i) {
        V.col(i) = VectorXd::Random(9);
        ASSERT_TRUE(qr.prepend(V.col(i)).empty());
    }
    const VectorXd rightHandSide = VectorXd::Random(9);
    const VectorXd expected = V.colPivHouseholderQr().solve(rightHandSide);
    EXPECT_LT((qr.solve(rightHandSide) - expected).norm(), 1e-13 * expected.norm());
}

TEST(FilteredQr, drops_columns_of_zeros) {
    for (const QrFilter filter : {QrFilter::qr1, QrFilter::qr2}) {
        FilteredQr qr({filter, 0});
        EXPECT_EQ(qr.prepend(VectorXd::Zero(3)), std::vector<int>{0});
        EXPECT_TRUE(qr.prepend(VectorXd::Unit(3, 0)).empty());
        EXPECT_EQ(qr.prepend(VectorXd::Zero(3)), std::vector<int>{0});
        expectFactors(qr, {VectorXd::Unit(3, 0)});
    }
}

TEST(FilteredQr, drops_the_older_of_two_dependent_columns) {
    for (const QrFilter filter : {QrFilter::qr1, QrFilter::qr2}) {
        FilteredQr qr({filter, 0});
        const VectorXd column = VectorXd::LinSpaced(5, 1, 2);
        qr.prepend(column);
        qr.prepend(VectorXd::Unit(5, 2));
        EXPECT_EQ(qr.prepend(3 * column), std::vector<int>{2});
        expectFactors(qr, {3 * column, VectorXd::Unit(5, 2)});
    }
}

TEST(FilteredQr, keeps_the_newest_of_more_columns_than_rows) {
    std::srand(9);
    FilteredQr qr({QrFilter::qr2, 0});
    std::vector<VectorXd> columns;
    for (int i = 0; i < 10; ++i) {
        columns.insert(columns.begin(), VectorXd::Random(3));
        erase(columns, qr.prepend(columns.front()));
        expectFactors(qr, columns);
    }
    EXPECT_EQ(qr.nColumns(), 3);
}

TEST(FilteredQr, qr2_judges_a_column_by_its_own_length_and_qr1_by_the_largest) {
    // Small but independent: 1e-4 of the other column, at right angles to it.
    const VectorXd large = VectorXd::Unit(4, 0);
    const VectorXd small = 1e-4 * VectorXd::Unit(4, 1);
    FilteredQr qr2({QrFilter::qr2, 0.01});
    qr2.prepend(small);
    EXPECT_TRUE(qr2.prepend(large).empty());
    FilteredQr qr1({QrFilter::qr1, 0.01});
    qr1.prepend(small);
    EXPECT_EQ(qr1.prepend(large), std::vector<int>{1});
}

TEST(FilteredQr, limit_is_the_sine_of_the_angle_to_the_newer_columns) {
    const auto dropsAtAngle = [](double sine) {
        FilteredQr qr({QrFilter::qr2, 0.01});
        VectorXd older(2);
        older << std::sqrt(1 - sine * sine), sine;
        qr.prepend(older);
        return !qr.prepend(VectorXd::Unit(2, 0)).empty();
    };
    EXPECT_TRUE(dropsAtAngle(0.0099));
    EXPECT_FALSE(dropsAtAngle(0.0101));
}

TEST(FilteredQr, qr1_compares_with_the_norm_of_all_columns) {
    const auto drops = [](double length) {
        FilteredQr qr({QrFilter::qr1, 0.01});
        qr.prepend(length * VectorXd::Unit(4, 0));
        qr.prepend(VectorXd::Unit(4, 1));
        return !qr.prepend(VectorXd::Unit(4, 2)).empty();
    };
    EXPECT_TRUE(drops(0.0140)); // 0.01 times the root of two, and no more than rounding
    EXPECT_FALSE(drops(0.0142));
}

TEST(FilteredQr, without_a_limit_drops_only_what_is_rounding_error) {
    FilteredQr qr({QrFilter::qr2, 0});
    VectorXd older = VectorXd::Unit(3, 0);
    older[1] = 1e-9;
    qr.prepend(older);
    EXPECT_TRUE(qr.prepend(VectorXd::Unit(3, 0)).empty());
}

TEST(FilteredQr, filters_bear_the_names_of_their_rules) {
    // A small column at right angles: qr1 drops it, qr2 does not.
    for (const bool isFirst : {true, false}) {
        FilterOptions options;
        const Entry* filter = FilterOptions::schema().entriesOf(&options).front();
        ASSERT_EQ(filter->name, "filter");
        const std::size_t k = isFirst ? 0 : 1;
        ASSERT_EQ(filter->alternatives.at(k).name, isFirst ? "qr1" : "qr2");
        std::get<ChoiceSlot>(filter->slot(&options)).set({k});
        FilteredQr qr(options);
        qr.prepend(1e-4 * VectorXd::Unit(4, 1));
        EXPECT_EQ(qr.prepend(VectorXd::Unit(4, 0)).empty(), !isFirst);
    }
}

TEST(FilteredQr, restored_one_replaces_what_was_there) {
    FilteredQr saved({QrFilter::qr2, 0});
    saved.prepend(VectorXd::Unit(3, 0) + VectorXd::Unit(3, 1));
    std::vector<std::uint8_t> bytes;
    StateWriter written(bytes);
    saved.save(written);
    FilteredQr qr({QrFilter::qr2, 0});
    qr.prepend(VectorXd::Unit(3, 2));
    qr.prepend(VectorXd::Unit(3, 1));
    StateReader state(bytes);
    qr.restore(state);
    expectFactors(qr, {VectorXd::Unit(3, 0) + VectorXd::Unit(3, 1)});
}

TEST(FilteredQr, saved_factor_that_is_not_square_is_refused) {
    std::vector<std::uint8_t> bytes;
    StateWriter written(bytes);
    written.matrix(MatrixXd::Zero(3, 2));
    written.matrix(VectorXd::Zero(3));
    written.matrix(VectorXd::Zero(3));
    StateReader state(bytes);
    FilteredQr qr({QrFilter::qr2, 0});
    EXPECT_THROW(qr.restore(state), channel::PeerError);
}

} // namespace
} // namespace tokay::coupling
