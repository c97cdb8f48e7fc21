// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/errors.hpp"
#include "exampleShell.hpp"
#include "poissonSquare.hpp"
#include "trimmedDisc.hpp"

#include <Eigen/SVD>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace tokay;
using namespace tokay::structure;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using geometry::LoopKind;
using geometry::TrimmedPatch;
using geometry::TrimmingLoop;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

namespace {

PoissonError solvedPoisson(int degree, int n, const EgmOptions& options = {}) {
    ShellDescription membrane = PoissonSquare().membrane(degree, n);
    membrane.egm = options;
    Shell shell(std::move(membrane));
    return poissonError(shell, solvePoisson(shell).values);
}

EgmOptions egm(EgmForm form, EgmContinuation continuation) {
    EgmOptions options;
    options.form = form;
    options.continuation = continuation;
    return options;
}

// Of the free rows of K E, deflections only.
double condition(const Shell& shell) {
    std::vector<int> free;
    for (int k = 2; k < shell.nUnknowns(); k += 3) {
        if (!shell.fixed()[k]) {
            free.push_back(k);
        }
    }
    const SparseMatrix product = stiffnessAtRest(shell) * *shell.extension();
    const VectorXd values = MatrixXd(product)(free, free).jacobiSvd().singularValues();
    return values[0] / values[values.size() - 1];
}

// A disc of radius 1 in a square patch, its rim held; the load is 1 per area.
ShellDescription loadedDisc(int degree, int n, bool clamped) {
    ShellDescription disc{
        geometry::BrepModel({discFace("disc", -1.13, 2.3, 0, 2 * M_PI, degree, n)}),
        {0.05},
        {1e6, 0.3, 1}};
    disc.strains = Strains::linear;
    disc.edgeMethod = EdgeMethod::egm;
    disc.edgeSupports = {{{{0, 0}}, {true, true, true}, clamped}};
    disc.loads.tractions = {{0, VectorField::constant({0, 0, 1})}};
    return disc;
}

// Largest difference of the deflection from w(r^2), over the largest one.
template <class Deflection>
double largestError(Shell& shell, const Deflection& w) {
    const VectorXd d = solveStatic(shell);
    double error = 0;
    for (const double r : {0.0, 0.3, 0.7, 0.99}) {
        for (const double angle : {0.1, 2.0, 4.5}) {
            const geometry::Parameters at((1.13 + r * std::cos(angle)) / 2.3,
                                          (1.13 + r * std::sin(angle)) / 2.3);
            error = std::max(error, std::abs(shell.displacementAt(0, at, 0, d)[2] - w(r * r)));
        }
    }
    return error / w(0);
}

// A strip of 10 x 1, clamped at x = 0 and bent to a rotation of 60 degrees and more by a
// force along z at its end; its patch may begin before x = 0.
// Source: Sze, Liu & Lo 2004 (cantilever with end shear)
Shell bentStrip(double before) {
    const geometry::NurbsSurface surface = geometry::rectangle({-before, 0, 0}, 10 + before, 1);
    const double start = before / (10 + before);
    const auto corner = [](double xi, double eta) { return geometry::Point(xi, eta, 0); };
    const TrimmingLoop loop(LoopKind::outer, {geometry::line(corner(start, 0), corner(1, 0)),
                                              geometry::line(corner(1, 0), corner(1, 1)),
                                              geometry::line(corner(1, 1), corner(start, 1)),
                                              geometry::line(corner(start, 1), corner(start, 0))});
    ShellDescription strip{
        geometry::BrepModel({{TrimmedPatch(surface, {loop}, "strip").refined(3, 3, 24, 2)}}),
        {0.1},
        {1.2e6, 0, 1}};
    strip.edgeMethod = EdgeMethod::egm;
    strip.edgeSupports = {{{{0, 3}}, {true, true, true}, true}};
    strip.loads.edgeForces = {{{0, 1},
                               {[](const geometry::Point&, double t) -> Vector3d {
                                    return {0, 0, 4 * t};
                                },
                                true}}};
    return Shell(strip);
}

struct Bending {
    double tip;
    int nIterations;
};

Bending bend(double before) {
    Shell shell = bentStrip(before);
    NewtonOptions newton;
    newton.lineSearch = false;
    TimeIntegrator integrator(shell, TimeScheme::quasiStatic(), newton, 0);
    Bending bending{0, 0};
    for (int step = 1; step <= 10; ++step) {
        integrator.beginTimeStep(0.1 * step, 0.1);
        integrator.solve();
        integrator.acceptTimeStep();
        bending.nIterations = std::max(bending.nIterations, integrator.nIterations());
    }
    bending.tip = shell.displacementAt(0, {1, 0.5}, 0, integrator.state().displacement)[2];
    return bending;
}

double flexuralRigidity(const Shell& shell) {
    const double t = shell.description().thickness[0];
    return shell.description().material.planeStressModulus() * t * t * t / 12;
}

} // namespace

