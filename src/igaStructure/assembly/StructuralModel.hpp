// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/errors.hpp"
#include "igaStructure/assembly/SparseMatrix.hpp"
#include "igaStructure/assembly/SupportLoad.hpp"

#include <Eigen/Core>

#include <vector>

namespace tokay::structure {

/// Equations of motion of a structure discretised in space. Vectors
/// have nUnknowns() entries: component c of control point k has index
/// nComponents() k + c. Matrices hold both triangles and all have one sparsity.
class StructuralModel {
  public:
    virtual ~StructuralModel() = default;

    virtual int nUnknowns() const = 0;
    virtual int nComponents() const = 0;

    /// Displacements of the control points along the axes: the unknowns, unless some
    /// stand for combinations of them.
    virtual Eigen::VectorXd controlDisplacements(const Eigen::VectorXd& unknowns) const {
        return unknowns;
    }

    /// Forces on the unknowns by forces on the control points: the transpose of
    /// controlDisplacements().
    virtual Eigen::VectorXd onUnknowns(const Eigen::VectorXd& onControlPoints) const {
        return onControlPoints;
    }

    /// True if internal forces are linear in the displacement.
    virtual bool isLinear() const = 0;

    /// Consistent mass matrix [kg].
    virtual SparseMatrix massMatrix() const = 0;

    /// Lumped mass matrix for explicit time integration [kg].
    /// @throws InputError if the kinematics has none
    virtual SparseMatrix lumpedMassMatrix() const {
        throw InputError("time.scheme: explicit is not possible with this kinematics, which has "
                         "no lumped mass; choose another scheme");
    }

    /// Rayleigh damping factors (mass [1/s], stiffness [s]).
    virtual double massDamping() const = 0;
    virtual double stiffnessDamping() const = 0;

    /// Internal forces [N] and their state.
    struct Internal {
        Eigen::VectorXd force;
        /// Smallest ratio of deformed and reference volume; a body turned
        /// inside out has one that is not positive.
        double smallestVolumeRatio = 1;
    };

    virtual Internal internalForce(const Eigen::VectorXd& displacement) const = 0;

    /// Also the exact derivative of the internal force.
    /// @param tangent  empty, or made by an earlier call: then only its values change
    virtual Internal internalForce(const Eigen::VectorXd& displacement,
                                   SparseMatrix& tangent) const = 0;

    /// The same with the tangent of the mixed integration point method, for an iteration
    /// that came here from another displacement: its stresses are not those of the
    /// displacement but those that the linearisation there predicts here. A thin body
    /// turns on circles, its linearisation moves along their tangents: the stretch of
    /// that vanishes in the next iteration, and with it stresses that would stiffen or
    /// soften the tangent by orders of magnitude. Without such stresses, or if the model
    /// does not know the method: the exact derivative.
    /// Source: Magisano, Leonetti & Garcea 2017
    virtual Internal mixedInternalForce(const Eigen::VectorXd& displacement,
                                        const Eigen::VectorXd& /*linearisedAt*/,
                                        SparseMatrix& tangent) const {
        return internalForce(displacement, tangent);
    }

    /// [J]
    virtual double strainEnergy(const Eigen::VectorXd& displacement) const = 0;

    /// The model's own loads at a time [N].
    virtual const Eigen::VectorXd& externalForce(double time) = 0;

    /// Adds loads that follow the displacement [N]; a linear model has none.
    virtual void addFollowerForce(const Eigen::VectorXd& /*displacement*/, double /*time*/,
                                  Eigen::VectorXd& /*force*/) const {}

    /// Subtracts the derivative of follower loads from a tangent.
    virtual void subtractFollowerDerivative(const Eigen::VectorXd& /*displacement*/,
                                            double /*time*/, SparseMatrix& /*tangent*/) const {}

    /// True if the tangent, derivatives of follower loads included, is symmetric but
    /// for rows and columns of fixed unknowns.
    virtual bool hasSymmetricTangent() const { return true; }

    /// Unknowns that no equilibrium decides: zero, unless they move as prescribed() or
    /// depend on others by extension().
    virtual const std::vector<bool>& fixed() const = 0;

    /// True if unknowns that fixed() marks move as prescribed() says.
    virtual bool hasPrescribedMotion() const { return false; }

    /// Displacement at a time of the unknowns that fixed() marks, 0 for the others [m]. The
    /// time scheme makes velocities and accelerations of it. Asked anew for each solution
    /// of a step, so it may change from one to the next.
    /// @throws InputError if it is not finite
    virtual Eigen::VectorXd prescribed(double /*time*/) const {
        return Eigen::VectorXd::Zero(nUnknowns());
    }

    /// True if unknowns that fixed() marks follow free ones, by extension() or from one
    /// solution of a step to the next.
    virtual bool hasDependents() const { return extension() != nullptr; }

