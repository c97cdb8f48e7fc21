// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/couplingOptionsSchema.hpp"

namespace tokay::structure {

using coupling::Acceleration;
using coupling::CouplingOptions;
using coupling::Extrapolation;
using coupling::QrFilter;

namespace {

using Row = EntryOf<CouplingOptions>;
using Rows = SchemaOf<CouplingOptions>;

const Choices<Acceleration, CouplingOptions>& accelerations() {
    static const Row initialRelaxation = {
        "initialRelaxation", &CouplingOptions::initialRelaxation, "(0, 2]", "",
        "Relaxation factor of a step about which nothing is known yet."};
    static const Row maxRank = {
        "maxRank", &CouplingOptions::largestRank, "[2, inf)", "",
        "Maximum rank of the Jacobian; beyond it, compressed to half by singular values."};
    static const Row rankLimit = {"rankLimit", &CouplingOptions::rankLimit, "[0, 1)", "",
                                  "Singular values below this fraction of the largest are dropped "
                                  "on compression."};
    static const Choices<QrFilter> filters = {
        {"qr1", QrFilter::qr1, "by the diagonal of R relative to its norm."},
        {"qr2", QrFilter::qr2,
         "by the part of a difference orthogonal to the newer ones relative to its length."}};
    static const Rows quasiNewton = {
        {"filter", &CouplingOptions::filter, filters, "Which differences count as dependent."},
        {"filterLimit", &CouplingOptions::filterLimit, "[0, 1)", "", "Limit of the filter."},
        {"signalToNoise", &CouplingOptions::signalToNoise, "[0, inf)", "",
         "A difference is used if its length relative to the displacement exceeds this multiple of "
         "the fluid's residual; 0: always."},
        {"maxStep", &CouplingOptions::largestStep, "[0, inf)", "",
         "Maximum length of a step in units of the residual; 0: unlimited."},
        {"keepFraction", &CouplingOptions::keepFraction, "[0, 1)", "",
         "At the end of a time step its differences below this fraction of its largest are "
         "dropped; 0: none."}};
    static const Choices<Acceleration, CouplingOptions> choices = {
        {"explicit", Acceleration::explicitCoupling, "one coupling iteration per time step.", {}},
        {"constant",
         Acceleration::constant,
         "constant relaxation.",
         {{"relaxation", &CouplingOptions::relaxation, "(0, 2]", "",
           "Relaxation factor: fraction of the residual that is added."}}},
        {"aitken",
         Acceleration::aitken,
         "dynamic relaxation.",
         {initialRelaxation,
          {"minRelaxation", &CouplingOptions::smallestRelaxation, "(0, 2]", "",
           "Minimum relaxation factor."},
          {"maxRelaxation", &CouplingOptions::largestRelaxation, "(0, inf)", "",
           "Maximum relaxation factor."}}},
        {"iqnIls", Acceleration::iqnIls, "interface quasi-Newton with inverse least squares.",
         Rows{initialRelaxation,
              {"reusedTimeSteps", &CouplingOptions::reusedTimeSteps, "[0, inf)", "",
               "Number of earlier time steps whose differences are used."},
              {"maxColumns", &CouplingOptions::largestColumns, "[1, inf)", "",
               "Maximum number of differences, the newest ones."}}
             .with(quasiNewton)},
        {"mvqn", Acceleration::mvqn,
         "multi-vector quasi-Newton, whose Jacobian is carried over time steps.",
         Rows{initialRelaxation, maxRank, rankLimit}.with(quasiNewton)},
        {"block",
         Acceleration::block,
         "multi-vector quasi-Newton for the fluid alone, combined with the structure's factored "
         "tangent.",
         {initialRelaxation,
          maxRank,
          rankLimit,
          {"filterLimit", &CouplingOptions::filterLimit, "[0, 1)", "",
           "Minimum noise of a difference relative to its length."},
          {"signalToNoise", &CouplingOptions::signalToNoise, "[0, inf)", "",
           "Noise by which differences are weighted, in units of the fluid's residual; 0: none."},
          {"fluidMemory", &CouplingOptions::fluidMemory, "[0, 1)", "",
           "Fraction of its last response that the fluid keeps from one coupling iteration to the "
           "next, for which the forces are corrected."},
          {"memoryContrast", &CouplingOptions::memoryContrast, "[0, inf)", "",
           "A difference is used if it exceeds this multiple of what the last one has left behind "
           "by the fluid's memory."}}}};
    return choices;
}

Rows accelerationSchema() {
    return {{"type", &CouplingOptions::acceleration, accelerations(), "Coupling method."}};
}

Rows convergenceSchema() {
    return {{"absoluteDisplacement", &CouplingOptions::absoluteDisplacement, "[0, inf)", "m",
             "A root-mean-square displacement residual below this is converged in any case."},
            {"relativeForce", &CouplingOptions::relativeForce, "[0, 1)", "",
             "Relative change of force between coupling iterations; not checked if both force "
             "entries are 0."},
            {"absoluteForce", &CouplingOptions::absoluteForce, "[0, inf)", "N (2D: N/m)",
             "A root-mean-square change of force below this is converged in any case."}};
}

} // namespace

const SchemaOf<CouplingOptions>& couplingOptionsSchema() {
    static const Choices<Extrapolation> extrapolations = {{"constant", Extrapolation::constant},
                                                          {"linear", Extrapolation::linear},
                                                          {"quadratic", Extrapolation::quadratic},
                                                          {"cubic", Extrapolation::cubic}};
    static const Rows schema = {
        {"predictor", &CouplingOptions::extrapolation, extrapolations,
         "Polynomial through accepted interface displacements that predicts that of a new time "
         "step."},
        {"acceleration", accelerationSchema(),
         "How the next interface displacement follows from the last coupling iterations."},
        {"convergence", convergenceSchema(),
         "Criteria besides the fluid's tolerance, which is the relative one of the displacement."}};
    return schema;
}

} // namespace tokay::structure