TEST(DirichletExtension, poisson_errors_fall_with_the_order_of_the_degree) {
    // Largest: errors with the gradient known exactly (6.9e-4, 4.3e-6 and 4.0e-7 at 30
    // elements a side, from the prototype of the method), by the order at 20 for degree 3,
    // and a fifth more.
    const struct {
        int degree, n;
        double largest;
    } cases[] = {{1, 30, 8.3e-4}, {2, 30, 5.2e-6}, {3, 20, 2.4e-6}};
    for (const auto& [degree, n, largest] : cases) {
        const PoissonError coarse = solvedPoisson(degree, n / 2);
        const PoissonError fine = solvedPoisson(degree, n);
        EXPECT_LT(fine.value, largest) << degree;
        EXPECT_GT(std::log2(coarse.value / fine.value), degree + 0.9) << degree;
        EXPECT_GT(std::log2(coarse.gradient / fine.gradient), degree - 0.1) << degree;
    }
}

TEST(DirichletExtension, without_the_strong_form_the_trace_is_met_too) {
    EgmOptions agnostic;
    agnostic.residual = EgmResidual::none;
    const PoissonError coarse = solvedPoisson(2, 15, agnostic);
    const PoissonError fine = solvedPoisson(2, 30, agnostic);
    // Second order, by the prototype.
    EXPECT_GT(std::log2(coarse.value / fine.value), 1.5);
    EXPECT_LT(fine.value, 1e-4);
}

TEST(DirichletExtension, the_condition_of_the_matrix_does_not_know_where_the_curve_cuts) {
    // The disc's left end from 1e-12 of an element to all of it beyond a knot line.
    constexpr int n = 12;
    double least = 1e300, most = 0;
    for (const double cut : {1e-12, 1e-6, 1e-3, 0.5, 1.0}) {
        PoissonSquare square;
        square.centre[0] = square.radius + (3 + cut) / n;
        const double now = condition(Shell(square.membrane(2, n)));
        least = std::min(least, now);
        most = std::max(most, now);
    }
    EXPECT_LT(most, 2 * least);
}

TEST(DirichletExtension, iterated_and_closed_form_share_their_fixed_point) {
    for (const EgmContinuation continuation : {EgmContinuation::jumps, EgmContinuation::gradient}) {
        ShellDescription membrane = PoissonSquare().membrane(2, 14);
        membrane.egm = egm(EgmForm::closed, continuation);
        Shell closed(membrane);
        membrane.egm.form = EgmForm::iterated;
        membrane.egm.tolerance = 1e-11;
        membrane.egm.maxIterations = 1000;
        Shell iterated(membrane);
        const VectorXd expected = solvePoisson(closed).values;
        const PoissonSolution found = solvePoisson(iterated);
        EXPECT_GT(found.nSolutions, 2);
        // A contraction of 0.9 leaves ten times the last change.
        EXPECT_LT((found.values - expected).norm(), 1e-9 * expected.norm());
    }
}

TEST(DirichletExtension, the_gradient_form_reaches_its_authors_errors) {
    // Smallest of the author's errors that are not made with the exact gradient, by h: 3.0e-4
    // at degree 1 (h = 0.02), 3.7e-5 at degree 2 (elements Q1 and Q2, moving least squares).
    const EgmOptions iterated = egm(EgmForm::iterated, EgmContinuation::gradient);
    EXPECT_LT(solvedPoisson(1, 50, iterated).value, 3.0e-4);
    EXPECT_LT(solvedPoisson(2, 50, iterated).value, 3.652e-5);
}

