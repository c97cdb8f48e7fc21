// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/coupledRun/wetCoverage.hpp"

#include "common/errors.hpp"
#include "geometry/projection/BoxTree.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tokay::structure {

using geometry::Box;
using geometry::BoxTree;
using geometry::Point;
using mapper::FaceMesh;

namespace {

constexpr int samplesPerSpan = 4;
constexpr double unreachedFraction = 0.05;

/// A place of the wet surface that stands for the part of it around it.
struct WetSample {
    Point point;
    Point normal; ///< of unit length
    double size;  ///< [m, m^2]
    int part;
};

struct SampledSurface {
    std::vector<WetPart> parts;
    std::vector<WetSample> samples;

    void add(const Point& point, const Point& normal, double size) {
        samples.push_back({point, normal.normalized(), size, static_cast<int>(parts.size()) - 1});
        parts.back().size += size;
    }
};

SampledSurface sampled(const mapper::SplineInterface& wet) {
    SampledSurface result;
    for (const mapper::SplinePiece& piece : wet.pieces()) {
        result.parts.push_back({piece.name});
        const std::vector<double>& breaks = piece.curve.knotVector().breakpoints();
        for (std::size_t span = 0; span + 1 < breaks.size(); ++span) {
            const double step = (breaks[span + 1] - breaks[span]) / samplesPerSpan;
            for (int i = 0; i < samplesPerSpan; ++i) {
                const geometry::Points at =
                    piece.curve.derivatives(breaks[span] + (i + 0.5) * step, 1);
                const Point tangent = at.row(1);
                result.add(at.row(0), Point::UnitZ().cross(tangent), tangent.norm() * step);
            }
        }
    }
    return result;
}

void addElement(SampledSurface& result, const geometry::TrimmedPatch& patch, int element) {
    const geometry::ParameterBox box = patch.elementBox(element);
    const geometry::Parameters step = box.size() / samplesPerSpan;
    for (int i = 0; i < samplesPerSpan; ++i) {
        for (int j = 0; j < samplesPerSpan; ++j) {
            const geometry::Parameters at(box.lower.x() + (i + 0.5) * step.x(),
                                          box.lower.y() + (j + 0.5) * step.y());
            if (patch.state(element) == geometry::ElementState::full || patch.contains(at)) {
                const geometry::Points d = patch.surface().derivatives(at.x(), at.y(), 1);
                const Point alongXi = d.row(1), alongEta = d.row(2);
                const Point normal = alongXi.cross(alongEta);
                result.add(d.row(0), normal, normal.norm() * step.prod());
            }
        }
    }
}

SampledSurface sampled(const mapper::SurfaceInterface& wet) {
    SampledSurface result;
    for (int i = 0; i < wet.nPieces(); ++i) {
        result.parts.push_back({wet.piece(i).name});
        const geometry::TrimmedPatch& patch = wet.piece(i).patch;
        for (int element = 0; element < patch.nElements(); ++element) {
            if (patch.state(element) != geometry::ElementState::empty) {
                addElement(result, patch, element);
            }
        }
    }
    return result;
}

/// How far from a chord its arc may be, over the radius of a face: four chords around a
/// circle have 0.41.
constexpr double sagitta = 0.6;

const mapper::Discretisation& discretisation(const WetSurface& wet) {
    return std::visit([](const auto& one) -> const mapper::Discretisation& { return one; }, wet);
}

std::vector<double> gapsOf(const mapper::Discretisation& wet, const geometry::Points& points) {
    std::vector<double> gaps;
    for (const auto& point : points.rowwise()) {
        gaps.push_back(wet.locate(point).gap);
    }
    return gaps;
}

/// A face of the fluid, and how far its corners are from the wet surface.
struct FaceGap {
    Point centre = Point::Zero();
    double ofCorners = 0; ///< of the farthest one [m]
    double radius = 0;    ///< of the face around its centre [m]

