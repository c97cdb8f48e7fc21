// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/checksum.hpp"
#include "common/errors.hpp"
#include "igaStructure/ScriptedFluid.hpp"
#include "igaStructure/coupledRun/restart/SavedState.hpp"
#include "igaStructure/coupledRun/restart/StateFolder.hpp"
#include "igaStructure/coupledRun/restart/interfaceRenumbering.hpp"
#include "igaStructure/exampleCase.hpp"
#include "igaStructure/output/pvd.hpp"
#include "temporaryDirectory.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

using namespace tokay;
using namespace tokay::structure;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

namespace {

SavedState exampleState(double time) {
    SavedState state;
    state.digest = "a3f8";
    state.motion.time = time;
    state.motion.displacement = Eigen::VectorXd::LinSpaced(4, 0.1, 1.0 / 3);
    state.motion.velocity = -state.motion.displacement;
    state.motion.acceleration = 1e-300 * state.motion.displacement;
    state.motion.force = 1e30 * state.motion.displacement;
    state.motion.reaction = -2 * state.motion.force;
    state.energies = {1, 2, 3, 4};
    state.interface = Eigen::VectorXd::LinSpaced(9, -1, 0.3).reshaped(3, 3);
    state.interfaceDisplacement = Eigen::VectorXd::LinSpaced(6, 1e-3, 1);
    state.interfaceResidual = Eigen::VectorXd::LinSpaced(6, -1e-5, 1e-5);
    state.coupling = {7, 0, 255};
    return state;
}

void expectEqual(const SavedState& a, const SavedState& b) {
    EXPECT_EQ(a.digest, b.digest);
    EXPECT_EQ(a.motion.time, b.motion.time);
    EXPECT_EQ(a.motion.displacement, b.motion.displacement);
    EXPECT_EQ(a.motion.velocity, b.motion.velocity);
    EXPECT_EQ(a.motion.acceleration, b.motion.acceleration);
    EXPECT_EQ(a.motion.force, b.motion.force);
    EXPECT_EQ(a.motion.reaction, b.motion.reaction);
    EXPECT_EQ(a.energies.kinetic, b.energies.kinetic);
    EXPECT_EQ(a.energies.strain, b.energies.strain);
    EXPECT_EQ(a.energies.externalWork, b.energies.externalWork);
    EXPECT_EQ(a.energies.dampingWork, b.energies.dampingWork);
    EXPECT_EQ(a.interface, b.interface);
    EXPECT_EQ(a.interfaceDisplacement, b.interfaceDisplacement);
    EXPECT_EQ(a.interfaceResidual, b.interfaceResidual);
    EXPECT_EQ(a.coupling, b.coupling);
}

std::string errorOf(const std::vector<std::uint8_t>& bytes) {
    try {
        decodeState(bytes, "case_1.state");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

} // namespace

TEST(SavedState, comes_back_bit_by_bit) {
    expectEqual(decodeState(encodeState(exampleState(0.1)), ""), exampleState(0.1));
}

TEST(SavedState, that_is_cut_off_anywhere_is_refused_with_its_name) {
    const std::vector<std::uint8_t> whole = encodeState(exampleState(0.1));
    for (std::size_t size = 0; size < whole.size(); ++size) {
        EXPECT_THAT(errorOf({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)}),
                    HasSubstr("'case_1.state': the state is damaged"))
            << size;
    }
}

TEST(SavedState, of_another_version_is_refused) {
    std::vector<std::uint8_t> bytes = encodeState(exampleState(0.1));
    bytes[14] = 9; // after the length and the ten letters of the magic
    EXPECT_THAT(errorOf(bytes), HasSubstr("its version is 9, this program reads version 5"));
}

TEST(SavedState, of_which_any_byte_has_changed_is_refused) {
    const std::vector<std::uint8_t> whole = encodeState(exampleState(0.1));
    for (std::size_t place = 0; place < whole.size(); ++place) {
        for (const int change : {0x01, 0x80, 0xff}) {
            std::vector<std::uint8_t> bytes = whole;
            bytes[place] = static_cast<std::uint8_t>(bytes[place] ^ change);
            EXPECT_THAT(errorOf(bytes), HasSubstr("'case_1.state': the state is damaged")) << place;
        }
    }
}

namespace {

// Puts the checksum right, as a program with a fault of its own would.
std::vector<std::uint8_t> sealed(std::vector<std::uint8_t> bytes) {
    const std::size_t size = bytes.size() - 4;
    const std::uint32_t sum = checksum(bytes.data(), size);
    for (std::size_t i = 0; i < 4; ++i) {
        bytes[size + i] = static_cast<std::uint8_t>(sum >> (8 * i));
    }
    return bytes;
}

} // namespace

TEST(SavedState, with_sizes_that_are_absurd_is_refused_before_anything_is_allocated) {
    const std::vector<std::uint8_t> whole = encodeState(exampleState(0.1));
    int nRefused = 0;
    for (std::size_t place = 18; place + 8 < whole.size(); ++place) {
        std::vector<std::uint8_t> bytes = whole;
        std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(place), 4, std::uint8_t{0xff});
        const std::string error = errorOf(sealed(bytes)); // and never another exception
        nRefused += error.empty() ? 0 : 1;
    }
    EXPECT_GT(nRefused, 10 * 4); // at least wherever a length or a size stands
}

