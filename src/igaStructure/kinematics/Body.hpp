// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/StructuralModel.hpp"
#include "igaStructure/kinematics/InterfaceTransfer.hpp"
#include "igaStructure/kinematics/OutputOptions.hpp"
#include "igaStructure/output/Place.hpp"
#include "igaStructure/output/VtuMesh.hpp"
#include "igaStructure/timeIntegration/MotionState.hpp"

#include <memory>
#include <string>
#include <vector>

namespace tokay::structure {

struct Coupling;

/// A structure as the program sees it: the equations that time integration
/// solves, and the body in space to which their unknowns belong. A kinematics
/// joins the program by one class derived from this.
class Body {
  public:
    virtual ~Body() = default;

    virtual StructuralModel& model() = 0;
    virtual const StructuralModel& model() const = 0;

    /// Of the scene: 2 (the plane z = 0), or 3.
    virtual int dimension() const = 0;

    /// Kinematics, discretisation and material, for a person: indented lines.
    virtual std::string description() const = 0;

    /// Cells of result files, a mesh for each kind of cell.
    virtual std::vector<VtuMesh> meshes(const OutputOptions& options) const = 0;

    /// Fields that result files can have.
    virtual std::vector<std::string> fieldNames() const = 0;
    /// Those that they have if the case file does not say.
    virtual std::vector<std::string> defaultFields() const = 0;

    /// In the reference configuration, 3 x n [m].
    virtual Eigen::MatrixXd positions(const std::vector<Place>& places) const = 0;

    /// Displacements of material points, 3 x n [m].
    virtual Eigen::MatrixXd displacements(const Eigen::VectorXd& displacement,
                                          const std::vector<Place>& places) const = 0;

    /// Values of a field, a column a place.
    /// @param name  one of fieldNames()
    virtual Eigen::MatrixXd field(const std::string& name, const MotionState& state,
                                  const std::vector<Place>& places) const = 0;

    /// A material point of the body near a point of space.
    struct Closest {
        Place place;
        double distance; ///< of the point to the body; 0 in a thin body's thickness [m]
    };
    virtual Closest closest(const geometry::Point& point) const = 0;

    /// Mass on a square metre of a fluid's interface [kg/m^2].
    virtual double massPerWetArea() const = 0;

    /// Least of a thin body, mean of another [m].
    virtual double thickness() const = 0;

    /// What in the choice of this kinematics may matter, with its estimate.
    virtual std::vector<std::string> advice() const = 0;

    /// @param points  of the fluid's interface, nPoints x 3 [m]
    /// @throws InputError if the two sides do not fit: names, gaps
    virtual std::unique_ptr<InterfaceTransfer> transfer(const Coupling& coupling,
                                                        const geometry::Points& points) const = 0;
};

} // namespace tokay::structure
