// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/errors.hpp"
#include "coupling/couplingMethods.hpp"
#include "igaStructure/ScriptedFluid.hpp"
#include "igaStructure/coupledRun/DisplacementRecord.hpp"
#include "igaStructure/exampleCase.hpp"
#include "igaStructure/run/runAlone.hpp"
#include "igaStructure/tableRows.hpp"
#include "temporaryDirectory.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <filesystem>

using namespace tokay;
using namespace tokay::structure;
using channel::State;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

namespace {

std::string coupledText(const std::string& from = "", const std::string& to = "") {
    std::string text = exampleText("loads:\n  - {edge: left, traction: [\"100*y\", 0]}\n", "") +
                       "coupling:\n  interface: [left, top, right]\n";
    const auto place = text.find(from);
    if (place == std::string::npos) {
        throw std::logic_error("the example has no '" + from + "'");
    }
    return text.replace(place, from.size(), to);
}

double seconds(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Ten steps under a constant force of 100 N/m; returns the watch point's table.
std::vector<std::vector<double>> watchOfCoupledRun(const TemporaryDirectory& directory,
                                                   const std::string& text, int nFaces) {
    const channel::Interface fluid = flapInterface(nFaces);
    ScriptedFluid script(directory.write("case.yaml", text));
    script.start(fluid);
    for (std::uint32_t step = 1; step <= 10; ++step) {
        script.advance(step, 0.01, forceOnLeft(fluid, 100));
    }
    script.sayGoodbye();
    EXPECT_EQ(script.outcome(), "");
    return tableRows(directory.read("postProcessing/case/0/watchPoints.dat"));
}

} // namespace

TEST(CoupledRun, constant_force_moves_the_structure_as_the_same_traction_does_alone) {
    for (const char* strains : {"linear", "nonlinear"}) {
        const std::string model = std::string("strains: ") + strains;
        const TemporaryDirectory coupled;
        const auto rows = watchOfCoupledRun(coupled, coupledText("strains: linear", model), 400);
        const TemporaryDirectory alone;
        // The fluid's force counts as zero at the start, so must the traction.
        std::string text = exampleText("100*y", "t > 0 ? 100 : 0");
        text.replace(text.find("strains: linear"), 15, model);
        runAlone(readCase(alone.write("case.yaml", text)), [](const std::string&) {});
        const auto expected = tableRows(alone.read("postProcessing/case/0/watchPoints.dat"));
        ASSERT_EQ(rows.size(), expected.size());
        for (std::size_t k = 0; k < rows.size(); ++k) {
            EXPECT_NEAR(rows[k][0], expected[k][0], 1e-12);
            // Forces of faces act at their points: the trapezoidal rule with 50 faces an
            // element, against exact integration: (1/50)^2/12 of the second derivative.
            EXPECT_NEAR(rows[k][1], expected[k][1], 5e-5 * std::abs(expected.back()[1]));
        }
    }
}

namespace {

struct TipMotion {
    double end; ///< displacement along x after the last step
    double
        imbalance; ///< largest difference of forces at the accepted displacement and the final ones
};

// Ten steps in a fluid that pushes the left edge by 100 N/m and resists the acceleration of its
// upper end by a mass of 100 kg/m: about what the flap has, so the force follows the motion.
TipMotion tipInAddedMass(const std::string& acceleration) {
    const TemporaryDirectory directory;
    channel::Interface fluid = flapInterface(20);
    fluid.tolerance = 1e-9;
    const double deltaT = 0.01;
    ScriptedFluid script(directory.write(
        "case.yaml", coupledText() + "  acceleration: {type: " + acceleration + "}\n"));
    script.start(fluid);
    const auto tipOf = [](const channel::Displacements& sent) { return sent.values[2 * 20]; };
    TipMotion motion{0, 0};
    double before = 0;
    for (std::uint32_t step = 1; step <= 10; ++step) {
        const auto sumAt = [&, old = motion.end](double tip) {
            return 100 - 100 * (tip - 2 * old + before) / (deltaT * deltaT);
        };
        double tip = tipOf(script.begin(step, step * deltaT, deltaT));
        for (int exchange = 0; exchange < 200; ++exchange) {
            const channel::Displacements next = script.exchange(forceOnLeft(fluid, sumAt(tip)));
            if (next.state == State::converged) {
                break;
            }
            tip = tipOf(next);
        }
        const double accepted = tipOf(script.exchange(forceOnLeft(fluid, sumAt(tip)), true));
        motion.imbalance = std::max(motion.imbalance, std::abs(sumAt(accepted) - sumAt(tip)));
        before = motion.end;
        motion.end = accepted;
    }
    script.sayGoodbye();
    EXPECT_EQ(script.outcome(), "");
    return motion;
}

} // namespace

TEST(CoupledRun, accelerations_find_the_displacement_whose_forces_cause_it) {
    const TipMotion expected = tipInAddedMass("block");
    EXPECT_GT(expected.end, 1e-4);
    for (const coupling::CouplingMethodType& type : coupling::couplingMethods()) {
        if (type.name == "explicit") {
            continue;
        }
        const TipMotion motion = tipInAddedMass(type.name);
        // 1e-9 of the displacement, some 1e-3 m, is worth 1e-6 N/m of the 100 N/m by inertia.
        EXPECT_LT(motion.imbalance, 1e-5) << type.name;
        EXPECT_NEAR(motion.end, expected.end, 1e-7 * expected.end) << type.name;
    }
    // One exchange a step is not enough: the test would notice.
    EXPECT_GT(tipInAddedMass("explicit").imbalance, 1);
}

TEST(CoupledRun, plate_of_any_thickness_moves_alike_because_forces_are_per_unit_depth) {
    std::vector<double> tips;
    for (const char* thickness : {"1", "0.2"}) {
        const TemporaryDirectory directory;
        tips.push_back(
            watchOfCoupledRun(
                directory,
                coupledText("planeStrain", std::string("planeStress\n  thickness: ") + thickness),
                20)
                .back()[1]);
    }
    EXPECT_NEAR(tips[0], tips[1], 1e-10 * tips[0]);
}

TEST(CoupledRun, session_sends_predicted_then_iterated_then_accepted_displacements) {
    const TemporaryDirectory directory;
    const channel::Interface fluid = flapInterface(20);
    const std::vector<double> forces = forceOnLeft(fluid, 100);
    ScriptedFluid script(directory.write("case.yaml", coupledText()));
    EXPECT_THAT(script.start(fluid), AllOf(HasSubstr("coverage 100.0 %"), HasSubstr("force sum"),
                                           HasSubstr("42 points, 41 faces")));
    const channel::Displacements predicted = script.begin(1, 0.01, 0.01);
    EXPECT_EQ(predicted.state, State::iterate);
    EXPECT_EQ(predicted.values, std::vector<double>(84, 0.0)); // at rest
    channel::Displacements next = script.exchange(forces);
    EXPECT_EQ(next.state, State::iterate);
    EXPECT_GE(next.residual, fluid.tolerance);
    while (next.state == State::iterate) {
        next = script.exchange(forces);
    }
    EXPECT_EQ(next.state, State::converged);
    EXPECT_LT(next.residual, fluid.tolerance);
    const channel::Displacements accepted = script.exchange(forces, true);
    EXPECT_EQ(accepted.state, State::accepted);
    EXPECT_LT(accepted.residual, fluid.tolerance);
    EXPECT_GT(accepted.values[2 * 20], 0); // the top left corner, pushed along x
    EXPECT_EQ(accepted.values[0], 0);      // the clamped one
    script.sayGoodbye();
    EXPECT_EQ(script.outcome(), "");
    EXPECT_THAT(script.log(), HasSubstr("the fluid ends the run: end of the script"));
}

TEST(CoupledRun, results_are_written_when_the_fluid_writes) {
    const TemporaryDirectory directory;
    const channel::Interface fluid = flapInterface(20);
    ScriptedFluid script(directory.write("case.yaml", coupledText()));
    script.start(fluid);
    script.advance(1, 0.01, forceOnLeft(fluid, 100));
    EXPECT_FALSE(std::filesystem::exists(directory.file("results/case.pvd")));
    script.advance(2, 0.01, forceOnLeft(fluid, 100), true);
    script.advance(3, 0.01, forceOnLeft(fluid, 100));
    script.sayGoodbye();
    EXPECT_EQ(script.outcome(), "");
    const std::string pvd = directory.read("results/case.pvd");
    EXPECT_THAT(pvd, AllOf(HasSubstr("timestep=\"0\""), HasSubstr("timestep=\"0.02\""),
                           Not(HasSubstr("timestep=\"0.03\""))));
}

TEST(CoupledRun, log_and_tables_have_a_line_a_step_and_say_that_the_fluid_gives_the_time) {
    const TemporaryDirectory directory;
    const channel::Interface fluid = flapInterface(20);
    ScriptedFluid script(directory.write("case.yaml", coupledText()));
    script.start(fluid);
    int nExchanges = 0;
    for (std::uint32_t step = 1; step <= 3; ++step) {
        nExchanges = script.advance(step, 0.01, forceOnLeft(fluid, 100));
    }
    script.sayGoodbye();
    EXPECT_EQ(script.outcome(), "");
    EXPECT_THAT(script.log(),
                AllOf(HasSubstr("note: time steps and end come from the fluid"),
                      HasSubstr("step 3 time 0.03 s  exchanges " + std::to_string(nExchanges + 1)),
                      HasSubstr("tip (")));
    for (const char* table : {"watchPoints", "iterations", "energy"}) {
        EXPECT_EQ(tableRows(directory.read(std::string("postProcessing/case/0/") + table + ".dat"))
                      .size(),
                  3u)
            << table;
    }
}

TEST(CoupledRun, recorded_motion_is_answered_again_without_a_structure) {
    const TemporaryDirectory directory;
    const channel::Interface fluid = flapInterface(20);
    const std::string caseFile = directory.write("case.yaml", coupledText());
    CoupledRunOptions options;
    options.recordFile = directory.file("motion.dat");
    std::vector<std::vector<double>> motion;
    {
        ScriptedFluid script(caseFile, options);
        script.start(fluid);
        for (std::uint32_t step = 1; step <= 3; ++step) {
            script.begin(step, 0.01 * step, 0.01);
            motion.push_back(script.exchange(forceOnLeft(fluid, 100), true).values);
        }
        script.sayGoodbye();
        EXPECT_EQ(script.outcome(), "");
    }
    std::swap(options.recordFile, options.replayFile);
    ScriptedFluid script(caseFile, options);
    script.start(fluid);
    for (std::uint32_t step = 1; step <= 3; ++step) {
        EXPECT_EQ(script.begin(step, 0.01 * step, 0.01).values, motion[step - 1]);
        const channel::Displacements answer = script.exchange(forceOnLeft(fluid, -7));
        EXPECT_EQ(answer.values, motion[step - 1]);
        EXPECT_EQ(answer.residual, 0);
        EXPECT_EQ(answer.state, State::converged);
        EXPECT_EQ(script.exchange(forceOnLeft(fluid, -7), true).state, State::accepted);
    }
    script.channel().send(channel::BeginStep{4, 0.04, 0.01});
    EXPECT_THAT(script.failureText(), HasSubstr("motion.dat ends at 0.03 s"));
    EXPECT_THAT(script.outcome(), HasSubstr("motion.dat ends at 0.03 s"));
}

namespace {

// A record of three steps of one point, and what reading it says after a change.
class Record : public testing::Test {
  protected:
    Record() {
        DisplacementRecorder recorder(path, 0);
        for (int step = 1; step <= 3; ++step) {
            recorder.add(0.1 * step, Eigen::VectorXd::LinSpaced(2, -step / 3.0, 7e-5));
        }
    }
    std::string errorOf(const std::string& text) const {
        directory.write("motion.dat", text);
        try {
            DisplacementRecord record(path, 2);
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    }
    std::string text() const { return directory.read("motion.dat"); }

    TemporaryDirectory directory;
    std::string path = directory.file("motion.dat");
};

} // namespace

TEST_F(Record, of_which_any_byte_has_changed_is_refused) {
    const std::string whole = text();
    EXPECT_EQ(errorOf(whole), "");
    for (std::size_t place = 0; place < whole.size(); ++place) {
        for (const int change : {0x01, 0x10, 0x80, 0xff}) {
            std::string changed = whole;
            changed[place] = static_cast<char>(changed[place] ^ change);
            EXPECT_THAT(errorOf(changed), AllOf(HasSubstr("motion.dat:"), HasSubstr("are damaged")))
                << place;
        }
    }
}

TEST_F(Record, that_is_cut_off_within_a_line_or_lacks_one_is_refused) {
    const std::string whole = text();
    for (std::size_t size = 0; size < whole.size(); ++size) {
        const bool isShorter = size > 0 && whole[size - 1] == '\n'; // but right, as far as it goes
        EXPECT_EQ(errorOf(whole.substr(0, size)).empty(), isShorter) << size;
    }
    const std::size_t second = whole.find('\n', whole.find('\n') + 1) + 1;
    const std::size_t third = whole.find('\n', second) + 1;
    EXPECT_THAT(errorOf(whole.substr(0, second) + whole.substr(third)),
                HasSubstr("motion.dat:3: the recorded displacements are damaged"));
}

TEST_F(Record, keeps_the_steps_until_the_start_of_a_restarted_run) {
    DisplacementRecorder recorder(path, 0.2);
    recorder.add(0.25, Eigen::VectorXd::Constant(2, 1));
    const DisplacementRecord record(path, 2);
    EXPECT_EQ(record.at(0.1)[0], -1 / 3.0);
    EXPECT_EQ(record.at(0.2)[0], -2 / 3.0);
    EXPECT_EQ(record.at(0.25)[0], 1);
    EXPECT_THROW(record.at(0.3), InputError);
}

namespace {

// What the structure says when it gets an interface; the fluid must hear the same.
std::string refusal(const std::string& text, const channel::Interface& fluid) {
    const TemporaryDirectory directory;
    ScriptedFluid script(directory.write("case.yaml", text));
    script.channel().send(fluid);
    const std::string told = script.failureText();
    const std::string outcome = script.outcome();
    EXPECT_THAT(told, HasSubstr(outcome));
    EXPECT_NE(outcome, "");
    return outcome;
}

} // namespace

TEST(CoupledRun, interface_that_does_not_lie_on_the_structure_is_refused_with_the_gap) {
    channel::Interface fluid = flapInterface(20);
    for (std::size_t k = 0; k < fluid.points.size(); k += 2) {
        fluid.points[k] += 0.25;
    }
    EXPECT_THAT(refusal(coupledText(), fluid),
                AllOf(HasSubstr("m away"), HasSubstr("the limit is 0.01")));
}

TEST(CoupledRun, three_dimensional_interface_is_refused) {
    channel::Interface fluid;
    fluid.dimension = 3;
    fluid.points = {0, 0, 0, 0, 1, 0, 0, 1, 1};
    fluid.displacements.assign(9, 0);
    fluid.faceOffsets = {0, 3};
    fluid.facePoints = {0, 1, 2};
    fluid.tolerance = 1e-4;
    EXPECT_THAT(refusal(coupledText(), fluid), HasSubstr("has 3 dimensions"));
}

TEST(CoupledRun, interface_that_is_not_consistent_is_refused) {
    channel::Interface fluid = flapInterface(20);
    fluid.facePoints[3] = 1000;
    EXPECT_THAT(refusal(coupledText(), fluid), HasSubstr("a face has point 1000 of 42"));
    fluid = flapInterface(20);
    fluid.faceOffsets[1] = 0;
    EXPECT_THAT(refusal(coupledText(), fluid), HasSubstr("face 0 of the fluid's interface has no"));
}

namespace {

// What the fluid hears after its greeting.
std::string failureAtStart(const std::string& text) {
    const TemporaryDirectory directory;
    ScriptedFluid script(directory.write("case.yaml", text));
    const std::string told = script.failureText();
    EXPECT_THAT(told, HasSubstr(script.outcome()));
    return told;
}

} // namespace

TEST(CoupledRun, fluid_hears_of_a_mistake_in_the_case_file) {
    EXPECT_THAT(failureAtStart(coupledText("density", "densety")),
                HasSubstr("did you mean 'density'?"));
    EXPECT_THAT(failureAtStart(exampleText()), HasSubstr("entry 'coupling' is missing"));
}

namespace {

// A session in its first step, ready for forces.
class CoupledStep : public testing::Test {
  protected:
    CoupledStep() : script(directory.write("case.yaml", coupledText())) {
        script.start(fluid);
        script.begin(1, 0.01, 0.01);
    }
    TemporaryDirectory directory;
    channel::Interface fluid = flapInterface(20);
    ScriptedFluid script;
};

} // namespace

TEST_F(CoupledStep, force_that_is_not_finite_ends_both_sides_with_face_and_place) {
    std::vector<double> forces = forceOnLeft(fluid, 100);
    forces[2 * 3 + 1] = NAN;
    script.channel().send(channel::Forces{false, false, 0, forces});
    EXPECT_THAT(script.failureText(), HasSubstr("force on face 3 at (-0.05, 0.175) is not finite"));
    EXPECT_THAT(script.outcome(), HasSubstr("force on face 3 at (-0.05, 0.175) is not finite"));
}

TEST_F(CoupledStep, wrong_number_of_forces_ends_both_sides) {
    script.channel().send(channel::Forces{false, false, 0, {1, 2, 3}});
    EXPECT_THAT(script.failureText(), HasSubstr("3 force components for 41 faces"));
    script.outcome();
}

namespace {

// What the structure says of a step that a fluid should not begin.
std::string refusalOf(const channel::BeginStep& step) {
    const TemporaryDirectory directory;
    ScriptedFluid script(directory.write("case.yaml", coupledText()));
    script.start(flapInterface(20));
    script.channel().send(step);
    const std::string told = script.failureText();
    script.outcome();
    return told;
}

} // namespace

TEST(CoupledRun, step_that_does_not_begin_where_the_structure_is_ends_both_sides) {
    EXPECT_THAT(refusalOf({1, 0.03, 0.01}),
                HasSubstr("time step 1 begins at 0.02 s, but the structure is at 0 s"));
    EXPECT_THAT(refusalOf({1, -0.01, 0.01}), HasSubstr("but the structure is at 0 s"));
}

TEST(CoupledRun, step_without_a_length_or_a_time_ends_both_sides) {
    for (const channel::BeginStep& step :
         {channel::BeginStep{1, 0.01, 0}, channel::BeginStep{1, 0.01, -0.01},
          channel::BeginStep{1, 0.01, NAN}, channel::BeginStep{1, NAN, 0.01},
          channel::BeginStep{1, INFINITY, INFINITY}, channel::BeginStep{0xffffffffu, 0.01, 0.01}}) {
        EXPECT_THAT(refusalOf(step), HasSubstr("the fluid's time step"));
    }
}

TEST_F(CoupledStep, residual_of_the_fluid_that_is_none_ends_both_sides) {
    script.channel().send(channel::Forces{false, false, -1, forceOnLeft(fluid, 100)});
    EXPECT_THAT(script.failureText(), HasSubstr("the fluid's residual is -1"));
    script.outcome();
}

TEST_F(CoupledStep, second_run_in_the_same_folder_is_refused_with_process_and_host) {
    ScriptedFluid second(directory.file("case.yaml"));
    second.channel().send(fluid);
    EXPECT_THAT(second.failureText(),
                AllOf(HasSubstr("results' is in use: process " + std::to_string(getpid()) + " on "),
                      HasSubstr("choose another output.directory")));
    second.outcome();
    EXPECT_EQ(script.exchange(forceOnLeft(fluid, 100), true).state, State::accepted);
}

TEST_F(CoupledStep, lock_goes_with_the_run) {
    EXPECT_TRUE(std::filesystem::exists(directory.file("results/case.lock")));
    script.vanish();
    script.outcome();
    EXPECT_FALSE(std::filesystem::exists(directory.file("results")));
}

TEST(CoupledRun, lock_of_a_killed_run_is_reported_and_taken_over) {
    const TemporaryDirectory directory;
    std::filesystem::create_directory(directory.file("results"));
    directory.write("results/case.lock", "process 4711 on elsewhere");
    EXPECT_EQ(watchOfCoupledRun(directory, coupledText(), 20).size(), 10u);
    EXPECT_FALSE(std::filesystem::exists(directory.file("results")));
}

TEST_F(CoupledStep, fluid_that_vanishes_ends_the_structure_at_once) {
    EXPECT_LT(seconds([&] {
                  script.vanish();
                  EXPECT_THAT(script.outcome(),
                              HasSubstr("ended without saying why, while this side waited for the "
                                        "fluid's forces, step 1"));
              }),
              5);
}

TEST_F(CoupledStep, failure_of_the_fluid_ends_the_structure_with_its_reason) {
    script.channel().send(channel::Failure{"the flow has diverged"});
    EXPECT_THAT(script.outcome(), HasSubstr("the fluid ended: the flow has diverged"));
}

TEST_F(CoupledStep, message_out_of_turn_ends_both_sides) {
    script.channel().send(channel::BeginStep{2, 0.02, 0.01});
    EXPECT_THAT(script.failureText(), HasSubstr("BeginStep"));
    script.outcome();
}

TEST(CoupledRun, silent_fluid_is_reported_and_waited_for) {
    const TemporaryDirectory directory;
    const channel::Interface fluid = flapInterface(20);
    CoupledRunOptions options;
    options.silenceInterval = 0.5;
    ScriptedFluid script(directory.write("case.yaml", coupledText()), options);
    script.start(fluid);
    script.begin(1, 0.01, 0.01);
    std::this_thread::sleep_for(std::chrono::milliseconds(1500));
    EXPECT_THAT(script.log(), AllOf(HasSubstr("waiting for the fluid's forces since 1 s, step 1")));
    EXPECT_EQ(script.exchange(forceOnLeft(fluid, 100), true).state, State::accepted);
    script.sayGoodbye();
    EXPECT_EQ(script.outcome(), "");
}