TEST(SavedState, of_the_fuzzer_is_refused_by_its_name) {
    const std::filesystem::path seeds = TOKAY_SOURCE_DIR "/tests/fuzz/seeds/state";
    int nFiles = 0;
    for (const auto& entry : std::filesystem::directory_iterator(seeds)) {
        std::ifstream file(entry.path(), std::ios::binary);
        const std::vector<std::uint8_t> bytes(std::istreambuf_iterator<char>(file), {});
        EXPECT_THAT(errorOf(bytes), HasSubstr("'case_1.state': the state is damaged"));
        ++nFiles;
    }
    EXPECT_GE(nFiles, 2);
}

TEST(StateFolder, finds_the_nearest_state_within_the_tolerance) {
    const TemporaryDirectory directory;
    StateFolder folder(directory.file("states"), "flap");
    EXPECT_TRUE(folder.times().empty());
    folder.add(exampleState(1.0 / 3), 0.1);
    folder.add(exampleState(0.1), 0.1);
    StateFolder(directory.file("states"), "flap_2").add(exampleState(0.2), 0.1); // another case
    directory.write("states/flap_0.3.state.part", "");
    EXPECT_THAT(folder.times(), ElementsAre(0.1, testing::DoubleNear(1.0 / 3, 1e-12)));
    expectEqual(folder.find(0.333333, 1e-5).value(), exampleState(1.0 / 3));
    EXPECT_FALSE(folder.find(0.333333, 1e-7).has_value());
}

namespace {

// Four states of steps of 0.01 s, on disk and of this run.
class StatesOfARun : public testing::Test {
  protected:
    StatesOfARun() {
        for (const double time : {0.02, 0.04, 0.06, 0.08}) {
            folder.add(exampleState(time), 0.01);
        }
    }
    TemporaryDirectory directory;
    StateFolder folder{directory.file("states"), "flap"};
};

} // namespace

TEST_F(StatesOfARun, go_with_the_fluids_times_but_for_the_last) {
    folder.removeExcept({0, 0.04, 0.06});
    EXPECT_THAT(folder.times(), ElementsAre(0.04, 0.06, 0.08));
    folder.removeExcept({0});
    EXPECT_THAT(folder.times(), ElementsAre(0.08));
}

TEST_F(StatesOfARun, stay_for_times_whose_names_are_rounded) {
    folder.removeExcept({0.025, 0.0555});
    EXPECT_THAT(folder.times(), ElementsAre(0.02, 0.06, 0.08));
}

