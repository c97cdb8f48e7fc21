// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/couplingMethods.hpp"

#include "common/errors.hpp"
#include "coupling/block/BlockQuasiNewton.hpp"
#include "coupling/fixedPoint/Aitken.hpp"
#include "coupling/fixedPoint/ConstantRelaxation.hpp"
#include "coupling/fixedPoint/ExplicitCoupling.hpp"
#include "coupling/fixedPoint/FixedPoint.hpp"
#include "coupling/fixedPoint/IqnIls.hpp"
#include "coupling/fixedPoint/Mvqn.hpp"

#include <fmt/format.h>

#include <cassert>

namespace tokay::coupling {
namespace {

/// Own options of a method as entries of `acceleration`.
template <class Own>
SchemaOf<AccelerationOptions> entriesOf() {
    SchemaOf<AccelerationOptions> entries;
    static_cast<Schema&>(entries) = Own::schema().in([](void* options) -> void* {
        return &static_cast<AccelerationOptions*>(options)->of<Own>();
    });
    return entries;
}

template <class AcceleratorType>
CouplingMethodType accelerator(const char* name, const char* meaning) {
    using Own = typename AcceleratorType::Options;
    return {name, meaning, entriesOf<Own>(),
            [](const AccelerationOptions& options) { AcceleratorType(options.of<Own>()); },
            [](const CouplingOptions& options, double tolerance,
               CoupledStructure& structure) -> std::unique_ptr<CouplingMethod> {
                return std::make_unique<FixedPoint>(
                    options, tolerance, structure,
                    std::make_unique<AcceleratorType>(options.acceleration.of<Own>()));
            }};
}

CouplingMethodType block(const char* name, const char* meaning) {
    return {name, meaning, entriesOf<BlockQuasiNewton::Options>(), nullptr,
            [](const CouplingOptions& options, double tolerance,
               CoupledStructure& structure) -> std::unique_ptr<CouplingMethod> {
                assert(structure.linearised());
                return std::make_unique<BlockQuasiNewton>(options, tolerance,
                                                          *structure.linearised());
            }};
}

} // namespace

const std::vector<CouplingMethodType>& couplingMethods() {
    static const std::vector<CouplingMethodType> types = {
        accelerator<ExplicitCoupling>("explicit", "one coupling iteration per time step."),
        accelerator<ConstantRelaxation>("constant", "constant relaxation."),
        accelerator<Aitken>("aitken", "dynamic relaxation."),
        accelerator<IqnIls>("iqnIls", "interface quasi-Newton with inverse least squares."),
        accelerator<Mvqn>("mvqn",
                          "multi-vector quasi-Newton, whose Jacobian is carried over time steps."),
        block("block",
              "multi-vector quasi-Newton for the fluid alone, combined with the structure's "
              "factored tangent.")};
    return types;
}

namespace {

const CouplingMethodType& typeOf(const AccelerationOptions& options) {
    std::string names;
    for (const CouplingMethodType& type : couplingMethods()) {
        if (type.name == options.type) {
            return type;
        }
        names += (names.empty() ? "" : ", ") + type.name;
    }
    throw InputError(
        fmt::format("acceleration.type: there is no '{}'; allowed: {}", options.type, names));
}

SchemaOf<CouplingOptions> accelerationSchema() {
    static const Choices<std::string, AccelerationOptions> choices = [] {
        Choices<std::string, AccelerationOptions> all;
        for (const CouplingMethodType& type : couplingMethods()) {
            all.emplace_back(type.name, type.name, type.meaning, type.entries);
        }
        return all;
    }();
    return SchemaOf<CouplingOptions>().with(
        &CouplingOptions::acceleration,
        SchemaOf<AccelerationOptions>{
            {"type", &AccelerationOptions::type, choices, "Coupling method."}});
}

} // namespace

const SchemaOf<CouplingOptions>& couplingSchema() {
    static const SchemaOf<CouplingOptions> schema = {
        {"predictor", &CouplingOptions::predictor, extrapolations(),
         "Polynomial through accepted interface displacements that predicts that of a new time "
         "step."},
        {"acceleration", accelerationSchema(),
         "How the next interface displacement follows from the last coupling iterations."},
        {"convergence", &CouplingOptions::convergence,
         "Criteria besides the fluid's tolerance, which is the relative one of the displacement."}};
    return schema;
}

void requireValid(const CouplingOptions& options) {
    const CouplingMethodType& type = typeOf(options.acceleration);
    CouplingOptions checked = options;
    requireInRange(couplingSchema(), &checked);
    if (type.requireConsistent) {
        type.requireConsistent(options.acceleration);
    }
}

std::unique_ptr<CouplingMethod> makeCouplingMethod(const CouplingOptions& options, double tolerance,
                                                   CoupledStructure& structure) {
    requireValid(options);
    return typeOf(options.acceleration).make(options, tolerance, structure);
}

} // namespace tokay::coupling
