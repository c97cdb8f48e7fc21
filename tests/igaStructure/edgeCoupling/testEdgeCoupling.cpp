// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/errors.hpp"
#include "coupling/couplingMethods.hpp"
#include "geometry/brep/cadJson.hpp"
#include "geometry/primitives/primitives.hpp"
#include "igaStructure/ChildProgram.hpp"
#include "igaStructure/case/readCase.hpp"
#include "igaStructure/edgeCoupling/runCouple.hpp"
#include "igaStructure/run/runAlone.hpp"
#include "igaStructure/tableRows.hpp"
#include "temporaryDirectory.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <mutex>
#include <tuple>

using namespace tokay;
using namespace tokay::structure;
using testing::AllOf;
using testing::HasSubstr;

namespace {

/// A plate [from, to] x [0, 1] in plane stress.
struct Plate {
    double from, to;
    int degree = 2;
    std::array<int, 2> elements = {2, 2};
    double youngsModulus = 1000;
    double poissonsRatio = 0;
    double thickness = 1;
    std::string strains = "linear";
    std::string supports = "[]";
    std::string loads = "[]";
    std::string time = "{scheme: static, step: 1, end: 1}";
    std::string coupling = {};
    std::vector<double> watched = {}; ///< x of points at half height

    std::string text() const {
        std::string text = fmt::format(
            "geometry:\n  rectangle: {{origin: [{}, 0], size: [{}, 1]}}\n"
            "discretisation: {{degree: [{}, {}], elements: [{}, {}]}}\n"
            "model: {{kinematics: planeStress, strains: {}, thickness: {}}}\n"
            "material: {{type: StVenantKirchhoff, youngsModulus: {}, poissonsRatio: {}, density: "
            "1}}\n"
            "supports: {}\nloads: {}\ntime: {}\n",
            from, to - from, degree, degree, elements[0], elements[1], strains, thickness,
            youngsModulus, poissonsRatio, supports, loads, time);
        if (!coupling.empty()) {
            text += "coupling: " + coupling + "\n";
        }
        std::vector<std::string> points;
        for (const double x : watched) {
            points.push_back(fmt::format("{{name: x{:.0f}, at: [{}, 0.5]}}", 100 * x, x));
        }
        return text +
               fmt::format("output: {{interval: 0, watchPoints: [{}]}}\n", fmt::join(points, ", "));
    }

    std::string write(const TemporaryDirectory& directory, const std::string& name) const {
        return directory.write(name + ".yaml", text());
    }
};

const std::string clamped = "[{edge: left, fix: [x, y]}]";
const std::string pulled = "[{edge: right, traction: [1, 0]}]";

Plate leftPlate(const std::string& acceleration = "iqnIls") {
    Plate plate{0, 2};
    plate.supports = clamped;
    plate.coupling =
        fmt::format("{{interface: [right], acceleration: {{type: {}}}}}", acceleration);
    plate.watched = {0.5, 1, 2};
    return plate;
}

Plate rightPlate(const std::string& more = "") {
    Plate plate{2, 4};
    plate.elements = {1, 1};
    plate.loads = pulled;
    plate.coupling = "{interface: [left], side: dirichlet" + more + "}";
    plate.watched = {2, 3, 4};
    return plate;
}

/// Tables of the watch points of both, and the log.
struct CoupledResult {
    std::vector<std::vector<double>> left, right;
    std::string log;
};

template <class Half>
CoupledResult couple(const Half& left, const Half& right) {
    const TemporaryDirectory directory;
    CoupleOptions options;
    options.caseFiles = {left.write(directory, "left"), right.write(directory, "right")};
    CoupledResult result;
    std::mutex mutex;
    runCouple(options, [&](const std::string& text) {
        const std::lock_guard<std::mutex> lock(mutex);
        result.log += text + "\n";
    });
    result.left = tableRows(directory.read("postProcessing/left/0/watchPoints.dat"));
    result.right = tableRows(directory.read("postProcessing/right/0/watchPoints.dat"));
    return result;
}

std::vector<std::vector<double>> alone(const Plate& whole) {
    const TemporaryDirectory directory;
    runAlone(readCase(whole.write(directory, "whole")), [](const std::string&) {});
    return tableRows(directory.read("postProcessing/whole/0/watchPoints.dat"));
}

std::string failureOf(const Plate& left, const Plate& right) {
    try {
        couple(left, right);
    } catch (const std::exception& error) {
        return error.what();
    }
    return "no failure";
}

// Columns of a watch table: time, then x and y of each point.
double ux(const std::vector<std::vector<double>>& table, std::size_t point) {
    return table.back()[1 + 2 * point];
}

} // namespace