TEST_F(StatesOfARun, of_earlier_runs_stay) {
    StateFolder later(directory.file("states"), "flap");
    later.removeExcept({0});
    later.add(exampleState(0.1), 0.01);
    later.add(exampleState(0.12), 0.01);
    later.removeExcept({0});
    EXPECT_THAT(later.times(), ElementsAre(0.02, 0.04, 0.06, 0.08, 0.12));
}

TEST(InterfaceRenumbering, finds_each_point_again) {
    const geometry::Points before = geometry::Points::Random(50, 3);
    std::vector<int> numbers(50);
    for (int k = 0; k < 50; ++k) {
        numbers[static_cast<std::size_t>(k)] = (7 * k + 3) % 50;
    }
    const geometry::Points now = before(numbers, Eigen::all);
    EXPECT_EQ(interfaceRenumbering(before, now).value(), numbers);
    EXPECT_THAT(componentNumbers({2, 0}, 3), ElementsAre(6, 7, 8, 0, 1, 2));
}

TEST(InterfaceRenumbering, keeps_points_that_coincide_if_all_stay_where_they_were) {
    geometry::Points points = geometry::Points::Random(4, 3);
    points.row(3) = points.row(0);
    EXPECT_THAT(interfaceRenumbering(points, points).value(), ElementsAre(0, 1, 2, 3));
    const geometry::Points turned = points.colwise().reverse();
    EXPECT_FALSE(interfaceRenumbering(points, turned).has_value());
}

TEST(InterfaceRenumbering, does_not_take_another_mesh_for_the_same) {
    const geometry::Points before = geometry::Points::Random(4, 3);
    geometry::Points now = before.colwise().reverse();
    now(2, 1) += 1e-3;
    EXPECT_FALSE(interfaceRenumbering(before, now).has_value());
    EXPECT_FALSE(interfaceRenumbering(before, before.topRows(3)).has_value());
}

TEST(Pvd, comes_back_as_written) {
    const TemporaryDirectory directory;
    writePvd(directory.file("a.pvd"), {{0, "a_0.vtu"}, {0.1, "a_1.vtu"}});
    const std::vector<PvdEntry> entries = readPvd(directory.file("a.pvd"));
    ASSERT_EQ(entries.size(), 2u);
    EXPECT_EQ(entries[1].time, 0.1);
    EXPECT_EQ(entries[1].file, "a_1.vtu");
    EXPECT_TRUE(readPvd(directory.file("none.pvd")).empty());
}

namespace {

std::string caseText() {
    return exampleText("loads:\n  - {edge: left, traction: [\"100*y\", 0]}\n", "") +
           "coupling:\n  interface: [left, top, right]\n  predictor: quadratic\n";
}

std::string nonlinearCaseText() {
    std::string text = caseText();
    return text.replace(text.find("strains: linear"), 15, "strains: nonlinear");
}

std::vector<double> forcesOf(const channel::Interface& fluid, std::uint32_t step) {
    return forceOnLeft(fluid, 100 * std::sin(0.5 * step));
}

// Answers of the structure to steps of 0.01 s; every third is written.
std::vector<std::vector<double>> runSteps(ScriptedFluid& script, const channel::Interface& fluid,
                                          std::uint32_t first, std::uint32_t last) {
    std::vector<std::vector<double>> answers;
    for (std::uint32_t step = first; step <= last; ++step) {
        answers.push_back(script.begin(step, 0.01 * step, 0.01).values);
        answers.push_back(script.exchange(forcesOf(fluid, step)).values);
        answers.push_back(script.exchange(forcesOf(fluid, step)).values);
        script.exchange(forcesOf(fluid, step), true, step % 3 == 0);
    }
    return answers;
}

// Six steps of a run that is then killed, and what a restarted one answers.
class RestartedRun : public testing::Test {
  protected:
    explicit RestartedRun(const std::string& text = caseText())
        : caseFile(directory.write("case.yaml", text)) {
        fluid.deltaT = 0.01;
        fluid.tolerance = 1e-9;
        ScriptedFluid script(caseFile);
        script.start(fluid);
        runSteps(script, fluid, 1, 6);
        expected = runSteps(script, fluid, 7, 9);
        script.vanish();
        fluid.startTime = 0.06;
    }

