// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/errors.hpp"
#include "igaStructure/case/kinematicsTypes.hpp"
#include "igaStructure/case/makeBody.hpp"
#include "igaStructure/exampleCase.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

using namespace tokay;
using namespace tokay::structure;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using testing::AnyOf;
using testing::HasSubstr;

namespace {

struct Member {
    std::string kinematics, material, strains;
};

const Entry& entryOf(const Schema& schema, const std::string& name) {
    return *std::find_if(schema.entries.begin(), schema.entries.end(),
                         [&](const Entry& entry) { return entry.name == name; });
}

// The words that a kinematics' own schema offers for an entry of a section.
std::vector<std::string> wordsOf(const KinematicsType& kinematics, const std::string& section,
                                 const std::string& entry) {
    const auto body = kinematics.makeEntries();
    const auto slot = std::get<Section>(entryOf(*kinematics.schema, section).slot(body->entries()));
    std::vector<std::string> words;
    for (const Alternative& alternative : entryOf(*slot.schema, entry).alternatives) {
        words.push_back(alternative.name);
    }
    return words;
}

// All that the program's own lists offer, so that a new member is tested by being added.
std::vector<Member> members() {
    std::vector<Member> all;
    for (const KinematicsType& kinematics : kinematicsTypes()) {
        for (const std::string& material : wordsOf(kinematics, "material", "type")) {
            for (const std::string& strains : wordsOf(kinematics, "model", "strains")) {
                all.push_back({kinematics.name, material, strains});
            }
        }
    }
    return all;
}

// A small body of each kinematics: geometry, discretisation and the rest of `model`.
std::string shapeOf(const std::string& kinematics) {
    const std::string plane = "geometry: {rectangle: {origin: [0, 0], size: [1, 0.2]}}\n"
                              "discretisation: {degree: [2, 2], elements: [2, 1]}\n";
    const std::string line = "geometry: {line: {from: [0, 0], to: [0.6, 0.8]}}\n"
                             "discretisation: {degree: [3], elements: [3]}\n";
    const std::string surface =
        "geometry: {cylinder: {base: [0, 0, 0], radius: 1, height: 1, angles: [0, 60]}}\n";
    const std::map<std::string, std::string> shapes = {
        {"planeStrain", plane + "model: {"},
        {"planeStress", plane + "model: {thickness: 0.1, "},
        {"beam", line + "model: {thickness: 0.05, "},
        {"cable", line + "model: {thickness: 0.05, prestress: 1e3, "},
        {"shell", surface + "discretisation: {degree: [2, 2], elements: [2, 2]}\n"
                            "model: {thickness: 0.05, "},
        {"membrane", surface + "discretisation: {degree: [2, 2], elements: [2, 2]}\n"
                               "model: {thickness: 0.05, prestress: 1e3, "},
        {"solid", surface + "discretisation: {degree: [2, 2, 2], elements: [1, 1, 1]}\n"
                            "model: {thickness: 0.2, "}};
    return shapes.at(kinematics); // a new kinematics needs an example here
}

std::string textOf(const Member& member) {
    return shapeOf(member.kinematics) + "kinematics: " + member.kinematics +
           ", strains: " + member.strains + "}\nmaterial: {type: " + member.material +
           ", youngsModulus: 1e5, density: 1000" +
           (member.material == "incompressibleNeoHookean" ? "" : ", poissonsRatio: 0.3") +
           "}\nsupports: []\ntime: {step: 0.1, end: 1}\n";
}

VectorXd randomVector(Eigen::Index size, unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    VectorXd vector(size);
    for (double& value : vector) {
        value = uniform(generator);
    }
    return vector;
}

std::string lawOf(const std::string& material) {
    const std::map<std::string, std::string> names = {
        {"StVenantKirchhoff", "St. Venant-Kirchhoff"},
        {"neoHookean", "  neo-Hookean"},
        {"incompressibleNeoHookean", "incompressible neo-Hookean"}};
    return names.at(material);
}

bool isContinuum(const Member& member) {
    return member.kinematics != "beam" && member.kinematics != "cable";
}

class EachKinematics : public testing::TestWithParam<Member> {
  protected:
    /// Null for a material that the kinematics refuses, with a message that names it.
    std::unique_ptr<Body> body() const {
        try {
            return makeBody(readText(textOf(GetParam())));
        } catch (const InputError& error) {
            EXPECT_NE(GetParam().material, "StVenantKirchhoff") << error.what();
            EXPECT_THAT(error.what(),
                        AnyOf(HasSubstr(GetParam().material), HasSubstr("incompressible")));
            return nullptr;
        }
    }
};

} // namespace

TEST_P(EachKinematics, force_and_tangent_are_derivatives_of_the_energy) {
    const std::unique_ptr<Body> body = this->body();
    if (!body) {
        return;
    }
    const StructuralModel& model = body->model();
    const VectorXd d = 1e-2 * randomVector(model.nUnknowns(), 1);
    const VectorXd v = randomVector(model.nUnknowns(), 2);
    SparseMatrix tangent;
    const VectorXd force = model.internalForce(d, tangent).force;
    const double h = 1e-5; // of a body of size 1: the difference errs by h^2
    const VectorXd slope =
        (model.internalForce(d + h * v).force - model.internalForce(d - h * v).force) / (2 * h);
    EXPECT_LT((tangent * v - slope).norm(), 1e-6 * slope.norm());
    const double work = (model.strainEnergy(d + h * v) - model.strainEnergy(d - h * v)) / (2 * h);
    EXPECT_NEAR(force.dot(v), work, 1e-6 * force.norm() * v.norm());
}

TEST_P(EachKinematics, describes_its_material) {
    const std::unique_ptr<Body> body = this->body();
    if (body && isContinuum(GetParam())) {
        EXPECT_THAT(body->description(), HasSubstr(lawOf(GetParam().material)));
    }
}

TEST_P(EachKinematics, fields_are_finite_and_have_their_components) {
    const std::unique_ptr<Body> body = this->body();
    if (!body) {
        return;
    }
    MotionState state;
    state.displacement = 1e-2 * randomVector(body->model().nUnknowns(), 1);
    state.velocity = randomVector(body->model().nUnknowns(), 2);
    state.acceleration = randomVector(body->model().nUnknowns(), 3);
    std::set<std::string> names;
    for (const VtuMesh& mesh : body->meshes(OutputOptions())) {
        for (const BodyField& field : body->fields()) {
            const MatrixXd values = field.evaluate(state, mesh.points);
            EXPECT_EQ(values.rows(), field.nComponents) << field.name;
            EXPECT_EQ(values.cols(), static_cast<Eigen::Index>(mesh.points.size())) << field.name;
            EXPECT_TRUE(values.allFinite()) << field.name;
            if (GetParam().kinematics != "membrane" || field.name != "bendingMoment") {
                EXPECT_GT(values.norm(), 0) << field.name;
            }
            names.insert(field.name);
        }
    }
    EXPECT_EQ(names.size(), body->fields().size());
}

INSTANTIATE_TEST_SUITE_P(All, EachKinematics, testing::ValuesIn(members()),
                         [](const auto& example) {
                             return example.param.kinematics + "_" + example.param.material + "_" +
                                    example.param.strains;
                         });
