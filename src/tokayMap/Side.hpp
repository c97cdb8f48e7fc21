// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/Discretisation.hpp"
#include "mapper/interface/SurfaceMesh.hpp"
#include "tokayMap/files/MeshFile.hpp"

#include <functional>
#include <memory>

namespace tokay::tool {

using ScalarFunction = std::function<double(const Point&)>;

/// Side of a mapping, as a file has it: a mesh or a spline model. Its values
/// are those of its discretisation; what is written are samples, the field at
/// samplePoints().
class Side {
  public:
    virtual ~Side() = default;

    /// Description for a person, in a line.
    virtual std::string description() const = 0;

    /// @throws InputError for an operator that needs values at points, if this
    /// side's are coefficients of splines
    virtual const mapper::Discretisation& discretisation() const = 0;
    virtual bool hasSplines() const = 0;

    virtual const Points& samplePoints() const = 0;
    /// @param values  nValues x m
    /// @return        samples x m
    virtual Eigen::MatrixXd sampled(const Eigen::MatrixXd& values) const = 0;

    /// Values that stand for a function: at vertices, at the centroids of faces,
    /// or its L2 projection onto splines.
    virtual Eigen::VectorXd valuesOf(const ScalarFunction& function) const = 0;

    /// @throws OutputError
    virtual void writeSamples(const std::string& path, const std::string& field,
                              const Eigen::MatrixXd& samples) const = 0;
    /// Forces, one a value: on vertices, faces or control points.
    /// @throws OutputError
    virtual void writeForces(const std::string& path, const std::string& field,
                             const Eigen::MatrixXd& forces) const = 0;
};

struct SideOptions {
    /// Lengths of the file times this are metres.
    double scale = 1;
    /// Location of the values of a mesh.
    mapper::ValuesAt valuesAt = mapper::ValuesAt::vertices;
    /// Refinement of a spline model: its basis is raised to at least this degree, and each
    /// knot span divided into so many.
    int degree = 1;
    int nDivisions = 1;
    /// Edges of a spline model, by name: the side is these, not the surface. Its values are
    /// those of all control points, its samples lie in the whole elements that they cut.
    std::vector<std::string> edges = {};
};

/// @throws InputError for broken meshes
std::unique_ptr<Side> meshSide(MeshFile mesh, const std::string& path, const SideOptions& options);

/// @throws InputError with file, line and key
std::unique_ptr<Side> splineSide(const std::string& path, const SideOptions& options);

} // namespace tokay::tool