    // The interface as the fluid's files have it at the start.
    void displace() {
        const StateFolder folder(directory.file("results/states"), "case");
        const Eigen::VectorXd x = folder.find(fluid.startTime, 1e-9)->interfaceDisplacement;
        fluid.displacements.assign(x.begin(), x.end());
    }

    // What a run from the saved state answers.
    std::vector<std::vector<double>> restart() {
        displace();
        ScriptedFluid script(caseFile);
        script.start(fluid);
        std::vector<std::vector<double>> answers = runSteps(script, fluid, 7, 9);
        script.sayGoodbye();
        EXPECT_EQ(script.outcome(), "");
        EXPECT_THAT(script.log(), HasSubstr("restarting from the saved state at t = 0.06 s"));
        return answers;
    }

    std::string refusal() {
        ScriptedFluid script(caseFile);
        script.channel().send(fluid);
        const std::string text = script.failureText();
        script.vanish();
        script.outcome();
        return text;
    }

    TemporaryDirectory directory;
    std::string caseFile;
    channel::Interface fluid = flapInterface(20);
    std::vector<std::vector<double>> expected;
};

} // namespace

TEST_F(RestartedRun, answers_bit_by_bit_what_the_uninterrupted_one_does) {
    EXPECT_EQ(restart(), expected);
    std::vector<double> times;
    for (const PvdEntry& entry : readPvd(directory.file("results/case.pvd"))) {
        times.push_back(entry.time);
    }
    EXPECT_THAT(times, ElementsAre(0, 0.03, 0.06, 0.09));
}

namespace {

// Newton's method keeps tangents over time steps, but not over a saved state.
class NonlinearRestart : public RestartedRun {
  protected:
    explicit NonlinearRestart(const std::string& acceleration = "iqnIls")
        : RestartedRun(nonlinearCaseText() + "  acceleration: {type: " + acceleration + "}\n") {}
};

class NonlinearRestartWithSubsteps : public RestartedRun {
  protected:
    static std::string text() {
        std::string text = nonlinearCaseText();
        return text.replace(text.find("time:\n"), 6, "time:\n  substeps: 3\n");
    }
    NonlinearRestartWithSubsteps() : RestartedRun(text()) {}
};

class NonlinearRestartWithBlocks : public NonlinearRestart {
  protected:
    NonlinearRestartWithBlocks() : NonlinearRestart("block") {}
};

} // namespace

TEST_F(NonlinearRestart, answers_bit_by_bit_what_the_uninterrupted_one_does) {
    EXPECT_EQ(restart(), expected);
}

TEST_F(NonlinearRestartWithSubsteps, answers_bit_by_bit_what_the_uninterrupted_one_does) {
    EXPECT_EQ(restart(), expected);
}

TEST_F(NonlinearRestartWithBlocks, answers_bit_by_bit_what_the_uninterrupted_one_does) {
    EXPECT_EQ(restart(), expected);
}

TEST_F(RestartedRun, starts_at_rest_under_an_undeformed_fluid) {
    ScriptedFluid script(caseFile);
    script.start(fluid);
    EXPECT_THAT(script.begin(1, 0.07, 0.01).values, testing::Each(0));
    script.exchange(forcesOf(fluid, 1), true);
    script.sayGoodbye();
    EXPECT_EQ(script.outcome(), "");
    EXPECT_THAT(script.log(), Not(HasSubstr("goes on")));
}