TEST(EdgeCoupling, every_method_gives_the_bars_linear_displacement) {
    for (const coupling::CouplingMethodType& type : coupling::couplingMethods()) {
        if (type.name == "explicit") {
            continue; // one exchange
        }
        const CoupledResult result = couple(leftPlate(type.name), rightPlate());
        for (std::size_t k = 0; k < 3; ++k) {
            const double x = leftPlate().watched[k];
            // the tolerance of the coupling, relative to displacements at its edges
            EXPECT_NEAR(ux(result.left, k), x / 1000, 1e-8 * 0.004) << type.name;
            EXPECT_NEAR(ux(result.right, k), (2 + static_cast<double>(k)) / 1000, 1e-8 * 0.004)
                << type.name;
        }
    }
}

TEST(EdgeCoupling, the_edges_own_elements_do_not_matter) {
    Plate right = rightPlate();
    right.degree = 1; // finite elements
    right.elements = {4, 7};
    for (const std::array<int, 2> elements : {std::array{2, 2}, std::array{3, 5}}) {
        Plate left = leftPlate();
        left.elements = elements;
        EXPECT_NEAR(ux(couple(left, right).right, 2), 0.004, 1e-8 * 0.004);
    }
    Plate elements = leftPlate();
    elements.degree = 1;
    elements.elements = {3, 5};
    EXPECT_NEAR(ux(couple(elements, rightPlate()).right, 2), 0.004, 1e-8 * 0.004);
}

namespace {

/// Two halves of a cantilever and the whole one, in one basis: bilinear elements.
struct Halves {
    Plate whole{0, 4}, left = leftPlate(), right = rightPlate();

    explicit Halves(const std::string& strains, const std::string& time,
                    const std::string& traction) {
        left.elements = right.elements = {6, 3};
        whole.elements = {12, 3};
        whole.supports = left.supports;
        whole.loads = right.loads = "[{edge: right, traction: " + traction + "}]";
        whole.watched = right.watched;
        right.coupling = "{interface: [left], side: dirichlet, tolerance: 1e-10}";
        for (Plate* plate : {&left, &right, &whole}) {
            plate->degree = 1;
            plate->poissonsRatio = 0.3;
            plate->strains = strains;
            plate->time = time;
        }
    }
};

void expectSame(const std::vector<std::vector<double>>& table,
                const std::vector<std::vector<double>>& expected, double tolerance) {
    ASSERT_EQ(table.size(), expected.size());
    double largest = 0;
    for (const std::vector<double>& row : expected) {
        for (std::size_t k = 1; k < row.size(); ++k) {
            largest = std::max(largest, std::abs(row[k]));
        }
    }
    EXPECT_GT(largest, 0);
    for (std::size_t row = 0; row < table.size(); ++row) {
        for (std::size_t k = 0; k < table[row].size(); ++k) {
            EXPECT_NEAR(table[row][k], expected[row][k], tolerance * largest) << row << ", " << k;
        }
    }
}

} // namespace

TEST(EdgeCoupling, two_halves_of_a_cantilever_move_as_the_whole_one) {
    const std::string dynamic = "{step: 0.02, end: 0.4}", pull = "[\"sin(9*t)\", \"t\"]";
    const std::string newmark = "{scheme: newmark, step: 0.02, end: 0.4}";
    const std::string still = "{scheme: static, step: 1, end: 1}";
    for (const Halves& halves :
         {Halves("linear", dynamic, pull), Halves("linear", newmark, pull),
          Halves("nonlinear", dynamic, pull), Halves("linear", still, "[1, 0.5]"),
          Halves("nonlinear", still, "[1, 5]")}) {
        // Errors of the coupling, 1e-10 a step, and what Newton's method leaves.
        expectSame(couple(halves.left, halves.right).right, alone(halves.whole), 1e-7);
    }
}