TEST(DirichletExtension, a_bar_fixed_in_the_middle_of_its_first_element_is_exact) {
    // Camarotti's report, section 5.3.1. Five elements of degree 1 along x, F = 2 per width.
    const TrimmedPatch whole(geometry::rectangle({0, 0, 0}, 5, 1), "bar");
    const auto corner = [](double x, double y) { return geometry::Point(x, y, 0); };
    const TrimmingLoop loop(LoopKind::outer, {geometry::line(corner(0.1, 0), corner(1, 0)),
                                              geometry::line(corner(1, 0), corner(1, 1)),
                                              geometry::line(corner(1, 1), corner(0.1, 1)),
                                              geometry::line(corner(0.1, 1), corner(0.1, 0))});
    ShellDescription bar{
        geometry::BrepModel({{TrimmedPatch(whole.surface(), {loop}, "bar").refined(1, 1, 5, 2)}}),
        {0.5},
        {1e3, 0, 1}};
    bar.bending = false;
    bar.strains = Strains::linear;
    bar.prestress = {1, 1, 0}; // it has no stiffness across its plane else
    bar.edgeMethod = EdgeMethod::egm;
    bar.edgeSupports = {{{{0, 3}}, {true, true, true}}, {{{0, 1}}, {false, false, true}}};
    bar.loads.edgeForces = {{{0, 1}, VectorField::constant({2, 0, 0})}};
    for (const EgmResidual residual :
         {EgmResidual::none, EgmResidual::physical, EgmResidual::whole}) {
        bar.egm.residual = residual;
        Shell shell(bar);
        const VectorXd d = solveStatic(shell);
        for (const double x : {0.5, 1.0, 3.3, 5.0}) {
            // u = F (x - 1/2) / (E A + prestress): linear in x, so in the space.
            const double exact = 2 * (x - 0.5) / (0.5 * (1e3 + 1));
            EXPECT_NEAR(shell.displacementAt(0, {x / 5, 0.3}, 0, d)[0], exact, 1e-13);
        }
    }
}

TEST(DirichletExtension, a_clamped_disc_is_exact_at_degree_4) {
    Shell shell(loadedDisc(4, 14, true));
    const double D = flexuralRigidity(shell);
    // Rounding, times the condition of u_D's own system.
    EXPECT_LT(largestError(shell, [&](double r2) { return (1 - r2) * (1 - r2) / (64 * D); }),
              1e-10);
}

TEST(DirichletExtension, a_disc_free_to_turn_on_its_rim_is_exact_at_degree_4) {
    Shell shell(loadedDisc(4, 14, false));
    const double D = flexuralRigidity(shell);
    EXPECT_LT(
        largestError(shell, [&](double r2) { return (1 - r2) * (5.3 / 1.3 - r2) / (64 * D); }),
        1e-10);
}

TEST(DirichletExtension, a_clamped_disc_bends_and_strains_as_the_exact_solution) {
    for (const int degree : {3, 4}) {
        ShellDescription description = discShell({}, degree, 24, 1);
        description.edgeMethod = EdgeMethod::egm;
        Shell shell(std::move(description));
        const DiscError error = discError(shell, solveStatic(shell));
        // 0.03 % and 0.09 %, 0.001 % and 0.0005 % (benchmarks/dirichlet).
        EXPECT_LT(error.deflection, 2e-3) << degree;
        EXPECT_LT(error.displacement, 2e-5) << degree;
    }
}

TEST(DirichletExtension, a_strip_bent_far_takes_as_many_iterations_as_one_that_ends_at_its_rim) {
    const Bending whole = bend(0);
    const Bending trimmed = bend(0.7);
    EXPECT_LE(std::abs(trimmed.nIterations - whole.nIterations), 1);
    EXPECT_NEAR(whole.tip, 6.698, 5e-3 * 6.698); // published
    EXPECT_NEAR(trimmed.tip, whole.tip, 5e-3 * whole.tip);
}