    /// Tells the model a solution with the present prescribed(), which may follow it: the
    /// step is solved again until it returns true.
    /// @throws SolverError if it does not settle
    virtual bool settlePrescribed(const Eigen::VectorXd& /*displacement*/) { return true; }

    /// Matrix E, nUnknowns() square, of unknowns that depend on others: all of them are
    ///   u = E q + prescribed(t),
    /// q being the free ones. Its rows are those of the identity for free unknowns and
    /// combinations of free ones for dependent unknowns, which fixed() marks too; columns
    /// of unknowns that fixed() marks are empty. Equilibrium is asked for at the free
    /// unknowns only, so that the matrix to solve, the free rows of K E, is not symmetric
    /// (Petrov-Galerkin). None: fixed unknowns depend on no other.
    virtual const SparseMatrix* extension() const { return nullptr; }

    /// What the motion of supports that hold weakly adds to internal forces and strain
    /// energy, which are those of supports at rest without it.
    struct SupportShift {
        Eigen::VectorXd force; ///< whatever the displacement; empty: no such support [N]
        double energy = 0;     ///< beside force . displacement [J]
        double largest = 0;    ///< of their displacements [m]

        void addTo(Eigen::VectorXd& internal) const {
            if (force.size() > 0) {
                internal += force;
            }
        }
        double energyAt(const Eigen::VectorXd& displacement) const {
            return energy + (force.size() > 0 ? force.dot(displacement) : 0);
        }
    };
    virtual SupportShift supportShift(double /*time*/) const { return {}; }

    /// Names of the supports, in the order of the case file.
    virtual std::vector<std::string> supportNames() const { return {}; }

    /// What each support acts with on the body, at the current positions of a structure
    /// with nonlinear strains, else at the reference ones. What several hold counts for the first.
    /// @param reaction  of fixed unknowns (MotionState::reaction) [N]
    virtual std::vector<SupportLoad> supportLoads(const Eigen::VectorXd& /*displacement*/,
                                                  const Eigen::VectorXd& /*reaction*/,
                                                  double /*time*/) const {
        return {};
    }

    /// Tells the model what inertia adds to the stiffness in time steps to come: the mass
    /// matrix times a factor. Springs of weak supports and joints are stiff compared with the
    /// elements there, so they have to be stiff compared with these; else an edge gives way in
    /// short steps. Internal forces, strain energy and supportShift() change with it.
    /// @param massFactor  0: none, as at first [1/s^2]
    /// @return  false if there is no such spring, and nothing changes
    virtual bool resistInertia(double /*massFactor*/) { return false; }

    /// Motions without strain that the supports leave free, in words.
    virtual std::vector<std::string> freeRigidMotions() const = 0;

    /// Parts that neither a joint nor a support connects to anything else, in words: for
    /// a model of several patches.
    virtual std::vector<std::string> looseParts() const { return {}; }

    /// Largest extent [m].
    virtual double size() const = 0;
};

/// Derivative of the internal force at displacement zero [N/m].
inline SparseMatrix stiffnessAtRest(const StructuralModel& model) {
    SparseMatrix stiffness;
    model.internalForce(Eigen::VectorXd::Zero(model.nUnknowns()), stiffness);
    return stiffness;
}

/// Sets the components of fixed unknowns to zero.
/// @param fixed  as StructuralModel::fixed()
inline void setFixedToZero(const std::vector<bool>& fixed, Eigen::VectorXd& vector) {
    for (std::size_t k = 0; k < fixed.size(); ++k) {
        if (fixed[k]) {
            vector[static_cast<Eigen::Index>(k)] = 0;
        }
    }
}

/// The components of fixed unknowns; the others are zero.
/// @param fixed  as StructuralModel::fixed()
inline Eigen::VectorXd fixedPart(const std::vector<bool>& fixed, Eigen::VectorXd vector) {
    for (std::size_t k = 0; k < fixed.size(); ++k) {
        if (!fixed[k]) {
            vector[static_cast<Eigen::Index>(k)] = 0;
        }
    }
    return vector;
}

/// A vector of unknowns, or of their rates, whose free ones are given: dependent ones
/// follow from these, fixed ones are zero; what is prescribed is added to both.
/// @param prescribed  empty: nothing
inline Eigen::VectorXd asSupported(const StructuralModel& model, Eigen::VectorXd vector,
                                   const Eigen::VectorXd& prescribed) {
    if (const SparseMatrix* extension = model.extension()) {
        vector = *extension * vector;
    } else {
        setFixedToZero(model.fixed(), vector);
    }
    if (prescribed.size() > 0) {
        vector += prescribed;
    }
    return vector;
}

/// A displacement whose free unknowns are given, as supports have it at a time [m].
inline Eigen::VectorXd asSupported(const StructuralModel& model,
                                   const Eigen::VectorXd& displacement, double time) {
    return model.hasPrescribedMotion() || model.extension()
               ? asSupported(model, displacement, model.prescribed(time))
               : displacement;
}

} // namespace tokay::structure