TEST(EdgeCoupling, methods_agree_in_time) {
    const Halves halves("linear", "{step: 0.02, end: 0.2}", "[\"sin(9*t)\", \"t\"]");
    const auto expected = alone(halves.whole);
    for (const char* method : {"aitken", "mvqn", "block"}) {
        Plate left = halves.left;
        left.coupling = leftPlate(method).coupling;
        Plate right = halves.right;
        right.coupling = "{interface: [left], side: dirichlet, tolerance: 1e-10, maxIterations: "
                         "200}";
        expectSame(couple(left, right).right, expected, 1e-7);
    }
}

namespace {

/// A half of the plate as a flat membrane or a plane solid; trimmed, its surface is two elements
/// long.
struct TrimmableHalf {
    bool isLeft;
    double first = 0, last = 0, trim = 0; ///< of the surface along x, and where it is trimmed
    bool isPlane = false;
    double poissonsRatio = 0;
    std::string time = "{scheme: static, step: 1, end: 1}";
    std::array<std::string, 3> force = {"1", "0", "0"}; ///< a plane solid takes two components
    int interval = 0;                                   ///< time steps between results
    std::string coupling = "";

    bool isTrimmed() const { return last > first; }

    std::string write(const TemporaryDirectory& directory, const std::string& name) const {
        std::string geometry =
            fmt::format("rectangle: {{origin: [{}, 0], size: [2, 1]}}", isLeft ? 0 : 2);
        if (isTrimmed()) {
            geometry = "cadJson: " + name + ".cad.json";
            writeModel(directory.file(name + ".cad.json"));
        }
        const std::string inner =
            isTrimmed() ? (isLeft ? "plate.1" : "plate.3") : (isLeft ? "right" : "left");
        return directory.write(
            name + ".yaml",
            fmt::format(
                "geometry: {{{}}}\n"
                "discretisation: {{degree: [2, 2], elements: [{}, 2]}}\n"
                "model: {{kinematics: {}, strains: linear, thickness: 1}}\n"
                "material: {{type: StVenantKirchhoff, youngsModulus: 1000, poissonsRatio: {}, "
                "density: 1}}\n"
                "supports: {}\nloads: {}\ntime: {}\n"
                "coupling: {{interface: [{}], {}}}\n"
                "output: {{interval: {}, watchPoints: [{{name: a, at: [{}, 0.5{}]}}, {{name: b, "
                "at: [{}, 0.3{}]}}]}}\n",
                geometry, isTrimmed() ? 2 : 1,
                isPlane ? "planeStress" : "membrane, prestress: 1e-9", poissonsRatio, supports(),
                loads(), time, inner,
                isLeft ? "acceleration: {type: iqnIls}" : "side: dirichlet" + coupling, interval,
                isLeft ? 0.5 : 2.5, isPlane ? "" : ", 0", isLeft ? 1.5 : 4, isPlane ? "" : ", 0"));
    }

  private:
    std::string outer() const {
        return isTrimmed() ? (isLeft ? "brepEdge: plate.3" : "brepEdge: plate.1")
                           : (isLeft ? "edge: left" : "edge: right");
    }

    // A membrane is kept in its plane.
    std::string supports() const {
        if (isPlane) {
            return isLeft ? fmt::format("[{{{}, fix: [x, y]}}]", outer()) : "[]";
        }
        return isLeft ? fmt::format("[{{{}, fix: [x, y, z]}}, {{point: [1, 0.5, 0], fix: [z]}}]",
                                    outer())
                      : "[{point: [4, 0, 0], fix: [z]}]";
    }

    std::string loads() const {
        if (isLeft) {
            return "[]";
        }
        return isPlane ? fmt::format("[{{{}, traction: [\"{}\", \"{}\"]}}]", outer(), force[0],
                                     force[1])
                       : fmt::format("[{{{}, lineForce: [\"{}\", \"{}\", \"{}\"]}}]", outer(),
                                     force[0], force[1], force[2]);
    }

    void writeModel(const std::string& path) const {
        using namespace geometry;
        const double cut = (trim - first) / (last - first);
        const ParameterBox kept =
            isLeft ? ParameterBox{{0, 0}, {cut, 1}} : ParameterBox{{cut, 0}, {1, 1}};
        std::vector<BrepFace> faces = {{TrimmedPatch(rectangle(Point(first, 0, 0), last - first, 1),
                                                     {TrimmingLoop::around(kept)}, "plate")}};
        std::vector<BrepEdge> edges = coincidentEdges(faces, 1e-9);
        writeCadJson(BrepModel(std::move(faces), std::move(edges)), path);
    }
};

} // namespace