TEST_F(RestartedRun, carries_on_without_acceleration_history_on_another_mesh) {
    displace();
    const std::vector<double> tip(fluid.displacements.begin() + 40,
                                  fluid.displacements.begin() + 42);
    fluid = flapInterface(10);
    fluid.deltaT = 0.01;
    fluid.startTime = 0.06;
    fluid.displacements.assign(fluid.points.size(), 1e-3); // whatever: it cannot be compared
    ScriptedFluid script(caseFile);
    script.start(fluid);
    const std::vector<double> predicted = script.begin(1, 0.07, 0.01).values;
    // The fluid's x and the structure's own answer differ by the residual, below 1e-9 of it
    EXPECT_NEAR(predicted[20], tip[0], 1e-8 * std::abs(tip[0]));
    script.exchange(forcesOf(fluid, 1), true);
    script.sayGoodbye();
    EXPECT_EQ(script.outcome(), "");
    EXPECT_THAT(script.log(), HasSubstr("predictor and acceleration history are reset"));
}

TEST_F(RestartedRun, names_the_times_that_have_a_state_if_the_fluids_has_none) {
    displace();
    fluid.startTime = 0.05;
    EXPECT_THAT(refusal(), AllOf(HasSubstr("the fluid starts at 0.05 s"),
                                 HasSubstr("it has: 0.03 s, 0.06 s, 0.09 s")));
}

TEST_F(RestartedRun, refuses_a_state_of_another_motion) {
    displace();
    fluid.displacements[40] *= 1.001;
    EXPECT_THAT(refusal(), HasSubstr("is not where the structure's saved state has it"));
}

TEST_F(RestartedRun, refuses_a_state_of_which_one_number_is_damaged_and_names_its_file) {
    displace();
    const std::string file = directory.file("results/states/case_0.06.state");
    std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
    constexpr int place = 200; // in the middle of the structure's displacement
    stream.seekg(place);
    const int byte = stream.get();
    stream.seekp(place);
    stream.put(static_cast<char>(byte ^ 0x10));
    stream.close();
    EXPECT_THAT(refusal(), AllOf(HasSubstr("'" + file + "': the state is damaged"),
                                 HasSubstr("does not fit its checksum")));
}

TEST_F(RestartedRun, refuses_a_state_whose_displacement_is_not_that_of_the_interface_beside_it) {
    displace();
    StateFolder folder(directory.file("results/states"), "case");
    SavedState state = folder.find(0.06, 1e-9).value();
    Eigen::VectorXd& d = state.motion.displacement;
    Eigen::Index largest = 0;
    for (Eigen::Index i = 0; i < d.size(); ++i) {
        const bool isOnLeft = i / 2 % 3 == 0; // of three control points in a row, two components
        largest = isOnLeft && std::abs(d[i]) > std::abs(d[largest]) ? i : largest;
    }
    d[largest] *= 1.05;
    folder.add(state, 0.01);
    EXPECT_THAT(refusal(),
                AllOf(HasSubstr("results/states/case_0.06.state': the state is damaged"),
                      HasSubstr("the structure's displacement is off the interface's by 0.0")));
}

TEST_F(RestartedRun, refuses_an_acceleration_history_that_is_cut_off_and_names_the_file) {
    displace();
    StateFolder folder(directory.file("results/states"), "case");
    SavedState state = folder.find(0.06, 1e-9).value();
    state.coupling.resize(state.coupling.size() - 3);
    folder.add(state, 0.01);
    EXPECT_THAT(refusal(), HasSubstr("results/states/case_0.06.state': the state is damaged"));
}

TEST_F(RestartedRun, removes_its_states_with_the_fluids_times) {
    displace();
    ScriptedFluid script(caseFile);
    script.start(fluid);
    for (std::uint32_t step = 7; step <= 9; ++step) {
        script.begin(step, 0.01 * step, 0.01);
        script.channel().send(
            channel::Forces{true, true, 0, forcesOf(fluid, step), false, {0, 0.03, 0.06, 0.08}});
        EXPECT_EQ(script.receive().state, channel::State::accepted);
    }
    script.sayGoodbye();
    EXPECT_EQ(script.outcome(), "");
    EXPECT_THAT(StateFolder(directory.file("results/states"), "case").times(),
                ElementsAre(0.03, 0.06, 0.08, 0.09));
}

