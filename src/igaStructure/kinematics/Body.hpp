// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/StructuralModel.hpp"
#include "igaStructure/kinematics/InterfaceTransfer.hpp"
#include "igaStructure/kinematics/OutputOptions.hpp"
#include "igaStructure/output/Location.hpp"
#include "igaStructure/output/VtuMesh.hpp"
#include "igaStructure/timeIntegration/MotionState.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace tokay::structure {

/// A field of result files.
struct BodyField {
    std::string name;
    std::string unit;
    int nComponents;
    bool isDefault; ///< written if the case file has no output.fields
    /// Values, nComponents x nLocations.
    std::function<Eigen::MatrixXd(const MotionState&, const std::vector<Location>&)> evaluate;
};

/// A structure as the program sees it: the equations that time integration
/// solves, and the body in space to which their unknowns belong. A kinematics
/// joins the program by one class derived from this.
class Body {
  public:
    Body(const Body&) = delete; // fields refer to their body
    Body& operator=(const Body&) = delete;
    virtual ~Body() = default;

    virtual StructuralModel& model() = 0;
    virtual const StructuralModel& model() const = 0;

    /// Dimension of the scene: 2 (the plane z = 0), or 3.
    virtual int dimension() const = 0;

    /// Kinematics, discretisation and material, for a person: indented lines.
    virtual std::string description() const = 0;

    /// Cells of result files, a mesh for each kind of cell.
    virtual std::vector<VtuMesh> meshes(const OutputOptions& options) const = 0;

    /// Fields that result files can have.
    const std::vector<BodyField>& fields() const { return fields_; }
    /// Fields to write: those of the names, or without names the default ones.
    /// @throws InputError for a name that no field has
    std::vector<BodyField> fields(const std::vector<std::string>& names) const;
    const BodyField& field(const std::string& name) const;

    /// Positions in the reference configuration, 3 x n [m].
    virtual Eigen::MatrixXd positions(const std::vector<Location>& locations) const = 0;

    /// Displacements of material points, 3 x n [m].
    virtual Eigen::MatrixXd displacements(const Eigen::VectorXd& displacement,
                                          const std::vector<Location>& locations) const = 0;

    /// A material point of the body near a point of space.
    struct Closest {
        Location location;
        double distance; ///< of the point to the body; 0 in a thin body's thickness [m]
    };
    virtual Closest closest(const geometry::Point& point) const = 0;

    /// Mass on a square metre of a fluid's interface [kg/m^2].
    virtual double massPerWetArea() const = 0;

    /// Thickness: the smallest of a thin body, the mean of another [m].
    virtual double thickness() const = 0;

    /// Remarks on the choice of this kinematics, each with its estimate.
    virtual std::vector<std::string> advice() const = 0;

    /// Wet part of the body; a thin one is wet all over.
    /// @param names  of edges or faces of a body that is not thin
    virtual WetSurface wetSurface(const std::vector<std::string>& names) const = 0;

    /// Edges at which another structure can be coupled, with the functions of the control
    /// points that do not vanish there.
    /// @param names  as the case file names them
    /// @throws InputError for a name that no edge has, and for a kinematics whose edges
    ///         cannot be coupled
    virtual std::unique_ptr<const mapper::CurveInterface>
    edges(const std::vector<std::string>& names) const;

    /// Transfer to and from a fluid's interface.
    /// @throws InputError if the two sides do not fit: names, gaps
    std::unique_ptr<InterfaceTransfer> transfer(const Coupling& coupling,
                                                const mapper::FaceMesh& fluid) const;

    /// Transfer to and from points of another structure's edge: displacements there, and
    /// forces [N].
    /// @param points  faces of one vertex each
    /// @throws InputError as edges(), and for gaps
    std::unique_ptr<InterfaceTransfer> edgeTransfer(const Coupling& coupling,
                                                    const mapper::FaceMesh& points) const;

  protected:
    /// With the fields of the motion: displacement, velocity and acceleration.
    Body();

    void add(BodyField field) { fields_.push_back(std::move(field)); }

  private:
    /// Depth across the plane of a 2D scene [m]; 1 in space.
    virtual double depth() const { return 1; }

    /// Velocities [m/s] and accelerations [m/s^2] of material points, 3 x n. By default
    /// displacements are linear in the unknowns.
    virtual Eigen::MatrixXd velocities(const MotionState& state,
                                       const std::vector<Location>& locations) const {
        return displacements(state.velocity, locations);
    }
    virtual Eigen::MatrixXd accelerations(const MotionState& state,
                                          const std::vector<Location>& locations) const {
        return displacements(state.acceleration, locations);
    }

    std::vector<BodyField> fields_;
};

} // namespace tokay::structure