TEST(DirichletExtension, a_loop_within_an_element_is_an_error) {
    PoissonSquare square;
    square.radius = 0.02;
    EXPECT_THAT([&] { Shell(square.membrane(2, 10)); },
                ThrowsMessage<InputError>(HasSubstr("needs a loop larger than an element")));
}

TEST(DirichletExtension, a_curve_that_no_element_reaches_is_an_error) {
    // A second part of the patch, whose area is the rounding error of an element's.
    const TrimmedPatch whole(geometry::rectangle({0, 0, 0}, 1, 1));
    const geometry::ParameterBox left{{0, 0}, {0.45, 1}},
        speck{{0.81, 0.81}, {0.8100001, 0.8100001}};
    const TrimmedPatch patch(whole.surface(),
                             {TrimmingLoop::around(left), TrimmingLoop::around(speck)}, "plate");
    ShellDescription membrane = PoissonSquare().membrane(2, 10);
    membrane.model = geometry::BrepModel({{patch.refined(2, 2, 10, 10)}});
    EXPECT_THAT([&] { Shell{membrane}; },
                ThrowsMessage<InputError>(AllOf(HasSubstr("curve 4 of patch \"plate\""),
                                                HasSubstr("no element of its patch reaches it"),
                                                HasSubstr("remove the support"))));
}

TEST(DirichletExtension, too_few_uncut_elements_are_an_error) {
    EXPECT_THAT([] { Shell(PoissonSquare().membrane(2, 3)); },
                ThrowsMessage<InputError>(HasSubstr("refine discretisation.elements")));
}

TEST(DirichletExtension, formulas_are_evaluated_once_for_all_solutions_of_a_step) {
    for (const EdgeMethod method : {EdgeMethod::egm, EdgeMethod::nitsche}) {
        int nEvaluations = 0;
        ShellDescription membrane = PoissonSquare().membrane(2, 10);
        membrane.edgeMethod = method;
        for (EdgeSupport& support : membrane.edgeSupports) {
            support.motion = std::make_shared<VectorField>(
                VectorField{[&](const geometry::Point&, double t) -> Vector3d {
                                ++nEvaluations;
                                return {0, 0, t};
                            },
                            true, false});
        }
        Shell shell(membrane);
        TimeIntegrator integrator(shell, TimeScheme::quasiStatic(), {}, 0);
        integrator.beginTimeStep(1, 1);
        const VectorXd first = integrator.solve();
        const int nOfOne = nEvaluations;
        EXPECT_EQ(integrator.solve(), first);
        EXPECT_EQ(nEvaluations, nOfOne);
    }
}

TEST(DirichletExtension, data_on_the_curve_enter_linearly) {
    Shell shell(PoissonSquare().membrane(2, 10));
    const DirichletExtension& extension = *shell.dirichletExtension();
    Eigen::Matrix3Xd values(3, extension.trace().size());
    for (std::size_t k = 0; k < extension.trace().size(); ++k) {
        values.col(static_cast<Eigen::Index>(k)) = extension.trace()[k].on.side.position;
    }
    const VectorXd once = extension.ofTrace(values);
    EXPECT_LT((extension.ofTrace(3 * values) - 3 * once).norm(), 1e-12 * once.norm());
    // With the same linear field inside, it is that of the control points.
    VectorXd positions(shell.nUnknowns());
    for (int k = 0; k < shell.nodes().count(); ++k) {
        positions.segment<3>(3 * k) = shell.nodes().positions.row(k).transpose();
    }
    VectorXd rim = VectorXd::Zero(shell.nUnknowns());
    for (int k = 0; k < shell.nUnknowns(); ++k) {
        const bool isOther = shell.constraints().supported[k];
        rim[k] = isOther ? positions[k] : 0;
    }
    const VectorXd byRim = extension.values(0, rim) - extension.values(0, 0 * rim);
    const VectorXd continued = extension.matrix() * positions + byRim + once;
    for (const int unknown : extension.dependents()) {
        EXPECT_NEAR(continued[unknown], positions[unknown], 1e-9);
    }
}
