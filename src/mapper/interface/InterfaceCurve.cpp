// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/interface/InterfaceCurve.hpp"

#include "mapper/interface/normalSlopes.hpp"

namespace tokay::mapper {

namespace {

class SplineCurve : public InterfaceCurve {
  public:
    SplineCurve(const geometry::NurbsCurve& curve, std::vector<int> controlPoints)
        : curve_(curve), projector_(curve), controlPoints_(std::move(controlPoints)) {}

    const std::vector<double>& breakpoints() const override {
        return curve_.knotVector().breakpoints();
    }
    int degree() const override { return curve_.degree(); }
    Points derivatives(double xi, int n) const override { return curve_.derivatives(xi, n); }
    geometry::CurveProjection closest(const Point& point) const override {
        return projector_.closest(point);
    }
    Functions functions(double xi) const override {
        const geometry::CurveBasis basis = curve_.basis(xi, 0);
        const auto first = controlPoints_.begin() + basis.first;
        return {{first, first + basis.N.cols()}, basis.N.row(0)};
    }
    geometry::Box box() const override { return geometry::Box::around(curve_.controlPoints()); }

  private:
    geometry::NurbsCurve curve_;
    geometry::CurveProjector projector_;
    std::vector<int> controlPoints_;
};

class Cell : public InterfaceCurve {
  public:
    Cell(const geometry::NurbsCurve& line, int value) : curve_(line, {}), value_(value) {}

    const std::vector<double>& breakpoints() const override { return curve_.breakpoints(); }
    int degree() const override { return 0; }
    Points derivatives(double xi, int n) const override { return curve_.derivatives(xi, n); }
    geometry::CurveProjection closest(const Point& point) const override {
        return curve_.closest(point);
    }
    Functions functions(double) const override { return {{value_}, Eigen::VectorXd::Ones(1)}; }
    geometry::Box box() const override { return curve_.box(); }

  private:
    SplineCurve curve_;
    int value_;
};

class TrimmedEdge : public InterfaceCurve {
  public:
    TrimmedEdge(geometry::CurveOnSurface curve, std::vector<int> controlPoints)
        : curve_(std::move(curve)), controlPoints_(std::move(controlPoints)) {}

    const std::vector<double>& breakpoints() const override { return curve_.breakpoints(); }
    /// A curve through the parameter space mixes both directions.
    int degree() const override {
        const geometry::NurbsSurface& surface = curve_.surface();
        return curve_.parameterCurve().degree() *
               std::max(surface.u().degree(), surface.v().degree());
    }
    Points derivatives(double xi, int n) const override { return curve_.derivatives(xi, n); }
    geometry::CurveProjection closest(const Point& point) const override {
        return curve_.closest(point);
    }
    Functions functions(double xi) const override {
        const Point at = curve_.parameterCurve().point(xi);
        const geometry::SurfaceBasis basis = curve_.surface().basis(at[0], at[1], 0);
        return renumbered({basis.controlPoints, basis.N.row(0)});
    }
    Functions slope(double xi, const Point& direction) const override {
        const Point at = curve_.parameterCurve().point(xi);
        return renumbered(directionalDerivative(curve_.surface(), at[0], at[1], direction));
    }
    geometry::Box box() const override { return curve_.box(); }
    std::vector<NormalSlope> normalSlopes() const override {
        std::vector<NormalSlope> slopes = mapper::normalSlopes(curve_);
        for (NormalSlope& slope : slopes) {
            static_cast<Functions&>(slope) = renumbered(slope);
        }
        return slopes;
    }

  private:
    Functions renumbered(Functions functions) const {
        for (int& number : functions.values) {
            number = controlPoints_[number];
        }
        return functions;
    }

    geometry::CurveOnSurface curve_;
    std::vector<int> controlPoints_;
};

} // namespace

std::unique_ptr<InterfaceCurve> interfaceCurve(const geometry::NurbsCurve& curve,
                                               std::vector<int> controlPoints) {
    return std::make_unique<SplineCurve>(curve, std::move(controlPoints));
}

std::unique_ptr<InterfaceCurve> interfaceCell(const geometry::NurbsCurve& line, int value) {
    return std::make_unique<Cell>(line, value);
}

std::unique_ptr<InterfaceCurve> interfaceCurve(geometry::CurveOnSurface curve,
                                               std::vector<int> controlPoints) {
    return std::make_unique<TrimmedEdge>(std::move(curve), std::move(controlPoints));
}

} // namespace tokay::mapper