TEST(EdgeCoupling, trimmed_edges_give_the_bars_linear_displacement_wherever_the_line_lies) {
    for (const auto& [first, last, trim, rank] :
         {std::tuple(0.0, 4.0, 2.0, "8 x 8, rank 4"), std::tuple(0.0, 4.0, 2 - 1e-12, "rank 4"),
          std::tuple(0.0, 4.0, 2 + 1e-12, "rank 4"), std::tuple(-0.6, 4.0, 2.0, "12 x 12, rank 4"),
          std::tuple(0.0, 0.0, 0.0, "rank 4")}) {
        for (const bool isPlane : {false, true}) {
            const TrimmableHalf left{true, 0, last > first ? 4 - first : 0, trim, isPlane};
            const CoupledResult result =
                couple(left, TrimmableHalf{false, first, last, trim, isPlane});
            EXPECT_THAT(result.log, HasSubstr(rank));
            // A membrane's prestress, 1e-9 of the load, is not in balance with the free sides.
            const std::size_t b = isPlane ? 3 : 4;
            EXPECT_NEAR(result.left.back()[1], 0.0005, 1e-7 * 0.004) << trim;
            EXPECT_NEAR(result.left.back()[b], 0.0015, 1e-7 * 0.004) << trim;
            EXPECT_NEAR(result.right.back()[1], 0.0025, 1e-7 * 0.004) << trim;
            EXPECT_NEAR(result.right.back()[b], 0.004, 1e-7 * 0.004) << trim;
        }
    }
}

TEST(EdgeCoupling, halves_trimmed_on_a_knot_line_move_as_untrimmed_ones_with_the_same_functions) {
    for (const bool isPlane : {false, true}) {
        TrimmableHalf left{true, 0, 4, 2, isPlane}, right{false, 0, 4, 2, isPlane};
        for (TrimmableHalf* half : {&left, &right}) {
            half->poissonsRatio = 0.3;
            half->time = "{step: 0.02, end: 0.2}";
            half->force = {"sin(9*t)", "t", "t*t"};
            half->coupling = ", tolerance: 1e-10";
        }
        TrimmableHalf wholeLeft = left, wholeRight = right;
        wholeLeft.last = wholeRight.last = 0;
        const CoupledResult trimmed = couple(left, right);
        const CoupledResult untrimmed = couple(wholeLeft, wholeRight);
        expectSame(trimmed.left, untrimmed.left, 1e-7);
        expectSame(trimmed.right, untrimmed.right, 1e-7);
    }
}

TEST(EdgeCoupling, a_restarted_run_goes_on_digit_by_digit) {
    TrimmableHalf left{true, 0, 4, 2}, right{false, 0, 4, 2};
    for (TrimmableHalf* half : {&left, &right}) {
        half->poissonsRatio = 0.3;
        half->time = "{step: 0.02, end: 0.2}";
        half->force = {"sin(9*t)", "t", "t*t"};
        half->interval = 5;
    }
    const TemporaryDirectory directory;
    CoupleOptions options;
    options.caseFiles = {left.write(directory, "left"), right.write(directory, "right")};
    const Report silent = [](const std::string&) {};
    runCouple(options, silent);
    const auto endStates = [&] {
        return std::array<std::string, 2>{directory.read("results/states/left_0.2.state"),
                                          directory.read("results/states/right_0.2.state")};
    };
    const std::array<std::string, 2> wholeStates = endStates();
    options.restartTime = 0.1;
    runCouple(options, silent);
    EXPECT_TRUE(endStates() == wholeStates); // all bits, of which tables show twelve digits
    for (const std::string side : {"left", "right"}) {
        const std::string tables = "postProcessing/" + side;
        auto whole = tableRows(directory.read(tables + "/0/watchPoints.dat"));
        whole.erase(whole.begin(), whole.begin() + 5);
        EXPECT_EQ(tableRows(directory.read(tables + "/0.1/watchPoints.dat")), whole);
    }
    options.restartTime = 0.13;
    EXPECT_THAT([&] { runCouple(options, silent); },
                testing::ThrowsMessage<InputError>(HasSubstr("it has: 0.1 s, 0.2 s")));
    options.restartTime = 0.2;
    EXPECT_THAT([&] { runCouple(options, silent); },
                testing::ThrowsMessage<InputError>(HasSubstr("the run ends there")));
}

