// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tokay::coupling {

/// How the displacement for the next exchange follows from the last ones.
enum class Acceleration {
    explicitCoupling, ///< one exchange a step, nothing iterated
    constant,         ///< constant relaxation
    aitken,           ///< Aitken's dynamic relaxation
    iqnIls,           ///< interface quasi-Newton, least squares
    mvqn,             ///< interface quasi-Newton, multi-vector (IMVJ)
    block             ///< the fluid's response learned, the structure's known
};

/// Polynomial through the last accepted steps that starts the next one.
enum class Extrapolation { constant, linear, quadratic, cubic };

/// Which columns of the least-squares problem count as dependent, newest first.
enum class QrFilter {
    qr1, ///< diagonal entry of R below filterLimit x norm of R
    qr2  ///< part orthogonal to the newer columns below filterLimit x column
};

/// Everything the user may choose about the coupling, with its default.
/// Norms are root mean squares over all components.
struct CouplingOptions {
    Acceleration acceleration = Acceleration::block;
    Extrapolation extrapolation = Extrapolation::linear;

    // Relaxation
    double relaxation = 0.5;          ///< constant: share of the residual
    double initialRelaxation = 0.1;   ///< Aitken, quasi-Newton: share of the first move
    double smallestRelaxation = 0.01; ///< Aitken: bounds of its factor
    double largestRelaxation = 1.5;

    // Quasi-Newton
    int reusedTimeSteps = 15; ///< IQN-ILS: earlier steps whose columns are used
    int largestColumns = 30;  ///< IQN-ILS: columns kept at most, the newest
    int largestRank = 200;    ///< multi-vector: rank of the Jacobian that makes
                              ///< it restart with the half, by singular values
    double rankLimit = 1e-6;  ///< multi-vector: at a restart singular values
                              ///< below this share of the largest are dropped
    QrFilter filter = QrFilter::qr2;
    double filterLimit = 0.01;

    // Guards of quasi-Newton against a fluid that has not converged
    double signalToNoise = 3;   ///< column accepted if |Δx|/|xTilde| exceeds this
                                ///< many fluid residuals; 0: always. Block: that is
                                ///< the noise by which a difference is weighed
    double largestStep = 2;     ///< step at most this many |residual|; 0: any
    double keepFraction = 0.05; ///< at the end of a step columns below this share
                                ///< of its largest are dropped; 0: none

    // Guards of the block method
    double fluidMemory = 0;    ///< share of its last answer that the fluid keeps
                               ///< because it makes few correctors; 0: none
    double memoryContrast = 5; ///< difference accepted if it exceeds this many
                               ///< times what the last one left behind

    // Criteria besides the fluid's relative tolerance for the displacement
    double absoluteDisplacement = 0; ///< enough in any case [m]; 0: no floor
    double relativeForce = 0;        ///< change of force between exchanges; both
    double absoluteForce = 0;        ///< 0: force is not looked at [N or N/m]
};

/// @throws InputError that names the option, its value and what is allowed
void requireValid(const CouplingOptions& options);

} // namespace tokay::coupling