    /// Distance at which the surface still belongs to the face [m].
    double reach() const { return ofCorners + sagitta * radius; }
};

FaceGap faceGap(const FaceMesh& fluid, const std::vector<int>& face,
                const std::vector<double>& gaps) {
    FaceGap result;
    for (const int corner : face) {
        result.centre += fluid.vertices.row(corner) / static_cast<double>(face.size());
        result.ofCorners = std::max(result.ofCorners, gaps[corner]);
    }
    for (const int corner : face) {
        const Point toCorner = fluid.vertices.row(corner).transpose() - result.centre;
        result.radius = std::max(result.radius, toCorner.norm());
    }
    return result;
}

/// An edge, or a triangle of a face in space.
struct Facet {
    std::vector<Point> corners;
    int part;
    double reach; ///< [m]
};

/// Whether the normal through a sample meets a facet within reach; on the rim it does.
/// Along the normals of facets, wedges between them would be left out where the body is
/// curved and its surface lies at a distance from them.
bool isBefore(const Facet& facet, const WetSample& sample) {
    constexpr double rim = 1e-9;
    const Point a = facet.corners[1] - facet.corners[0];
    const Point b = facet.corners.size() == 2 ? Point(Point::UnitZ())
                                              : Point(facet.corners[2] - facet.corners[0]);
    const Point across = a.cross(b);
    const double slope = across.dot(sample.normal);
    const Point toSample = sample.point - facet.corners[0];
    const double distance = -across.dot(toSample) / slope;
    if (!(std::abs(distance) <= facet.reach)) { // not a number where they are parallel
        return false;
    }
    const Point at = toSample + distance * sample.normal;
    const double s = at.cross(b).dot(across) / across.squaredNorm();
    const double t = facet.corners.size() == 2 ? 0 : a.cross(at).dot(across) / across.squaredNorm();
    return s >= -rim && t >= -rim && s + t <= 1 + rim;
}

int partAt(const Point& centre, const SampledSurface& wet, const BoxTree& tree) {
    int nearest = 0;
    double smallest = std::numeric_limits<double>::infinity();
    tree.visitNearest(centre, [&](int i) {
        const double squared = (wet.samples[i].point - centre).squaredNorm();
        if (squared < smallest) {
            smallest = squared;
            nearest = i;
        }
        return smallest;
    });
    return wet.samples[nearest].part;
}

std::vector<Facet> facetsOf(const FaceMesh& fluid, const SampledSurface& wet,
                            const std::vector<double>& gaps) {
    std::vector<Box> boxes;
    for (const WetSample& sample : wet.samples) {
        boxes.push_back({sample.point, sample.point});
    }
    const BoxTree tree(boxes);
    std::vector<Facet> facets;
    for (const std::vector<int>& face : fluid.faces) {
        const std::size_t nCorners = face.size();
        const FaceGap gap = faceGap(fluid, face, gaps);
        const int part = partAt(gap.centre, wet, tree);
        for (std::size_t k = 0; k < nCorners; ++k) {
            const Point corner = fluid.vertices.row(face[k]);
            const Point next = fluid.vertices.row(face[(k + 1) % nCorners]);
            if (nCorners > 2) {
                facets.push_back({{gap.centre, corner, next}, part, gap.reach()});
            } else if (k == 0 && nCorners == 2) {
                facets.push_back({{corner, next}, part, gap.reach()});
            }
        }
    }
    return facets;
}

std::vector<Box> boxesOf(const std::vector<Facet>& facets) {
    std::vector<Box> boxes;
    for (const Facet& facet : facets) {
        Box box = Box::empty();
        for (const Point& corner : facet.corners) {
            box.include(corner);
        }
        boxes.push_back(box);
    }
    return boxes;
}

class FluidFaces {
  public:
    explicit FluidFaces(std::vector<Facet> facets)
        : facets_(std::move(facets)), tree_(boxesOf(facets_)) {
        for (const Facet& facet : facets_) {
            reach_ = std::max(reach_, facet.reach);
        }
    }

    /// Whether a facet of the sample's part lies before it.
    bool reach(const WetSample& sample) const {
        bool isReached = false;
        tree_.visitNearest(sample.point, [&](int i) {
            isReached =
                isReached || (facets_[i].part == sample.part && isBefore(facets_[i], sample));
            return isReached ? -1 : reach_ * reach_;
        });
        return isReached;
    }

  private:
    std::vector<Facet> facets_;
    BoxTree tree_;
    double reach_ = 0; ///< of any facet [m]
};

bool isUnreached(const WetPart& part) {
    return part.size - part.reached > unreachedFraction * part.size;
}

} // namespace

std::vector<WetPart> wetCoverage(const WetSurface& wet, const FaceMesh& fluid) {
    SampledSurface surface = std::visit([](const auto& one) { return sampled(one); }, wet);
    const FluidFaces faces(facetsOf(fluid, surface, gapsOf(discretisation(wet), fluid.vertices)));
    for (const WetSample& sample : surface.samples) {
        if (faces.reach(sample)) {
            surface.parts[sample.part].reached += sample.size;
        }
    }
    return surface.parts;
}

void requireFacesOnBody(const WetSurface& wet, const FaceMesh& fluid) {
    const mapper::Discretisation& surface = discretisation(wet);
    const std::vector<double> gaps = gapsOf(surface, fluid.vertices);
    int nStray = 0;
    std::string first;
    for (const std::vector<int>& face : fluid.faces) {
        const FaceGap gap = faceGap(fluid, face, gaps);
        const double ofCentre = surface.locate(gap.centre).gap;
        if (ofCentre > gap.reach() && ++nStray == 1) {
            first = fmt::format("({:.6g}, {:.6g}, {:.6g}) is {:.3g} m from the wet parts, its "
                                "corners at most {:.3g} m",
                                gap.centre.x(), gap.centre.y(), gap.centre.z(), ofCentre,
                                gap.ofCorners);
        }
    }
    if (nStray > 0) {
        throw InputError(fmt::format(
            "{} of {} faces of the fluid lie on a part of the structure that is not wet: the face "
            "at {}; add that part to coupling.interface, or take the patch out of the entry "
            "'patches' of the function object",
            nStray, fluid.nFaces(), first));
    }
}

std::string describeUnreached(const std::vector<WetPart>& parts) {
    std::string text;
    for (const WetPart& part : parts) {
        if (isUnreached(part)) {
            text += fmt::format("  {}: no face of the fluid lies before {:.0f} % of it\n",
                                part.name, 100 * (1 - part.reached / part.size));
        }
    }
    return text;
}

void requireReached(const std::vector<WetPart>& parts) {
    const std::string unreached = describeUnreached(parts);
    if (!unreached.empty()) {
        throw InputError(
            "wet parts of the structure that the fluid's patches do not reach, so that no "
            "force acts there:\n" +
            unreached +
            "couple the patch that lies there, take the part out of coupling.interface, or "
            "accept it by coupling.unreached: accept");
    }
}

} // namespace tokay::structure
