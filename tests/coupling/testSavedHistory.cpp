// SPDX-License-Identifier: GPL-3.0-or-later
#include "GivenSolution.hpp"
#include "LinearResponse.hpp"
#include "coupling/fixedPoint/IqnIls.hpp"
#include "coupling/step/StateReader.hpp"
#include "coupling/step/StateWriter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace tokay::coupling {
namespace {

using Eigen::VectorXd;

constexpr int n = 6;
constexpr double deltaT = 0.1;
constexpr double tolerance = 1e-6;

/// Another load in each step; components in the order of `numbers`.
LinearResponse response(int step, const std::vector<int>& numbers) {
    VectorXd ratios(n);
    ratios << 4, 2, 1, 0.5, 0.2, 0.1;
    LinearResponse result = addedMass(ratios);
    result.b *= std::sin(0.7 * step);
    return {result.A(numbers, numbers), result.b(numbers)};
}

std::vector<int> inOrder() {
    std::vector<int> numbers(n);
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
}

/// @return  x of each exchange of the steps from `first` to `last`
std::vector<VectorXd> runSteps(CouplingMethod& method, int first, int last,
                               const std::vector<int>& numbers) {
    std::vector<VectorXd> xs;
    for (int step = first; step <= last; ++step) {
        const LinearResponse structure = response(step, numbers);
        xs.push_back(method.predict(step % 2 == 0 ? deltaT : 0.5 * deltaT));
        for (int exchange = 0; exchange < 100; ++exchange) {
            const CouplingIteration iteration = method.iterate(structure(xs.back()), 0);
            if (iteration.converged) {
                break;
            }
            xs.push_back(iteration.x);
        }
        method.accept(structure(xs.back()));
    }
    return xs;
}

std::vector<std::uint8_t> savedAfter(int nSteps, const CouplingOptions& options) {
    GivenSolution driver(options, tolerance, VectorXd::Zero(n));
    runSteps(*driver, 1, nSteps, inOrder());
    std::vector<std::uint8_t> bytes;
    StateWriter state(bytes);
    driver->save(state);
    return bytes;
}

CouplingOptions optionsOf(const std::string& acceleration, Extrapolation predictor) {
    CouplingOptions options;
    options.acceleration.type = acceleration;
    options.acceleration.of<IqnIls::Options>().reusedTimeSteps = 3;
    options.predictor = predictor;
    return options;
}

/// Those of the program that iterate without the structure's tangent, and converge here.
std::vector<std::string> iteratingAccelerators() {
    std::vector<std::string> names;
    for (const CouplingMethodType& type : couplingMethods()) {
        if (type.name != "explicit" && type.name != "constant" && type.name != "block") {
            names.push_back(type.name);
        }
    }
    return names;
}

class SavedHistory : public testing::TestWithParam<std::string> {
  protected:
    CouplingOptions options = optionsOf(GetParam(), Extrapolation::quadratic);
};

TEST_P(SavedHistory, continues_bit_by_bit) {
    GivenSolution whole(options, tolerance, VectorXd::Zero(n));
    runSteps(*whole, 1, 5, inOrder());
    const std::vector<VectorXd> expected = runSteps(*whole, 6, 10, inOrder());

    const std::vector<std::uint8_t> bytes = savedAfter(5, options);
    StateReader state(bytes);
    GivenSolution continued(options, tolerance, VectorXd::Zero(n));
    continued->restore(state);
    EXPECT_EQ(state.remaining(), 0u);
    EXPECT_EQ(runSteps(*continued, 6, 10, inOrder()), expected);
}

TEST_P(SavedHistory, continues_on_an_interface_that_is_numbered_anew) {
    const std::vector<int> numbers = {3, 5, 0, 1, 4, 2};
    GivenSolution whole(options, tolerance, VectorXd::Zero(n));
    runSteps(*whole, 1, 5, inOrder());
    const std::vector<VectorXd> expected = runSteps(*whole, 6, 8, inOrder());

    const std::vector<std::uint8_t> bytes = savedAfter(5, options);
    StateReader state(bytes);
    state.renumberInterface(numbers);
    GivenSolution continued(options, tolerance, VectorXd::Zero(n));
    continued->restore(state);
    const std::vector<VectorXd> actual = runSteps(*continued, 6, 8, numbers);
    ASSERT_EQ(actual.size(), expected.size());
    for (std::size_t k = 0; k < actual.size(); ++k) {
        // Sums in another order; differences of size 1e-6 are divided by each other
        EXPECT_LT((actual[k] - VectorXd(expected[k](numbers))).norm(), 1e-8 * expected[k].norm());
    }
}

TEST_P(SavedHistory, that_is_cut_off_is_refused) {
    std::vector<std::uint8_t> bytes = savedAfter(5, options);
    bytes.pop_back();
    StateReader state(bytes);
    GivenSolution driver(options, tolerance, VectorXd::Zero(n));
    EXPECT_THROW(driver->restore(state), channel::PeerError);
}

INSTANTIATE_TEST_SUITE_P(Accelerations, SavedHistory, testing::ValuesIn(iteratingAccelerators()),
                         [](const auto& of) { return of.param; });

TEST(SavedHistory, is_worth_its_exchanges) {
    const CouplingOptions options = optionsOf("iqnIls", Extrapolation::quadratic);
    const std::vector<std::uint8_t> bytes = savedAfter(5, options);
    StateReader state(bytes);
    GivenSolution continued(options, tolerance, VectorXd::Zero(n));
    continued->restore(state);
    GivenSolution anew(options, tolerance, VectorXd::Zero(n));
    EXPECT_LT(runSteps(*continued, 6, 6, inOrder()).size(),
              runSteps(*anew, 6, 6, inOrder()).size());
}

TEST(SavedHistory, of_another_acceleration_leaves_the_predictor) {
    const std::vector<std::uint8_t> bytes =
        savedAfter(5, optionsOf("iqnIls", Extrapolation::linear));
    StateReader state(bytes);
    GivenSolution whole(optionsOf("iqnIls", Extrapolation::linear), tolerance, VectorXd::Zero(n));
    runSteps(*whole, 1, 5, inOrder());
    GivenSolution other(optionsOf("mvqn", Extrapolation::linear), tolerance, VectorXd::Zero(n));
    other->restore(state);
    EXPECT_EQ(other->predict(deltaT), whole->predict(deltaT));
}

} // namespace
} // namespace tokay::coupling
