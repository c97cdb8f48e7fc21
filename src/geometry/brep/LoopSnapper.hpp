// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsSurface.hpp"

#include <optional>

namespace tokay::geometry {

/// Trimming curve of a file, and the index that edges call it by.
struct LoopCurve {
    NurbsCurve curve;
    std::optional<int> trimIndex;
};

/// Counts of what was corrected in a file.
struct SnapStatistics {
    int nMoved = 0;     ///< ends of curves, and curves moved onto the rim of the surface
    double largest = 0; ///< upper bound of the distances by which they were moved [m]
    int nSupplied = 0;  ///< curves along collapsed sides
};

/// Closes the loops of CAD files, which miss their joints and the rim of the
/// surface by the modeller's tolerance, and leave out the curve along a side that
/// is collapsed to a point. Without it such files are refused as open loops.
class LoopSnapper {
  public:
    /// Borrows the surface.
    /// @param tolerance  largest correction [m]; gaps of rounding are always closed
    LoopSnapper(const NurbsSurface& surface, double tolerance);

    /// Curves that start where the ones before them end, as far as the tolerance allows.
    std::vector<LoopCurve> snapped(std::vector<LoopCurve> curves);

    const SnapStatistics& statistics() const { return statistics_; }

  private:
    /// Side of the parameter rectangle: xi (axis 0) or eta (1) is value.
    struct Side {
        int axis;
        double value;
        bool isCollapsed;
    };
    void findSides();
    NurbsCurve onRim(const NurbsCurve& curve);
    std::vector<LoopCurve> withCollapsedSides(const std::vector<LoopCurve>& curves);
    std::optional<NurbsCurve> alongCollapsedSide(const Parameters& from, const Parameters& to);
    Parameters joint(const Parameters& end, const Parameters& start) const;
    void count(const Parameters& moved);
    double distance(const Parameters& step) const { return step.cwiseProduct(speed_).norm(); }

    const NurbsSurface& surface_;
    double tolerance_;
    /// Largest lengths of the tangents [m], and the parameters that the tolerance is.
    Parameters speed_, slack_;
    ParameterBox box_;
    std::vector<Side> sides_;
    SnapStatistics statistics_;
};

} // namespace tokay::geometry