TEST_F(RestartedRun, refuses_another_geometry_with_as_many_unknowns) {
    displace();
    std::string text = caseText();
    text.replace(text.find("-0.05, 0"), 8, "-0.051, 0");
    directory.write("case.yaml", text);
    EXPECT_THAT(refusal(), HasSubstr("geometry or discretisation"));
}

TEST_F(RestartedRun, takes_other_material_and_output_from_the_case_file) {
    displace();
    std::string text = caseText();
    text.replace(text.find("youngsModulus: 4e6"), 18, "youngsModulus: 5e6");
    directory.write("case.yaml", text);
    ScriptedFluid script(caseFile);
    script.start(fluid);
    EXPECT_NE(runSteps(script, fluid, 7, 9), expected);
    script.sayGoodbye();
    EXPECT_EQ(script.outcome(), "");
}

TEST(RejectedStep, leaves_no_trace_in_the_steps_after_it) {
    std::vector<std::vector<std::vector<double>>> answers;
    for (const bool rejects : {false, true}) {
        const TemporaryDirectory directory;
        channel::Interface fluid = flapInterface(20);
        fluid.tolerance = 1e-9;
        fluid.retries = true;
        ScriptedFluid script(directory.write("case.yaml", caseText()));
        script.start(fluid);
        runSteps(script, fluid, 1, 3);
        if (rejects) {
            script.begin(4, 0.05, 0.02);
            for (int exchange = 0; exchange < 3; ++exchange) {
                script.exchange(forceOnLeft(fluid, 1e4 * exchange));
            }
            script.channel().send(channel::RejectStep{"not converged"});
        }
        answers.push_back(runSteps(script, fluid, 4, 6));
        script.sayGoodbye();
        EXPECT_EQ(script.outcome(), "");
    }
    EXPECT_EQ(answers[0], answers[1]);
}

namespace {

// A step that a nonlinear structure cannot take in one.
class ImpossibleStep : public testing::Test {
  protected:
    ImpossibleStep() {
        caseFile =
            directory.write("case.yaml", nonlinearCaseText() + "newton: {maxIterations: 2}\n");
    }
    TemporaryDirectory directory;
    std::string caseFile;
    channel::Interface fluid = flapInterface(20);
};

} // namespace

TEST_F(ImpossibleStep, is_told_to_a_fluid_that_retries_and_forgotten_when_it_rejects) {
    fluid.retries = true;
    ScriptedFluid script(caseFile);
    script.start(fluid);
    script.begin(1, 0.01, 0.01);
    const channel::Displacements answer = script.exchange(forceOnLeft(fluid, 1e7));
    EXPECT_EQ(answer.state, channel::State::rejected);
    EXPECT_THAT(answer.reason, HasSubstr("time 0.01 s"));
    script.channel().send(channel::RejectStep{"the structure has no solution"});
    // From rest again, the forces of which nothing is left
    EXPECT_THAT(script.begin(1, 1e-5, 1e-5).values, testing::Each(0));
    EXPECT_EQ(script.exchange(forceOnLeft(fluid, 1e-3), true).state, channel::State::accepted);
    script.sayGoodbye();
    EXPECT_EQ(script.outcome(), "");
    EXPECT_THAT(script.log(), HasSubstr("step 1 time 0.01 s is rejected"));
}

TEST_F(ImpossibleStep, ends_the_run_of_a_fluid_that_does_not_retry) {
    ScriptedFluid script(caseFile);
    script.start(fluid);
    script.begin(1, 0.01, 0.01);
    script.channel().send(channel::Forces{false, false, 0, forceOnLeft(fluid, 1e7)});
    EXPECT_THAT(script.failureText(), HasSubstr("time 0.01 s"));
    script.outcome();
}