TEST(EdgeCoupling, force_of_a_thick_plate_loads_a_thin_one_whole) {
    Plate left = leftPlate();
    left.youngsModulus = 2000;
    Plate right = rightPlate();
    right.thickness = 2;
    // 1 Pa on 2 m of thickness is 2 N on E A = 2000 N, then 2 N on 2000 N
    const auto table = couple(left, right).right;
    EXPECT_NEAR(ux(table, 0), 0.002, 1e-9);
    EXPECT_NEAR(ux(table, 2), 0.004, 1e-9);
}

TEST(EdgeCoupling, mistakes_are_named) {
    Plate dirichlet = leftPlate();
    dirichlet.coupling = "{interface: [right], side: dirichlet}";
    EXPECT_THAT(failureOf(dirichlet, rightPlate()),
                AllOf(HasSubstr("right.yaml:"), HasSubstr("both structures are the dirichlet")));
    Plate neumann = rightPlate();
    neumann.coupling = "{interface: [left]}";
    EXPECT_THAT(failureOf(leftPlate(), neumann), HasSubstr("both structures are the neumann side"));
    Plate apart = rightPlate();
    apart.from = 2.1;
    EXPECT_THAT(failureOf(leftPlate(), apart),
                AllOf(HasSubstr("do not lie on each other"), HasSubstr("0.1 m away")));
    EXPECT_THAT(failureOf(leftPlate(), Plate{2, 4}), HasSubstr("entry 'coupling' is missing"));
    Plate held = rightPlate();
    held.supports = clamped;
    EXPECT_THAT(failureOf(leftPlate(), held), HasSubstr("supports hold these edges altogether"));
    Plate loaded = leftPlate();
    loaded.coupling = "{interface: [right], tolerance: 1e-3}";
    EXPECT_THAT(failureOf(loaded, rightPlate()),
                AllOf(HasSubstr("tolerance"), HasSubstr("goes with side: dirichlet")));
    Plate loose = leftPlate();
    loose.supports = "[]";
    EXPECT_THAT(failureOf(loose, rightPlate()), HasSubstr("nothing prevents"));
    Plate unknown = rightPlate();
    unknown.coupling = "{interface: [lft], side: dirichlet}";
    EXPECT_THAT(failureOf(leftPlate(), unknown), AllOf(HasSubstr("lft"), HasSubstr("left")));
}

TEST(EdgeCoupling, steps_that_do_not_converge_fail_with_their_residuals) {
    EXPECT_THAT(failureOf(leftPlate("constant"), rightPlate(", maxIterations: 2")),
                AllOf(HasSubstr("do not agree after 2 coupling iterations"), HasSubstr("residuals"),
                      HasSubstr("tolerance 1e-08")));
}

TEST(EdgeCoupling, structures_in_two_processes_move_as_in_one) {
    const TemporaryDirectory directory;
    const std::string left = leftPlate().write(directory, "left");
    const std::string right = rightPlate().write(directory, "right");
    const std::string address = "unix:" + directory.file("socket");
    ChildProgram loaded({"run", left, "--listen", address});
    ASSERT_TRUE(loaded.waitForOutput("waiting for")) << loaded.output();
    ChildProgram moved({"couple", right, left, "--connect", address});
    EXPECT_EQ(moved.wait(), 0) << moved.output();
    EXPECT_EQ(loaded.wait(), 0) << loaded.output();
    EXPECT_THAT(loaded.output(), HasSubstr("the moved structure ends the run"));
    EXPECT_THAT(moved.output(), HasSubstr("coupling iterations per time step: mean"));
    const auto table = tableRows(directory.read("postProcessing/right/0/watchPoints.dat"));
    // On some processors BLAS rounds by where in memory its vectors lie.
    expectSame(table, couple(leftPlate(), rightPlate()).right, 1e-12);
}

TEST(EdgeCoupling, a_moved_structure_does_not_run_beside_a_fluid) {
    const TemporaryDirectory directory;
    ChildProgram program({"run", rightPlate().write(directory, "right"), "--listen",
                          "unix:" + directory.file("socket")});
    EXPECT_EQ(program.wait(), 1);
    EXPECT_THAT(program.output(), HasSubstr("igaStructure couple"));
}
